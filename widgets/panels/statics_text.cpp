#include "widgets/panels/statics_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

namespace widgets {

using simcore::statics::Standing;
using simcore::statics::TraverseEnd;

namespace {

/// Less is shown as none [-].
constexpr double kNoFriction = 0.005;

QString tr(const char* text) {
    return QCoreApplication::translate("widgets::StaticsPanel", text);
}

QString standingReason(Standing why) {
    switch (why) {
        case Standing::NoGround:
            return tr("there is no ground under it");
        case Standing::Tips:
            return tr("it tips over");
        case Standing::LoopOpens:
            return tr("its joints cannot follow");
        case Standing::NotConverged:
        case Standing::Stands:
            break;
    }
    return tr("it comes to no rest");
}

}  // namespace

QString flagSentence(const std::string& flag) {
    struct Sentence {
        const char* flag;
        const char* text;
    };

    static constexpr std::array<Sentence, 8> kSentences{{
        {"hanging", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "%1 hangs in the air.")},
        {"lifting", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "%1 is about to lift.")},
        {"torque-limit",
         QT_TRANSLATE_NOOP("widgets::StaticsPanel", "%1 has its motor at its torque limit.")},
        {"touching", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "%1 touches the ground.")},
        {"stop", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "%1 is at its stop.")},
        {"no-torques-hold-it",
         QT_TRANSLATE_NOOP("widgets::StaticsPanel", "No torques hold the rover here.")},
        {"no-equal-torque",
         QT_TRANSLATE_NOOP("widgets::StaticsPanel", "No equal torque holds the rover here.")},
        {"equal-torque-lifts-a-wheel",
         QT_TRANSLATE_NOOP("widgets::StaticsPanel",
                           "With equal torques a wheel would have to pull on the ground.")},
    }};
    const std::size_t blank = std::min(flag.find(' '), flag.size());
    const std::string kind = flag.substr(0, blank);
    for (const Sentence& sentence : kSentences) {
        if (kind == sentence.flag) {
            const QString text = tr(sentence.text);
            return blank < flag.size() ? text.arg(QString::fromStdString(flag.substr(blank + 1)))
                                       : text;
        }
    }
    return {};
}

QString failureSentence(const StaticsFindings& failure) {
    for (const simcore::Problem& problem : failure.problems) {
        if (problem.severity == simcore::Severity::Critical) {
            return tr("The rover cannot be studied here. %1: %2. %3")
                .arg(QString::fromStdString(problem.element),
                     QString::fromStdString(problem.reason),
                     QString::fromStdString(problem.remedy));
        }
    }
    return tr("The rover cannot stand at the start of this scenario: %1.")
        .arg(standingReason(failure.traverse.why));
}

QString waySentence(const StaticsFindings& whole) {
    const simcore::statics::Traverse& traverse = whole.traverse;
    const double end = traverse.samples.back().way;
    switch (traverse.end) {
        case TraverseEnd::NoPose:
            return tr("The way ends after %1 m: %2.")
                .arg(numberText(end, 2), standingReason(traverse.why));
        case TraverseEnd::Stuck:
            return tr("The way ends after %1 m: the wheels roll on, the rover does not.")
                .arg(numberText(end, 2));
        case TraverseEnd::Arrived:
        case TraverseEnd::Stopped:
            break;
    }
    const double friction = traverse.frictionRequired();
    return std::isfinite(friction) ? tr("The whole way takes μ* %1.").arg(numberText(friction, 2))
                                   : tr("No friction is enough for the whole way.");
}

QString limitSentence(const simcore::statics::Study& study) {
    const std::vector<int> limiting = limitingWheels(study);
    const auto touching = std::count_if(study.wheels.begin(), study.wheels.end(),
                                        [](const auto& wheel) { return wheel.touches; });
    if (study.frictionRequired < kNoFriction) {
        return tr("No wheel needs friction here.");
    }
    if (static_cast<long>(limiting.size()) == touching) {
        return tr("All wheels that touch limit alike.");
    }
    QStringList names;
    for (const int wheel : limiting) {
        names << QString::fromStdString(study.wheels[static_cast<std::size_t>(wheel)].name);
    }
    return names.size() == 1 ? tr("%1 limits.").arg(names.front())
                             : tr("%1 limit.").arg(names.join(", "));
}

QString equalSentence(const simcore::statics::Study& study) {
    if (!study.equalTorque) {
        return {};
    }
    const QString torque = numberText(*study.equalTorque, 2);
    return std::isfinite(study.equalMaxRatio) ? tr("Equal torques: %1 N·m each, μ %2.")
                                                    .arg(torque, numberText(study.equalMaxRatio, 2))
                                              : tr("Equal torques: %1 N·m each.").arg(torque);
}

QString numberText(double value, int digits) {
    // Half a last digit and less is zero, without a sign.
    const double shown = std::abs(value) < 0.5 * std::pow(10.0, -digits) ? 0.0 : value;
    const QString text = QString::number(shown, 'f', digits);
    return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

}  // namespace widgets
