#include "widgets/window/action_registry.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <utility>

namespace widgets {

QAction* ActionRegistry::add(const QString& name, const QString& text,
                             const QList<QKeySequence>& shortcuts, const QString& tip) {
    auto* action = new QAction(text, this);
    action->setShortcuts(shortcuts);
    if (!tip.isEmpty()) {
        action->setToolTip(tip);
        action->setStatusTip(tip);
    }
    return adopt(name, action);
}

QAction* ActionRegistry::add(const QString& name, const QString& text,
                             const QList<QKeySequence>& shortcuts, const QString& tip,
                             std::function<void()> slot) {
    QAction* action = add(name, text, shortcuts, tip);
    connect(action, &QAction::triggered, this, [slot = std::move(slot)] { slot(); });
    return action;
}

QAction* ActionRegistry::adopt(const QString& name, QAction* action) {
    action->setObjectName(name);
    actions_[name] = action;
    order_.push_back(action);
    return action;
}

void showShortcuts(const ActionRegistry& actions, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setWindowTitle(ActionRegistry::tr("Keyboard shortcuts"));
    auto* list = new QTreeWidget;
    list->setObjectName("shortcutList");
    list->setColumnCount(2);
    list->setHeaderLabels({ActionRegistry::tr("Action"), ActionRegistry::tr("Keys")});
    list->setRootIsDecorated(false);
    list->setAlternatingRowColors(true);
    list->setAccessibleName(dialog.windowTitle());
    for (const QAction* action : actions.all()) {
        if (!action->shortcuts().isEmpty()) {
            new QTreeWidgetItem(
                list, {action->text().remove('&'),
                       QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText)});
        }
    }
    const auto mouse = [&](const QString& what, const QString& how) {
        new QTreeWidgetItem(list, {what, how});
    };
    mouse(ActionRegistry::tr("Orbit the 3D view"), ActionRegistry::tr("left drag"));
    mouse(ActionRegistry::tr("Pan the 3D view"),
          ActionRegistry::tr("middle, right or Shift + left drag"));
    mouse(ActionRegistry::tr("Zoom the 3D view"), ActionRegistry::tr("wheel"));
    mouse(ActionRegistry::tr("Select a joint or body"), ActionRegistry::tr("click"));
    mouse(ActionRegistry::tr("Look at a point"), ActionRegistry::tr("double click"));
    mouse(ActionRegistry::tr("Drive a rover by hand"),
          ActionRegistry::tr("W A S D, the arrow keys or a gamepad; Shift: slowly"));
    mouse(ActionRegistry::tr("Step a number"),
          ActionRegistry::tr("Up and Down in its field, Shift for ten"));
    list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list->header()->setStretchLastSection(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName("close");
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(list);
    layout->addWidget(buttons);
    dialog.resize(QSize(37, 41) * dialog.fontMetrics().height());
    dialog.exec();
}

}  // namespace widgets
