#pragma once

#include <QDialog>
#include <filesystem>
#include <vector>

#include "widgets/document/document.h"

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QVBoxLayout;

namespace widgets {

class RoverSketch;

/// Chooses a template and its main dimensions; shows meanwhile what the rover would look like and
/// how mobile it would be.
class NewRoverDialog : public QDialog {
    Q_OBJECT
  public:
    explicit NewRoverDialog(QWidget* parent = nullptr);

    /// The new project; valid once the dialog was accepted.
    const simcore::project::Project& project() const { return draft_.project(); }

  private:
    void choose(int row);
    void makeFields();
    void update();
    simcore::Problems setDimension(int place, const simcore::project::Quantity& value);

    Document draft_;
    std::vector<simcore::project::Project> templates_;
    QListWidget* list_;
    QLabel* description_;
    RoverSketch* sketch_;
    QWidget* dimensions_;
    QVBoxLayout* right_ = nullptr;
    QLabel* summary_;
    QLabel* problem_;
    QDialogButtonBox* buttons_;
};

}  // namespace widgets
