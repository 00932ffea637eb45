#pragma once

#include <QDialog>
#include <optional>

#include "simcore/io/csv.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {

/// Which channels of a run, and which of its time, go into a table.
class ExportDialog : public QDialog {
    Q_OBJECT
  public:
    /// Instants that ranges are made of [s].
    struct Times {
        double visibleFrom = 0.0, visibleTo = 0.0;  ///< the plots' time window
        std::optional<double> mark;                 ///< marked with Shift
        double shown = 0.0;                         ///< the instant on show
    };

    /// `plotted`: names of the channels that the plots show; these are ticked first. The recording
    /// must outlive the dialog.
    ExportDialog(const simcore::run::Recording& recording, const std::vector<std::string>& plotted,
                 const Times& times, QWidget* parent = nullptr);

    simcore::io::TableCut cut() const;

  private:
    enum Range { Visible, Cursors, All };

    void makeList(const std::vector<std::string>& plotted);
    void filter(const QString& text);
    /// Ticks those the search shows, or none of them.
    void tickShown(bool on);
    void tellSize();

    const simcore::run::Recording& recording_;
    Times times_;
    std::vector<std::string> plotted_;
    QLineEdit* search_;
    QTreeWidget* list_;
    QComboBox* range_;
    QLabel* size_;
    QPushButton* write_ = nullptr;
    bool refreshing_ = false;
};

}  // namespace widgets
