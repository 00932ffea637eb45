#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>

#include "widgets/document/document.h"
#include "widgets/session/advisor_session.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {

/// Which joints to free so that nothing is redundant: asks the Advisor, lists what it proposes, and
/// writes a proposal into the project as its relaxed model.
class AdvisorPage : public QWidget {
    Q_OBJECT
  public:
    explicit AdvisorPage(Document* document, QWidget* parent = nullptr);

    AdvisorSession& session() { return session_; }

    /// Begins a search, or a longer one when the last ran out of time.
    void search();
    /// Proposal that is selected; -1: none.
    int selected() const;
    /// Whether somebody looks at this page.
    void setActive(bool active);

  signals:
    /// These joints and wheels of the mechanism, by name, are what the proposal changes.
    void marked(const QStringList& joints, const QStringList& wheels);
    /// The user chose one changed joint, or the contact of a wheel.
    void jointChosen(const QString& joint);
    void wheelChosen(const QString& wheel);

  private:
    QWidget* makeButtons();
    void makeList();
    void refresh();
    void showProgress();
    void showHeadline();
    void fillList();
    void showSelected();
    void choose(QTreeWidgetItem* item);
    void markSelected();
    void apply();

    Document* document_;
    AdvisorSession session_;
    QTimer tick_;
    bool active_ = false;
    const simcore::mobility::Advice* listed_ = nullptr;
    QLabel* headline_ = nullptr;
    QLabel* text_ = nullptr;
    QPushButton* start_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QLabel* counts_ = nullptr;
    QPushButton* apply_ = nullptr;
};

}  // namespace widgets
