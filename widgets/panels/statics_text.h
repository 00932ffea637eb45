#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "widgets/session/statics_worker.h"

/// What statics finds, in sentences.
namespace widgets {

/// Of the flags of a study that say more than how it was found.
QStringList flagSentences(const std::vector<std::string>& flags);

/// Why there is nothing to look at.
QString failureSentence(const StaticsFindings& failure);

/// What the whole way asks for, or where it ends.
QString waySentence(const StaticsFindings& whole);

/// Which wheel needs the friction required.
QString limitSentence(const simcore::statics::Study& study);

/// What equal torques take; empty when none hold the rover.
QString equalSentence(const simcore::statics::Study& study);

/// "μ* 0.41".
QString frictionText(double friction);

/// A number with a true minus sign.
QString numberText(double value, int digits);

}  // namespace widgets
