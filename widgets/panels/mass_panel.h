#pragma once

#include <QWidget>
#include <array>

#include "widgets/document/document.h"

class QGridLayout;
class QLabel;
class QTreeWidget;

namespace widgets {

class QuantityField;

/// Mass and centre of mass of the whole rover and of its bodies.
/// The centre of mass can be edited: the chassis' own is moved.
class MassPanel : public QWidget {
    Q_OBJECT
  public:
    explicit MassPanel(Document* document, QWidget* parent = nullptr);

  signals:
    /// The user chose a body of the mechanism.
    void bodyChosen(int body);

  private:
    void refresh();
    void showBodies();
    simcore::Problems moveCenterOfMass(int axis, double value, const QString& mergeKey);

    Document* document_;
    QLabel* mass_ = nullptr;
    QLabel* stance_ = nullptr;
    QLabel* message_ = nullptr;
    std::array<QuantityField*, 3> com_{};
    QTreeWidget* bodies_ = nullptr;
    bool refreshing_ = false;
};

}  // namespace widgets
