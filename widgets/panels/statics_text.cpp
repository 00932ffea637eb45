#include "widgets/panels/statics_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "widgets/panels/statics_panel.h"

namespace widgets {

using simcore::statics::Standing;
using simcore::statics::TraverseEnd;

namespace {

/// Less is shown as none [-].
constexpr double kNoFriction = 0.005;

/// No ground gives more [-].
constexpr double kMostFriction = 10.0;

QString standingReason(Standing why) {
    switch (why) {
        case Standing::NoGround:
            return StaticsPanel::tr("there is no ground under it");
        case Standing::Tips:
            return StaticsPanel::tr("it tips over");
        case Standing::LoopOpens:
            return StaticsPanel::tr("its joints cannot follow");
        case Standing::NotConverged:
        case Standing::Stands:
            break;
    }
    return StaticsPanel::tr("it comes to no rest");
}

}  // namespace

QStringList flagSentences(const std::vector<std::string>& flags) {
    struct Sentence {
        const char* flag;
        const char* text;
    };

    static constexpr std::array<Sentence, 8> kSentences{{
        {"no-torques-hold-it",
         QT_TRANSLATE_NOOP("widgets::StaticsPanel", "No torques hold the rover here.")},
        {"hanging", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "Hangs in the air: %1.")},
        {"lifting", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "About to lift: %1.")},
        {"torque-limit", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "At the torque limit: %1.")},
        {"touching", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "Touches the ground: %1.")},
        {"stop", QT_TRANSLATE_NOOP("widgets::StaticsPanel", "At its stop: %1.")},
        {"no-equal-torque",
         QT_TRANSLATE_NOOP("widgets::StaticsPanel", "No equal torque holds the rover here.")},
        {"equal-torque-lifts-a-wheel",
         QT_TRANSLATE_NOOP("widgets::StaticsPanel",
                           "With equal torques a wheel would have to pull on the ground.")},
    }};
    std::map<std::string, QStringList> named;
    for (const std::string& flag : flags) {
        const std::size_t blank = std::min(flag.find(' '), flag.size());
        QStringList& names = named[flag.substr(0, blank)];
        if (blank < flag.size()) {
            names << QString::fromStdString(flag.substr(blank + 1));
        }
    }
    QStringList sentences;
    for (const Sentence& sentence : kSentences) {
        if (const auto found = named.find(sentence.flag); found != named.end()) {
            const QString text = StaticsPanel::tr(sentence.text);
            sentences << (found->second.isEmpty() ? text : text.arg(found->second.join(", ")));
        }
    }
    return sentences;
}

QString failureSentence(const StaticsFindings& failure) {
    for (const simcore::Problem& problem : failure.problems) {
        if (problem.severity == simcore::Severity::Critical) {
            return StaticsPanel::tr("The rover cannot be studied here.\n\n%1: %2\n%3")
                .arg(QString::fromStdString(problem.element),
                     QString::fromStdString(problem.reason),
                     QString::fromStdString(problem.remedy));
        }
    }
    return StaticsPanel::tr("The rover cannot stand at the start of this scenario: %1.")
        .arg(standingReason(failure.traverse.why));
}

QString waySentence(const StaticsFindings& whole) {
    const simcore::statics::Traverse& traverse = whole.traverse;
    const double end = traverse.samples.back().way;
    switch (traverse.end) {
        case TraverseEnd::NoPose:
            return StaticsPanel::tr("The way ends after %1 m: %2.")
                .arg(numberText(end, 2), standingReason(traverse.why));
        case TraverseEnd::Stuck:
            return StaticsPanel::tr(
                       "The way ends after %1 m: the wheels roll on, the rover does not.")
                .arg(numberText(end, 2));
        case TraverseEnd::Arrived:
        case TraverseEnd::Stopped:
            break;
    }
    const double friction = traverse.frictionRequired();
    return friction <= kMostFriction
               ? StaticsPanel::tr("The whole way takes %1.").arg(frictionText(friction))
               : StaticsPanel::tr("No friction is enough for the whole way.");
}

QString limitSentence(const simcore::statics::Study& study) {
    if (study.frictionRequired < kNoFriction) {
        return StaticsPanel::tr("No wheel needs friction here.");
    }
    const std::vector<int> limiting = limitingWheels(study);
    QStringList names;
    QStringList others;
    for (std::size_t i = 0; i < study.wheels.size(); ++i) {
        const bool limits =
            std::find(limiting.begin(), limiting.end(), static_cast<int>(i)) != limiting.end();
        if (study.wheels[i].touches) {
            (limits ? names : others) << QString::fromStdString(study.wheels[i].name);
        }
    }
    if (others.isEmpty()) {
        return StaticsPanel::tr("All wheels that touch limit alike.");
    }
    if (names.size() > others.size()) {
        return StaticsPanel::tr("All wheels that touch limit alike but %1.").arg(others.join(", "));
    }
    return names.size() == 1 ? StaticsPanel::tr("%1 limits.").arg(names.front())
                             : StaticsPanel::tr("%1 limit.").arg(names.join(", "));
}

QString equalSentence(const simcore::statics::Study& study) {
    if (!study.equalTorque) {
        return {};
    }
    const QString torque = numberText(*study.equalTorque, 2);
    return study.equalMaxRatio <= kMostFriction
               ? StaticsPanel::tr("Equal torques: %1 N·m each, μ %2.")
                     .arg(torque, numberText(study.equalMaxRatio, 2))
               : StaticsPanel::tr("Equal torques: %1 N·m each, no friction is enough.").arg(torque);
}

QString frictionText(double friction) {
    return friction <= kMostFriction
               ? StaticsPanel::tr("μ* %1").arg(numberText(friction, 2))
               : StaticsPanel::tr("μ* > %1").arg(numberText(kMostFriction, 0));
}

QString numberText(double value, int digits) {
    // Half a last digit and less is zero, without a sign.
    const double shown = std::abs(value) < 0.5 * std::pow(10.0, -digits) ? 0.0 : value;
    const QString text = QString::number(shown, 'f', digits);
    return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

}  // namespace widgets
