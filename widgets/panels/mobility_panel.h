#pragma once

#include <QWidget>
#include <array>

#include "widgets/document/document.h"

class QButtonGroup;
class QGridLayout;
class QLabel;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {

class AdvisorPage;
class MotionPage;

/// How much the rover can move and what is over-constrained, in three pages: both models side by
/// side, a verdict in words, and every constraint that could go, by joint; which joints to free;
/// the free motions.
class MobilityPanel : public QWidget {
    Q_OBJECT
  public:
    explicit MobilityPanel(Document* document, QWidget* parent = nullptr);

    /// The model whose constraints are listed.
    simcore::mobility::Model model() const { return model_; }

    void setModel(simcore::mobility::Model model);

    enum class Page { Counts, Advisor, Motions };

    void setPage(Page page);
    /// Whether the panel is on show: a dock behind another counts as hidden.
    void setActive(bool active);

    AdvisorPage& advisor() { return *advisor_; }

    MotionPage& motions() { return *motions_; }

    /// Selects the rows of a joint without emitting jointChosen(); -1 clears.
    void selectJoint(int joint);

  signals:
    /// The user chose a constraint of this joint of the mechanism; -1: none, or a contact.
    void jointChosen(int joint);
    /// The user chose a constraint of the contact of this wheel.
    void wheelChosen(int wheel);
    void modelChanged();
    /// These joints and bodies of the mechanism, by name, are what the page shown is about.
    void marked(const QStringList& joints, const QStringList& bodies);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fitShares();

    enum Quantity { Gruebler, Parts, Rows, Rank, Mobility, Redundant, kQuantities };

    const simcore::mobility::Report& report() const;
    void buildTable(QGridLayout* grid);
    QWidget* makePageButtons();
    void connectPages();
    void showPage();
    void refresh();
    void showTable();
    void showConstraints();

    Document* document_;
    simcore::mobility::Model model_ = simcore::mobility::Model::Built;
    QButtonGroup* models_ = nullptr;
    QButtonGroup* pageButtons_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    AdvisorPage* advisor_ = nullptr;
    MotionPage* motions_ = nullptr;
    QWidget* content_ = nullptr;
    QLabel* unavailable_ = nullptr;
    QLabel* headline_ = nullptr;
    QLabel* verdict_ = nullptr;
    QLabel* listTitle_ = nullptr;
    QTreeWidget* list_ = nullptr;
    std::array<std::array<QLabel*, 2>, kQuantities> cells_{};
    bool active_ = true;
    bool refreshing_ = false;
};

}  // namespace widgets
