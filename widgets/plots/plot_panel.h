#pragma once

#include <QWidget>
#include <memory>

#include "widgets/session/run_session.h"

namespace widgets {

/// Curves of the run over time, one per wheel: slip, torque, normal force, contact angle, speed.
/// One cursor, one time window and one set of visible wheels for all plots.
class PlotPanel : public QWidget {
    Q_OBJECT
  public:
    explicit PlotPanel(RunSession* session, QWidget* parent = nullptr);
    ~PlotPanel() override;

    /// Number of plots shown, 1 to 4.
    void setPlotCount(int count);
    int plotCount() const;
    /// Writes all shown plots as one picture in light colours: .png, .svg or .pdf by the file's
    /// ending. False when the file cannot be written.
    bool savePicture(const QString& file);
    /// The same picture to the clipboard.
    void copyPicture();

  public slots:
    /// Asks for a file and writes the CSV of the recording / the picture.
    void exportCsv();
    void exportPicture();
    /// Shows the whole recording.
    void fit();

  protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace widgets
