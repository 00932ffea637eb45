#pragma once

#include <QGraphicsView>
#include <QWidget>

#include "widgets/document/document.h"

class QLabel;

namespace widgets {

/// Draws the graph; fits it into its window until the user zooms.
class GraphView : public QGraphicsView {
    Q_OBJECT
  public:
    explicit GraphView(QWidget* parent = nullptr);

    /// The whole graph, and so after every change of size.
    void fit();

  protected:
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    bool fitted_ = true;
};

/// The graph of the mechanism: bodies as nodes, joints and wheel contacts as edges with the number
/// of their freedoms; those that hold more than they need to are marked.
class GraphPanel : public QWidget {
    Q_OBJECT
  public:
    explicit GraphPanel(Document* document, QWidget* parent = nullptr);

    void setModel(simcore::mobility::Model model);
    /// Whether somebody looks: nothing is drawn meanwhile.
    void setActive(bool active);
    /// By name, without a signal; "" = none.
    void select(const QString& joint, const QString& body);

    GraphView& view() { return *view_; }

  signals:
    void jointChosen(const QString& joint);
    void bodyChosen(const QString& body);

  private:
    void draw();
    void drawEdges();
    void drawGears();
    void drawBodies();
    void showSelection();
    void choose();

    Document* document_;
    simcore::mobility::Model model_ = simcore::mobility::Model::Built;
    bool active_ = false;
    bool outdated_ = true;
    bool refreshing_ = false;
    QString joint_, body_;
    GraphView* view_ = nullptr;
    QLabel* legend_ = nullptr;
};

}  // namespace widgets
