#include "widgets/panels/advice_text.h"

#include <QCoreApplication>

#include "widgets/panels/mobility_text.h"

namespace widgets {

using simcore::mobility::Advice;
using simcore::mobility::AdviceEnd;
using simcore::mobility::JointChange;
using simcore::mobility::Proposal;
using simcore::project::Sides;

namespace {

QString say(const char* text) {
    return QCoreApplication::translate("widgets::AdvisorPage", text);
}

/// With a true minus sign.
QString countText(int n) {
    return n < 0 ? QString(QChar(0x2212)) + QString::number(-n) : QString::number(n);
}

QString fromTo(const char* name, int from, int to) {
    return QString("%1 %2 → <b>%3</b>").arg(say(name), countText(from), countText(to));
}

}  // namespace

QString changeText(const JointChange& change) {
    QString text =
        change.wheel >= 0
            ? say(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "%1: held → free sideways"))
                  .arg(elementText(change.element))
            : QString("%1: %2 → %3")
                  .arg(QString::fromStdString(change.element), QString::fromStdString(change.from),
                       QString::fromStdString(change.to));
    switch (change.sides) {
        case Sides::Left:
            return say(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "%1 (left only)")).arg(text);
        case Sides::Right:
            return say(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "%1 (right only)")).arg(text);
        case Sides::Both:
            break;
    }
    return text;
}

QString proposalCounts(const Advice& advice, const Proposal& proposal) {
    const auto& built = advice.built;
    const auto& then = proposal.report;
    return QStringList{
        fromTo(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "Grübler"), built.gruebler, then.gruebler),
        fromTo(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "rank"), built.rank, then.rank),
        fromTo(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "redundant"), built.redundant,
               then.redundant),
        fromTo(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "idle"),
               static_cast<int>(built.idle.size()), static_cast<int>(then.idle.size()))}
        .join(", ");
}

QString adviceHeadline(const Advice& advice) {
    if (advice.alreadyExact) {
        return say(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "Exact as built"));
    }
    const auto count = static_cast<int>(advice.proposals.size());
    if (count == 1) {
        return say(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "1 exact set of joints"));
    }
    if (count > 1) {
        return say(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "%1 exact sets of joints")).arg(count);
    }
    switch (advice.end) {
        case AdviceEnd::TimeUp:
            return say(
                QT_TRANSLATE_NOOP("widgets::AdvisorPage", "Nothing found in the time given"));
        case AdviceEnd::Cancelled:
            return say(
                QT_TRANSLATE_NOOP("widgets::AdvisorPage", "Cancelled before anything was found"));
        case AdviceEnd::Complete:
            break;
    }
    return say(QT_TRANSLATE_NOOP("widgets::AdvisorPage", "There is no exact set of joints"));
}

QString adviceLevel(const Advice& advice) {
    return advice.alreadyExact || !advice.proposals.empty() ? "good" : "warning";
}

}  // namespace widgets
