#pragma once

#include <QStringList>
#include <QWidget>

#include "simcore/mobility/mobility.h"

class QComboBox;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {

/// What lies behind the counts, one of three at a time: the constraints that could go, by joint;
/// the loops, each analysed alone; which reactions the loads determine, and where the self-stress
/// is.
class MobilityList : public QWidget {
    Q_OBJECT
  public:
    explicit MobilityList(QWidget* parent = nullptr);

    /// Shows them of this mechanism; `report` is of the same.
    void show(const simcore::mechanism::Mechanism& mechanism,
              const simcore::mobility::Stance& stance, const simcore::mobility::Report& report);

    /// Selects the rows of a joint without emitting anything; "" clears.
    void selectElement(const QString& name);
    /// Takes back what it marked.
    void unmark();

  signals:
    /// The user chose a joint or one of its constraints, or a wheel's contact; by name.
    void jointChosen(const QString& joint);
    void wheelChosen(const QString& wheel);
    /// Joints and bodies of the loop chosen; none: no longer.
    void marked(const QStringList& joints, const QStringList& bodies);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    enum Kind { Constraints, Loops, Reactions };

    void fitShares();
    void fill();
    QList<QTreeWidgetItem*> constraintItems();
    QList<QTreeWidgetItem*> loopItems();
    QList<QTreeWidgetItem*> reactionItems();
    QTreeWidgetItem* elementItem(const std::string& element) const;
    void choose(QTreeWidgetItem* item);

    QComboBox* kind_;
    QLabel* title_;
    QTreeWidget* list_;
    simcore::mechanism::Mechanism mechanism_;
    simcore::mobility::Stance stance_;
    simcore::mobility::Report report_;
    bool refreshing_ = false;
    bool marks_ = false;
};

}  // namespace widgets
