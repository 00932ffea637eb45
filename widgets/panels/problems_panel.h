#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

#include "simcore/project/edit.h"
#include "widgets/document/document.h"

class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {

/// Everything wrong with the project, worst first, with reason and remedy, then what is unwise.
/// Choosing a line leads to the element it is about; what can be fixed has a button; kinds of
/// advice can be hidden.
class ProblemsPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ProblemsPanel(Document* document, QWidget* parent = nullptr);

    /// Shows problems from elsewhere (a run that cannot start) until the next edit.
    void showMore(const simcore::Problems& problems);

    /// Problems that are not the project's: shown through every edit, until others are set.
    void setStanding(const simcore::Problems& problems);

    /// Advice that takes longer than an edit: shown behind that of the document.
    void setMoreFindings(const std::vector<simcore::review::Finding>& findings);

    int count() const;

  signals:
    void elementChosen(simcore::project::ElementRef element);
    void countChanged(int count);
    /// The Advisor is to find out what to free.
    void adviceRequested();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// What is in the list: a mistake, or a finding.
    struct Entry {
        simcore::Problem problem;
        std::string kind;  ///< of a finding; empty: it cannot be hidden
        std::string fix;   ///< label of its fix; empty: none
        bool operator==(const Entry&) const = default;
    };

    void refresh();
    void fill(const simcore::Problems& problems);
    void addRow(const Entry& entry);
    void addButton(QTreeWidgetItem* item, const QString& kind, const QString& label,
                   const std::function<void()>& act);
    void applyFix(const Entry& entry);
    void setHidden(const QString& kind, bool hidden);
    void showHidden();
    void openMenu(const QPoint& place);

    Document* document_;
    QLabel* none_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QToolButton* hiddenButton_ = nullptr;
    QStringList hidden_;  ///< kinds of findings
    simcore::Problems problems_;
    std::vector<Entry> shown_;
    simcore::Problems standing_;
    std::vector<simcore::review::Finding> moreFindings_;
};

}  // namespace widgets
