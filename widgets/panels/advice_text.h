#pragma once

#include <QString>

#include "simcore/mobility/advisor.h"

namespace widgets {

/// "fork_c: pin → ball": what a proposal changes, for people.
QString changeText(const simcore::mobility::JointChange& change);
/// The counts as built and with the proposal as the relaxed model.
QString proposalCounts(const simcore::mobility::Advice& advice,
                       const simcore::mobility::Proposal& proposal);
/// A few words: how many sets were found, or why none.
QString adviceHeadline(const simcore::mobility::Advice& advice);
/// "good", "warning": how the headline is coloured.
QString adviceLevel(const simcore::mobility::Advice& advice);

}  // namespace widgets
