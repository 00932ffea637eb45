#pragma once

#include <QWidget>
#include <memory>

#include "widgets/session/run_library.h"
#include "widgets/session/run_session.h"

namespace widgets {

/// Curves of the run over time, one per wheel, side by side: slip, torque, normal force, contact
/// angle, speed; or one of the chassis. One cursor, one time window and one set of visible wheels
/// for all plots; a table holds the values at the cursor, or their changes since the instant that a
/// click with Shift marked. A click in a plot scrubs the run to that time.
class PlotPanel : public QWidget {
    Q_OBJECT
  public:
    /// The curves of the runs that `library` holds are drawn beside those of `session`.
    PlotPanel(RunSession* session, RunLibrary* library, QWidget* parent = nullptr);
    ~PlotPanel() override;

    /// Number of plots shown, 1 to 4.
    void setPlotCount(int count);
    int plotCount() const;
    /// The quantity of a plot, as channels name it: "slip_abs".
    void setQuantity(int plot, const QString& quantity);
    QString quantity(int plot) const;
    /// Hides or shows the curves of one wheel.
    void setWheelShown(int wheel, bool shown);
    /// Time the table shows values of [s]: under the mouse, else the instant on show.
    double cursorTime() const;
    /// The time window on show [s].
    std::pair<double, double> window() const;
    /// What stands in place of the curves while there are none.
    QString hint() const;
    /// Writes all shown plots as one picture in light colours: .png, .svg or .pdf by the file's
    /// ending. Problems when the file cannot be written or has another ending.
    simcore::Problems savePicture(const QString& file);
    /// The same picture to the clipboard.
    void copyPicture();

  public slots:
    /// Asks for a file and writes the CSV of the recording / the picture.
    void exportCsv();
    /// Asks which channels and which time of the run, then for a file, and writes these.
    void exportChannels();
    void exportPicture();
    /// Shows the whole recording.
    void fit();

  signals:
    /// A file was written.
    void written(const QString& file);

  protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void writeCsv(const simcore::io::TableCut& cut);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace widgets
