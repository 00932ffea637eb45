#include "widgets/panels/mobility_text.h"

#include <QStringList>

#include "widgets/panels/mobility_panel.h"

namespace widgets {

QString mobilityVerdict(const simcore::mobility::Report& report) {
    QStringList text;
    if (report.mobility == 0) {
        text << MobilityPanel::tr("Cannot move: the constraints hold every body.");
    } else if (report.mobility == 1) {
        text << MobilityPanel::tr("Moves with one freedom, as a rover on its wheels should.");
    } else {
        text << MobilityPanel::tr("Moves with %1 freedoms.").arg(report.mobility);
    }
    if (report.redundant == 1) {
        text << MobilityPanel::tr(
            "Hyperstatic: 1 constraint repeats what others already hold. Its reaction cannot be "
            "told from statics, and inaccurate parts strain each other.");
    } else if (report.redundant > 1) {
        text << MobilityPanel::tr(
                    "Hyperstatic: %1 constraints repeat what others already hold. Their reactions "
                    "cannot be told from statics, and inaccurate parts strain each other.")
                    .arg(report.redundant);
    } else {
        text << MobilityPanel::tr("Statically determinate: every reaction follows from the loads.");
    }
    if (report.gruebler != report.mobility) {
        text << MobilityPanel::tr("The Grübler count (%1) cannot see this.")
                    .arg(QString::number(report.gruebler).replace('-', QChar(0x2212)));
    }
    if (report.idle.size() == 1) {
        text << MobilityPanel::tr("1 of the freedoms is idle: neither chassis nor wheels move.");
    } else if (report.idle.size() > 1) {
        text << MobilityPanel::tr("%1 of the freedoms are idle: neither chassis nor wheels move.")
                    .arg(report.idle.size());
    }
    return text.join(' ');
}

QString partVerdict(const simcore::mobility::Part& part, const simcore::mobility::Report& report) {
    QStringList text;
    if (part.pieces > 1) {
        text << MobilityPanel::tr("%1 pieces that no joint connects.").arg(part.pieces);
    }
    QStringList held;
    for (const std::string& body : part.heldBodies()) {
        held << QString::fromStdString(body);
    }
    if (report.mobility == 0) {
        text << (held.isEmpty()
                     ? MobilityPanel::tr("Nothing in it moves.")
                     : MobilityPanel::tr("With %1 held nothing in it moves.").arg(held.join(", ")));
    } else if (held.isEmpty()) {
        text << (report.mobility == 1
                     ? MobilityPanel::tr("It moves with 1 freedom.")
                     : MobilityPanel::tr("It moves with %1 freedoms.").arg(report.mobility));
    } else {
        text << (report.mobility == 1 ? MobilityPanel::tr("With %1 held it moves with 1 freedom.")
                                            .arg(held.join(", "))
                                      : MobilityPanel::tr("With %1 held it moves with %2 freedoms.")
                                            .arg(held.join(", "))
                                            .arg(report.mobility));
    }
    if (report.redundant == 1) {
        text << MobilityPanel::tr("1 of its constraints repeats what its others already hold.");
    } else if (report.redundant > 1) {
        text << MobilityPanel::tr("%1 of its constraints repeat what its others already hold.")
                    .arg(report.redundant);
    } else {
        text << MobilityPanel::tr("Nothing in it is redundant.");
    }
    return text.join(' ');
}

QString reactionsVerdict(const std::vector<simcore::mobility::ReactionDeterminacy>& reactions) {
    using simcore::mobility::Determinacy;
    int components = 0, known = 0;
    QStringList none;
    for (const auto& reaction : reactions) {
        components += reaction.components;
        known += static_cast<int>(reaction.determined.size());
        if (reaction.determinacy == Determinacy::None) {
            none << elementText(reaction.element);
        }
    }
    if (known == components) {
        return MobilityPanel::tr("Every reaction follows from the loads.");
    }
    QString text = MobilityPanel::tr(
                       "Of %1 components of reactions the loads determine %2. The "
                       "others cannot be known: they depend on play, stiffness and "
                       "errors of manufacture.")
                       .arg(components)
                       .arg(known);
    constexpr qsizetype kNamed = 4;  // more is a list, not a sentence
    if (!none.isEmpty()) {
        text += ' ' + (none.size() <= kNamed
                           ? MobilityPanel::tr("Nothing is known of %1.").arg(none.join(", "))
                           : MobilityPanel::tr("Nothing is known of %1 and %2 more.")
                                 .arg(none.mid(0, kNamed).join(", "))
                                 .arg(none.size() - kNamed));
    }
    return text;
}

QString elementText(const std::string& element) {
    const std::string wheel = simcore::mobility::wheelOfContact(element);
    return wheel.empty() ? QString::fromStdString(element)
                         : MobilityPanel::tr("contact %1").arg(QString::fromStdString(wheel));
}

QString signedNumber(int n) {
    return n < 0 ? QString(QChar(0x2212)) + QString::number(-n)
                 : (n > 0 ? "+" : "") + QString::number(n);
}

}  // namespace widgets
