#pragma once

#include <QWidget>

#include "simcore/project/edit.h"
#include "widgets/document/document.h"

class QLabel;
class QTreeWidget;

namespace widgets {

/// Everything wrong with the project, worst first, with reason and remedy. Choosing a line leads to
/// the element it is about.
class ProblemsPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ProblemsPanel(Document* document, QWidget* parent = nullptr);

    /// Shows problems from elsewhere (a run that cannot start) until the next edit.
    void showMore(const simcore::Problems& problems);

    /// Problems that are not the project's: shown through every edit, until others are set.
    void setStanding(const simcore::Problems& problems);

    int count() const;

  signals:
    void elementChosen(simcore::project::ElementRef element);
    void countChanged(int count);

  private:
    void refresh();
    void fill(const simcore::Problems& problems);

    Document* document_;
    QLabel* none_ = nullptr;
    QTreeWidget* list_ = nullptr;
    simcore::Problems shown_;
    simcore::Problems standing_;
};

}  // namespace widgets
