#pragma once

#include <QString>

#include "simcore/experiment/verdict.h"

/// What comes of two runs, in sentences.
namespace widgets {

/// How good a verdict is as an answer: what its colour says.
enum class VerdictLevel { Good, Warning, Bad };

struct VerdictText {
    VerdictLevel level = VerdictLevel::Good;
    QString headline;  ///< "Hybrid slips less: 12 against 20 mm"
    QString details;   ///< the other measures, or why they cannot be compared
};

/// @param names  of the two runs' controllers
VerdictText verdictText(const simcore::experiment::Outcome& first,
                        const simcore::experiment::Outcome& second,
                        const simcore::experiment::Verdict& verdict, const QString& firstName,
                        const QString& secondName);

/// "completed", "stuck", ... as a run ended, or "driving".
QString endText(const simcore::experiment::Outcome& outcome);

}  // namespace widgets
