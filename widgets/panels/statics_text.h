#pragma once

#include <QString>
#include <string>

#include "widgets/session/statics_worker.h"

/// What statics finds, in sentences.
namespace widgets {

/// Of a flag of a study; empty for one that only tells how it was found.
QString flagSentence(const std::string& flag);

/// Why there is nothing to look at.
QString failureSentence(const StaticsFindings& failure);

/// What the whole way asks for, or where it ends.
QString waySentence(const StaticsFindings& whole);

/// Which wheel needs the friction required.
QString limitSentence(const simcore::statics::Study& study);

/// What equal torques take; empty when none hold the rover.
QString equalSentence(const simcore::statics::Study& study);

/// A number with a true minus sign.
QString numberText(double value, int digits);

}  // namespace widgets
