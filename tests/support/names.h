#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressDialog>
#include <QScrollBar>
#include <QSizeGrip>
#include <QSplitterHandle>
#include <QTabBar>
#include <QToolBar>
#include <string>
#include <vector>

/// What a screen reader is told of widgets, and whether tests and scripts can find them.
namespace testsupport {

/// A part of one of Qt's own widgets: nobody but Qt names it.
inline bool isPartOfQt(const QWidget* widget) {
    if (qobject_cast<const QScrollBar*>(widget) != nullptr ||
        qobject_cast<const QSplitterHandle*>(widget) != nullptr ||
        qobject_cast<const QSizeGrip*>(widget) != nullptr ||
        qobject_cast<const QHeaderView*>(widget) != nullptr ||
        widget->inherits("QTableCornerButton") || widget->objectName().startsWith("qt_")) {
        return true;
    }
    for (const QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget()) {
        // Also views of combo boxes, editors of spin boxes, scroll buttons of tab bars.
        if (qobject_cast<const QComboBox*>(up) != nullptr ||
            qobject_cast<const QAbstractSpinBox*>(up) != nullptr ||
            qobject_cast<const QLineEdit*>(up) != nullptr ||
            qobject_cast<const QTabBar*>(up) != nullptr ||
            qobject_cast<const QHeaderView*>(up) != nullptr ||
            qobject_cast<const QFileDialog*>(up) != nullptr ||
            qobject_cast<const QMessageBox*>(up) != nullptr ||
            qobject_cast<const QProgressDialog*>(up) != nullptr) {
            return true;
        }
        const auto* area = qobject_cast<const QAbstractScrollArea*>(up);
        if (area != nullptr && widget == area->viewport()) {
            return true;
        }
    }
    return false;
}

inline bool isInteractive(const QWidget* widget) {
    return widget->focusPolicy() != Qt::NoFocus ||
           qobject_cast<const QAbstractButton*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QLineEdit*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(widget) != nullptr;
}

inline bool isToldToReaders(const QWidget* widget, const QWidget* root) {
    if (!widget->accessibleName().isEmpty()) {
        return true;
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget);
        button != nullptr && !button->text().isEmpty()) {
        return true;
    }
    // Tabs are told by their titles.
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
        return tabs->count() > 0;
    }
    for (const QLabel* label : root->findChildren<QLabel*>()) {
        if (label->buddy() == widget && !label->text().isEmpty()) {
            return true;
        }
    }
    return false;
}

/// Interactive widgets below `root` that readers cannot tell, or that have no object name.
inline std::vector<std::string> unnamedWidgets(QWidget* root) {
    std::vector<std::string> found;
    QList<QWidget*> widgets = root->findChildren<QWidget*>();
    for (const QWidget* widget : widgets) {
        if (!isInteractive(widget) || isPartOfQt(widget)) {
            continue;
        }
        const bool told = isToldToReaders(widget, root);
        // Buttons of the tool bar are those of actions, which have names.
        const bool ofAction = qobject_cast<QToolBar*>(widget->parentWidget()) != nullptr;
        // Qt makes the bar of tabbed docks itself.
        const bool ofDocks = qobject_cast<const QTabBar*>(widget) != nullptr;
        const bool named = !widget->objectName().isEmpty() || ofAction || ofDocks;
        if (told && named) {
            continue;
        }
        std::string text = widget->metaObject()->className();
        text += " '" + widget->objectName().toStdString() + "'";
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            text += " \"" + button->text().toStdString() + "\"";
        }
        for (const QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget()) {
            text += std::string(" < ") + up->metaObject()->className() + " '" +
                    up->objectName().toStdString() + "'";
        }
        found.push_back(text + (told ? " has no object name" : " is not told to readers"));
    }
    return found;
}

}  // namespace testsupport
