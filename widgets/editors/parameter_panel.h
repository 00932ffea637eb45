#pragma once

#include <QWidget>
#include <vector>

#include "widgets/document/document.h"

class QLabel;
class QLineEdit;
class QScrollArea;
class QSlider;

namespace widgets {

class QuantityField;

/// All parameters of the rover: name, value with unit or expression, and a slider over the range.
/// Dragging a slider is one undo step.
class ParameterPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ParameterPanel(Document* document, QWidget* parent = nullptr);

    /// Brings the parameter into view and puts the cursor into its field.
    void focusParameter(const QString& name);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fitWidth();

    struct Row {
        QString name;
        QLabel* label;
        QuantityField* field;
        QSlider* slider;
    };

    void rebuild();
    void refresh();
    void filter(const QString& text);
    simcore::Problems apply(int index, const simcore::project::Quantity& value,
                            const QString& mergeKey);
    void slide(int index, int position);

    Document* document_;
    QLineEdit* filter_ = nullptr;
    QScrollArea* scroll_ = nullptr;
    QLabel* message_ = nullptr;
    QLabel* none_ = nullptr;
    std::vector<Row> rows_;
    bool refreshing_ = false;
};

}  // namespace widgets
