#include "widgets/window/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

namespace widgets {
namespace {

struct Colors {
    QColor window, base, alternate, text, dimmed, button, highlight, onHighlight, tooltip, link;
    QColor good, warning, bad;  ///< backgrounds of verdicts
    QColor onVerdict;
    QColor error;  ///< text of refusals
};

Colors colorsOf(Theme theme) {
    if (theme == Theme::Dark) {
        return {QColor(0x2a, 0x2d, 0x33), QColor(0x1f, 0x22, 0x27), QColor(0x26, 0x29, 0x2f),
                QColor(0xe4, 0xe6, 0xea), QColor(0x8e, 0x95, 0xa1), QColor(0x38, 0x3c, 0x44),
                QColor(0x3d, 0x8b, 0xd9), QColor(0xff, 0xff, 0xff), QColor(0x3a, 0x3f, 0x48),
                QColor(0x6c, 0xb2, 0xf2), QColor(0x1e, 0x6b, 0x4c), QColor(0x8a, 0x57, 0x0c),
                QColor(0x96, 0x2d, 0x22), QColor(0xff, 0xff, 0xff), QColor(0xff, 0x8a, 0x78)};
    }
    return {QColor(0xf1, 0xf2, 0xf4), QColor(0xff, 0xff, 0xff), QColor(0xf6, 0xf7, 0xf9),
            QColor(0x1d, 0x20, 0x26), QColor(0x72, 0x79, 0x85), QColor(0xe7, 0xe9, 0xed),
            QColor(0x1f, 0x6f, 0xb8), QColor(0xff, 0xff, 0xff), QColor(0xff, 0xff, 0xf0),
            QColor(0x1f, 0x6f, 0xb8), QColor(0xcf, 0xec, 0xdd), QColor(0xfb, 0xe3, 0xbb),
            QColor(0xf8, 0xd2, 0xcc), QColor(0x1d, 0x20, 0x26), QColor(0xb3, 0x26, 0x1e)};
}

QPalette paletteOf(const Colors& c) {
    QPalette palette;
    palette.setColor(QPalette::Window, c.window);
    palette.setColor(QPalette::WindowText, c.text);
    palette.setColor(QPalette::Base, c.base);
    palette.setColor(QPalette::AlternateBase, c.alternate);
    palette.setColor(QPalette::Text, c.text);
    palette.setColor(QPalette::Button, c.button);
    palette.setColor(QPalette::ButtonText, c.text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::Highlight, c.highlight);
    palette.setColor(QPalette::HighlightedText, c.onHighlight);
    palette.setColor(QPalette::ToolTipBase, c.tooltip);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::PlaceholderText, c.dimmed);
    palette.setColor(QPalette::Link, c.link);
    palette.setColor(QPalette::LinkVisited, c.link);
    palette.setColor(QPalette::Light, c.button.lighter(115));
    palette.setColor(QPalette::Midlight, c.button.lighter(107));
    palette.setColor(QPalette::Mid, c.button.darker(125));
    palette.setColor(QPalette::Dark, c.button.darker(160));
    palette.setColor(QPalette::Shadow, c.button.darker(220));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, c.dimmed);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.button.darker(115));
    return palette;
}

