#pragma once

#include <QDialog>
#include <vector>

#include "simcore/project/project.h"
#include "widgets/document/autosave.h"

class QListWidget;

namespace widgets {

/// What was found of one program that ended badly.
struct Recovered {
    Leftover leftover;
    simcore::project::Project project;
};

/// Lets the user choose among the projects that programs which ended badly left unsaved: restore
/// one, throw some away, or decide later.
class RecoveryDialog : public QDialog {
    Q_OBJECT
  public:
    /// `found` is not empty; the newest is first.
    RecoveryDialog(std::vector<Recovered> found, QWidget* parent);

    /// The one to restore, after acceptance.
    const Recovered& chosen() const;

    /// How many are left to decide about later.
    int remaining() const { return static_cast<int>(found_.size()); }

  private:
    void throwAway();

    std::vector<Recovered> found_;
    QListWidget* list_ = nullptr;
};

}  // namespace widgets
