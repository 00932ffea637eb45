#pragma once

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <vector>

namespace widgets {

/// Every action of the window, by name, in the order they were added: menus, tool bar, shortcuts
/// and the list of shortcuts are all made from it.
class ActionRegistry : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

    QAction* add(const QString& name, const QString& text, const QList<QKeySequence>& shortcuts,
                 const QString& tip = {});
    /// As above, and calls `slot` when triggered.
    QAction* add(const QString& name, const QString& text, const QList<QKeySequence>& shortcuts,
                 const QString& tip, std::function<void()> slot);
    /// Takes an action made elsewhere.
    QAction* adopt(const QString& name, QAction* action);

    /// std::out_of_range when there is none of this name.
    QAction* at(const QString& name) const { return actions_.at(name); }

    bool has(const QString& name) const { return actions_.count(name) > 0; }

    const std::vector<QAction*>& all() const { return order_; }

  private:
    std::map<QString, QAction*> actions_;
    std::vector<QAction*> order_;
};

/// A window that lists all shortcuts.
void showShortcuts(const ActionRegistry& actions, QWidget* parent);

}  // namespace widgets
