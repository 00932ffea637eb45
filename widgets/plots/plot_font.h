#pragma once

#include <qcustomplot.h>

namespace widgets {

/// Numbers and labels of the axes in this font: the plotting library takes one once.
inline void setPlotFont(QCustomPlot& plot, const QFont& font) {
    plot.setFont(font);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setTickLabelFont(font);
        axis->setLabelFont(font);
    }
}

}  // namespace widgets
