#pragma once

#include <QPixmap>
#include <QWidget>
#include <optional>

#include "simcore/mechanism/mechanism.h"

namespace widgets {

/// A rover seen from its right side, forward to the right, as lines: wheels, bars, boxes, pins.
class RoverSketch : public QWidget {
    Q_OBJECT
  public:
    explicit RoverSketch(QWidget* parent = nullptr);

    /// Nothing leaves the last one, pale.
    void setMechanism(const std::optional<simcore::mechanism::Mechanism>& mechanism);

    QSize sizeHint() const override { return {360, 200}; }

    QSize minimumSizeHint() const override { return {200, 120}; }

    /// The same as a picture for lists, in the palette's colours.
    static QPixmap picture(const simcore::mechanism::Mechanism& mechanism, QSize size,
                           const QPalette& palette, double pixelRatio);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::optional<simcore::mechanism::Mechanism> mechanism_;
    bool known_ = false;
};

}  // namespace widgets
