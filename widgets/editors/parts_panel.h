#pragma once

#include <QWidget>

class QLineEdit;
class QMenu;

namespace widgets {

class PartsTree;

/// The tree of parts under its search field and the button that adds parts.
class PartsPanel : public QWidget {
    Q_OBJECT
  public:
    /// `add` is the menu of the button.
    PartsPanel(PartsTree* tree, QMenu* add, QWidget* parent = nullptr);

    /// Puts the cursor into the search field.
    void search();

  private:
    QLineEdit* search_;
};

}  // namespace widgets
