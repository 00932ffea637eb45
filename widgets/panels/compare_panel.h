#pragma once

#include <QWidget>

#include "widgets/session/experiment.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {

/// Runs beside one another: two controllers on one scenario with the verdict, and what the run on
/// show and the held ones came to, measure by measure.
class ComparePanel : public QWidget {
    Q_OBJECT
  public:
    ComparePanel(RunSession* shown, RunLibrary* library, Experiment* experiment,
                 QWidget* parent = nullptr);

    /// The controller that the run on show is to be held against.
    simcore::project::ControllerKind rival() const;
    void setRival(simcore::project::ControllerKind kind);
    /// What the run bar asks for: the first of the two controllers.
    void setController(simcore::project::ControllerKind kind);

  public slots:
    /// The table, tab-separated with units, to the clipboard.
    void copyTable();

  signals:
    void startRequested();
    void keepRequested();
    /// A recording is to be held beside the runs.
    void addRequested();
    /// A run is to be saved as a recording: the selected one.
    void saveRequested(const widgets::RunSession& run);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fitLines();
    QWidget* makeExperiment();
    QWidget* makeRuns();
    void fillRuns();
    void fillTable();
    void fillCells();
    void showVerdict();
    void removeSelected();
    void saveSelected();
    void updateButtons();
    void onItemChanged(QTreeWidgetItem* item, int column);
    int idOf(const QTreeWidgetItem* item) const;

    RunSession* shown_;
    RunLibrary* library_;
    Experiment* experiment_;
    QLabel* first_ = nullptr;
    QComboBox* rival_ = nullptr;
    QPushButton* start_ = nullptr;
    QLabel* verdict_ = nullptr;
    QLabel* details_ = nullptr;
    QTreeWidget* runs_ = nullptr;
    QPushButton* keep_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* copy_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLabel* hint_ = nullptr;
    QLabel* aside_ = nullptr;                 ///< says that runs are out of sight
    std::vector<const RunSession*> columns_;  ///< runs in the table
    bool filling_ = false;
};

}  // namespace widgets
