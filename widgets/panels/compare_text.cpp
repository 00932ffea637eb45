#include "widgets/panels/compare_text.h"

#include <QStringList>

#include "simcore/run/simulation.h"
#include "widgets/panels/compare_panel.h"
#include "widgets/panels/statics_text.h"

namespace widgets {

using simcore::experiment::Less;
using simcore::experiment::Outcome;
using simcore::experiment::Verdict;
using simcore::run::StopReason;

namespace {

/// "Energy: Hybrid 12 % less (40.1 against 45.6 J)".
QString measureText(const QString& what, const Verdict::Measure& measure, double first,
                    double second, const QString& unit, const QString& firstName,
                    const QString& secondName) {
    if (measure.less == Less::Neither) {
        return ComparePanel::tr("%1: no difference.").arg(what);
    }
    const bool isFirst = measure.less == Less::First;
    const double less = isFirst ? first : second;
    const double more = isFirst ? second : first;
    return ComparePanel::tr("%1: %2 has %3 % less (%4 against %5 %6).")
        .arg(what, isFirst ? firstName : secondName)
        .arg(100.0 * (1.0 - less / more), 0, 'f', 0)
        .arg(numberText(less, 1), numberText(more, 1), unit);
}

}  // namespace

VerdictText verdictText(const Outcome& first, const Outcome& second, const Verdict& verdict,
                        const QString& firstName, const QString& secondName) {
    VerdictText text;
    if (verdict.failed != Less::Neither) {
        const bool firstFailed = verdict.failed == Less::First;
        text.level = VerdictLevel::Bad;
        text.headline =
            ComparePanel::tr("Only %1 gets there").arg(firstFailed ? secondName : firstName);
        text.details =
            ComparePanel::tr("%1: %2. A run that fails has no slip to compare.")
                .arg(firstFailed ? firstName : secondName, endText(firstFailed ? first : second));
        return text;
    }
    if (!verdict.bothCompleted) {
        text.level = VerdictLevel::Bad;
        text.headline = ComparePanel::tr("Neither gets there");
        text.details = ComparePanel::tr("%1: %2. %3: %4.")
                           .arg(firstName, endText(first), secondName, endText(second));
        return text;
    }
    if (!verdict.sameWay) {
        text.level = VerdictLevel::Warning;
        text.headline = ComparePanel::tr("They did not drive the same way");
        text.details =
            ComparePanel::tr("Their ends are %1 m apart; below 0.1 m slip could be compared.")
                .arg(numberText(verdict.apart, 2));
        return text;
    }
    if (verdict.slip.less == Less::Neither) {
        text.headline = ComparePanel::tr("Both slip alike");
    } else {
        const bool isFirst = verdict.slip.less == Less::First;
        const double less = isFirst ? first.slipAbs : second.slipAbs;
        const double more = isFirst ? second.slipAbs : first.slipAbs;
        text.headline = ComparePanel::tr("%1 slips less: %2 against %3 mm")
                            .arg(isFirst ? firstName : secondName, numberText(1e3 * less, 0),
                                 numberText(1e3 * more, 0));
    }
    text.details =
        QStringList{
            measureText(ComparePanel::tr("Loaded slip"), verdict.loadedSlip, 1e3 * first.slipLoaded,
                        1e3 * second.slipLoaded, ComparePanel::tr("mm"), firstName, secondName),
            measureText(ComparePanel::tr("Energy"), verdict.energy, first.energy, second.energy,
                        ComparePanel::tr("J"), firstName, secondName)}
            .join('\n');
    return text;
}

QString endText(const Outcome& outcome) {
    const auto is = [&](StopReason reason) { return outcome.stopReason == toString(reason); };
    if (outcome.completed) {
        return ComparePanel::tr("completed");
    }
    if (is(StopReason::TimeUp)) {
        return ComparePanel::tr("time is up");
    }
    if (is(StopReason::Stuck)) {
        return ComparePanel::tr("stuck");
    }
    if (is(StopReason::Stopped)) {
        return ComparePanel::tr("stopped");
    }
    if (is(StopReason::Running)) {
        return ComparePanel::tr("driving");
    }
    return ComparePanel::tr("failed");
}

}  // namespace widgets