/// Fusion with boxes to tick that can be seen on a dark ground (its own are outlined in a darker
/// tone than the window's), buttons of dialogs that are alike, narrower tabs,
/// and flat tool bars.
class StudioStyle : public QProxyStyle {
  public:
    StudioStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* returned) const override {
        // Only some of a dialog's buttons have a picture.
        return hint == SH_DialogButtonBox_ButtonsHaveIcons
                   ? 0
                   : QProxyStyle::styleHint(hint, option, widget, returned);
    }

    QRect subElementRect(SubElement element, const QStyleOption* option,
                         const QWidget* widget) const override {
        // Of the whole item: beside a picture it would tint the text's half only.
        return element == SE_ItemViewItemFocusRect
                   ? option->rect
                   : QProxyStyle::subElementRect(element, option, widget);
    }

    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        if (element != CE_ToolBar) {
            QProxyStyle::drawControl(element, option, painter, widget);
            return;
        }
        // Without the white edge that is to look like light from above: it glares on a dark ground.
        painter->fillRect(option->rect, option->palette.window());
        QColor edge = option->palette.color(QPalette::WindowText);
        edge.setAlphaF(0.15F);
        const QRect rect = option->rect;
        painter->fillRect(QRect(rect.left(), rect.bottom(), rect.width(), 1), edge);
    }

    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override {
        // With all panels open their titles fit side by side on a small screen.
        constexpr int kTabSpace = 14;
        return metric == PM_TabBarTabHSpace ? kTabSpace
                                            : QProxyStyle::pixelMetric(metric, option, widget);
    }

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return;
        }
        const bool enabled = option->state.testFlag(State_Enabled);
        const bool some = option->state.testFlag(State_NoChange);
        const bool on = some || option->state.testFlag(State_On);
        const QPalette& palette = option->palette;
        const QPalette::ColorGroup group = enabled ? QPalette::Active : QPalette::Disabled;
        const QColor fill = palette.color(group, on ? QPalette::Highlight : QPalette::Base);
        const bool under =
            option->state.testFlag(State_Selected) && element == PE_IndicatorItemViewItemCheck;
        const QColor line = under ? palette.color(QPalette::HighlightedText)
                            : on  ? fill
                                  : palette.color(group, QPalette::PlaceholderText);
        const double side = std::min({option->rect.width(), option->rect.height(), 14}) - 1.0;
        QRectF box(0.0, 0.0, side, side);
        box.moveCenter(QRectF(option->rect).center());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const bool focus = option->state.testFlag(State_HasFocus);
        painter->setPen(QPen(focus ? palette.color(QPalette::Text) : line, 1.0));
        painter->setBrush(fill);
        painter->drawRoundedRect(box, 2.0, 2.0);
        painter->setPen(QPen(palette.color(group, QPalette::HighlightedText), 1.8, Qt::SolidLine,
                             Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(Qt::NoBrush);
        const auto at = [&box](double x, double y) {
            return box.topLeft() + QPointF(x * box.width(), y * box.height());
        };
        if (some) {
            painter->drawLine(at(0.25, 0.5), at(0.75, 0.5));
        } else if (on) {
            painter->drawPolyline(QPolygonF({at(0.22, 0.52), at(0.42, 0.72), at(0.78, 0.28)}));
        }
        painter->restore();
    }
};

}  // namespace

void applyTheme(QApplication& application, Theme theme) {
    const Colors c = colorsOf(theme);
    application.setStyle(new StudioStyle);
    application.setPalette(paletteOf(c));
    application.setStyleSheet(
        QString("QLabel#headline, QLabel#staticsVerdict, QLabel#compareVerdict, "
                "QLabel#advisorVerdict { border-radius: 4px; padding: 6px 8px; "
                "font-weight: bold; }"
                "QLabel[level=\"good\"] { background: %1; color: %4; }"
                "QLabel[level=\"warning\"] { background: %2; color: %4; }"
                "QLabel[level=\"bad\"] { background: %3; color: %4; }"
                "QLabel#errorMessage { color: %5; }"
                "QToolTip { color: %6; background: %7; border: 1px solid %8; }"
                "QPushButton:checked { background: %9; color: white; border-radius: 3px; "
                "padding: 3px 6px; }"
                "QTreeView::item { padding: 2px 0; }"
                "QToolButton#wheelToggle { text-align: left; border: none; padding: 2px 4px; }"
                "QToolButton#wheelToggle:hover { background: %8; border-radius: 3px; }"
                "QMainWindow::separator { width: 5px; height: 5px; }")
            .arg(c.good.name(), c.warning.name(), c.bad.name(), c.onVerdict.name(), c.error.name(),
                 c.text.name(), c.tooltip.name(), c.dimmed.name(), c.highlight.name()));
}

}  // namespace widgets
