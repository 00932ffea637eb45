#pragma once

#include <QElapsedTimer>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "simcore/mobility/free_motions.h"
#include "widgets/document/document.h"

class QButtonGroup;
class QLabel;
class QListWidget;
class QPushButton;
class QToolButton;

namespace widgets {

/// The free motions of the drawn rover, and a swing along one of them to look at.
class MotionPage : public QWidget {
    Q_OBJECT
  public:
    explicit MotionPage(Document* document, QWidget* parent = nullptr);

    const std::vector<simcore::mobility::Swing>& motions() const { return motions_; }

    bool isPlaying() const { return timer_.isActive(); }

    /// Ends a swing; nothing when there is none.
    void stop();
    /// Shows where the swing is after `turns` of its period [-].
    void showPhase(double turns);
    void setModel(simcore::mobility::Model model);
    /// Whether somebody looks at this page.
    void setActive(bool active);

  signals:
    /// The bodies of the design stand like this for a moment.
    void posesShown(const std::vector<simcore::Pose>& bodies);
    /// They stand as before again.
    void ended();
    /// This body of the mechanism, by name, is what an idle motion is about, with the joints that
    /// hold it; "" = none.
    void marked(const QStringList& joints, const QString& body);
    /// The user chose the other model.
    void modelChosen(simcore::mobility::Model model);

  private:
    QWidget* makeModels();
    QWidget* makeControls();
    void refresh();
    void showSelected();
    void play(bool on);
    void showPlaying();
    void markIdle();
    const simcore::mobility::Swing* selected() const;

    Document* document_;
    simcore::mobility::Model model_ = simcore::mobility::Model::Built;
    std::vector<simcore::mobility::Swing> motions_;
    bool active_ = false;
    bool outdated_ = true;
    bool moved_ = false;  ///< posesShown() was emitted, ended() was not
    QTimer timer_;
    QElapsedTimer since_;
    QButtonGroup* models_ = nullptr;
    QLabel* title_ = nullptr;
    QListWidget* list_ = nullptr;
    QLabel* note_ = nullptr;
    QToolButton* next_ = nullptr;
    QPushButton* play_ = nullptr;
};

}  // namespace widgets
