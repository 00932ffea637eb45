#pragma once

#include <QString>

#include "simcore/mobility/reactions.h"
#include "simcore/mobility/selection.h"

namespace widgets {

/// The verdict in words: what simcore::mobility::describe() says, in the user's language.
QString mobilityVerdict(const simcore::mobility::Report& report);
/// The same of a part of the rover.
QString partVerdict(const simcore::mobility::Part& part, const simcore::mobility::Report& report);
/// The same of reactions: what of them cannot be known.
QString reactionsVerdict(const std::vector<simcore::mobility::ReactionDeterminacy>& reactions);

/// A joint or gear by its name, a wheel's contact as "contact front".
QString elementText(const std::string& element);

/// A number with a true minus sign, and a plus where the sign matters.
QString signedNumber(int n);

}  // namespace widgets
