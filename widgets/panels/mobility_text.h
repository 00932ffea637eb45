#pragma once

#include <QString>

#include "simcore/mobility/mobility.h"

namespace widgets {

/// The verdict in words: what simcore::mobility::describe() says, in the user's language.
QString mobilityVerdict(const simcore::mobility::Report& report);

}  // namespace widgets
