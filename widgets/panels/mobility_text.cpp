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
        text << MobilityPanel::tr("The Grübler count (%1) cannot see this.").arg(report.gruebler);
    }
    if (report.idle.size() == 1) {
        text << MobilityPanel::tr("1 of the freedoms is idle: neither chassis nor wheels move.");
    } else if (report.idle.size() > 1) {
        text << MobilityPanel::tr("%1 of the freedoms are idle: neither chassis nor wheels move.")
                    .arg(report.idle.size());
    }
    return text.join(' ');
}

}  // namespace widgets
