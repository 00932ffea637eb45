#pragma once

#include <QTreeWidget>

#include "widgets/session/statics_worker.h"

namespace widgets {

/// What every wheel carries and asks for where a rover stands: a row a wheel, in the wheels'
/// colours.
class WheelTable : public QTreeWidget {
    Q_OBJECT
  public:
    enum Column { Wheel, Angle, Load, Friction, Torque, kColumns };

    explicit WheelTable(QWidget* parent = nullptr);

    void show(const simcore::run::ResolvedRun& run, const simcore::statics::TraverseSample& sample,
              bool backwards);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fitColumns();
    void setRows(int count);
    void showSigns(const simcore::statics::Study& study);
    void showWheel(QTreeWidgetItem* item, const simcore::statics::Study& study,
                   const simcore::statics::WheelStudy& wheel, double used);
    void showBars(QTreeWidgetItem* item, const simcore::statics::Study& study,
                  const simcore::statics::WheelStudy& wheel, double used);
};

}  // namespace widgets
