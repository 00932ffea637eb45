#pragma once

#include <QScrollArea>
#include <functional>
#include <vector>

#include "simcore/project/edit.h"
#include "widgets/document/document.h"

class QFormLayout;
class QLabel;

namespace widgets {

/// The fields of one selected element, whatever it is: built from the table of fields that file
/// reader and writer use, so that no field can be forgotten here.
class PropertyPanel : public QScrollArea {
    Q_OBJECT
  public:
    explicit PropertyPanel(Document* document, QWidget* parent = nullptr);

    /// Index -1: nothing selected.
    void setElement(simcore::project::ElementRef element);

    simcore::project::ElementRef element() const { return element_; }

  signals:
    /// An element got another name.
    void renamed(simcore::project::ElementRef element);
    /// An element beside the one shown is asked for.
    void chosen(simcore::project::ElementRef element);
    /// Another shape of the shown body is asked for.
    void shapeWanted(simcore::project::ShapeKind kind);
    /// A value was refused; "" when that is over.
    void refused(const QString& why);

  private:
    friend class PropertyFormBuilder;
    void rebuild();
    void refresh();

    Document* document_;
    simcore::project::ElementRef element_;
    std::vector<std::function<void()>> refreshers_;
    std::string shape_;  ///< what the form was built for; another one needs another form
};

}  // namespace widgets
