#pragma once

#include <QTreeWidget>
#include <map>
#include <vector>

#include "simcore/project/edit.h"
#include "widgets/document/document.h"

namespace widgets {

/// Name of a kind of element, "Body", for menus and titles.
QString kindTitle(simcore::project::ElementKind kind);
/// "Box".
QString kindTitle(simcore::project::ShapeKind kind);

/// Its name; of a shape, which has none, kind and place among those of its body: "Box 2".
QString labelOf(const simcore::project::Project& project, simcore::project::ElementRef element);

/// All elements of the project by kind, shapes below their bodies, with a short detail each;
/// several can be selected. Adds, deletes, copies, mirrors and renames them; dragging moves
/// elements within their kind and shapes from body to body.
class PartsTree : public QTreeWidget {
    Q_OBJECT
  public:
    explicit PartsTree(Document* document, QWidget* parent = nullptr);

    /// Selects one without emitting elementSelected(); index -1 clears.
    void select(simcore::project::ElementRef element);

    /// Adds it to the selection, or takes it out, as Ctrl and a click do.
    void toggle(simcore::project::ElementRef element);

    /// The current one, which the editors show.
    simcore::project::ElementRef selected() const;
    /// All of them, in the order of the file.
    std::vector<simcore::project::ElementRef> selection() const;

    /// Shows only elements with the text in their name.
    void filter(const QString& text);

    /// What the context menu offers; null = a separator.
    void setMenuActions(const std::vector<QAction*>& actions) { menuActions_ = actions; }

  public slots:
    void add(simcore::project::ElementKind kind);
    /// To the body that is current, or whose shape, wheel or payload is.
    void addShape(simcore::project::ShapeKind kind);
    void deleteSelected();
    void duplicateSelected();
    void cutSelected();
    void copySelected();
    void paste();
    void mirrorSelected();
    void splitSelected();
    /// By one place up (-1) or down (+1) within their list.
    void moveSelected(int by);
    void renameSelected();

  signals:
    /// The user selected another element.
    void elementSelected(simcore::project::ElementRef element);
    /// selection() may be another one, by whatever way.
    void selectionMoved();
    /// A change was refused.
    void refused(const QString& why);
    /// Something worth knowing was done.
    void message(const QString& text);
    /// New parts would be hidden by the filter.
    void filterCleared();

  protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void startDrag(Qt::DropActions actions) override;

  private:
    void refresh();
    void rebuild();
    void rename(QTreeWidgetItem* item);
    QString detail(simcore::project::ElementRef element) const;
    QString shapeDetail(const simcore::project::Shape& shape) const;
    QString shown(const simcore::project::Quantity& quantity, const char* unit) const;
    /// Where shapes go that are added or pasted; -1 = nothing of a body is current.
    int currentBody() const;
    /// Opens what the item is in.
    static void reveal(QTreeWidgetItem* item);
    QTreeWidgetItem* addItem(QTreeWidgetItem* parent, simcore::project::ElementRef element);
    void rememberExpanded();
    void restoreExpanded();
    /// "fork_a", "box 1 of fork_a", or "3 parts".
    QString titleOf(const std::vector<simcore::project::ElementRef>& elements) const;
    /// Makes it the project, or says why not.
    bool apply(const QString& text, const simcore::Result<simcore::project::Project>& next);
    void selectThese(const std::vector<simcore::project::ElementRef>& elements);
    void selectAppended(const simcore::project::Project& before,
                        simcore::project::ElementRef current = {});
    /// What a drop would put what is dragged before; index -1 = it cannot be dropped.
    simcore::project::ElementRef dropPlace(QDropEvent* event) const;
    /// The elements, of one kind, before what is now at `place` of their list.
    void moveTo(const std::vector<simcore::project::ElementRef>& elements, int place);
    /// Shapes of any bodies, before what is now at `place` of the body's list.
    void moveShapesTo(const std::vector<simcore::project::ElementRef>& shapes, int body, int place);
    void applyFilter();

    Document* document_;
    std::map<simcore::project::ElementRef, QTreeWidgetItem*> items_;
    std::map<QString, bool> expanded_;  ///< groups and bodies, while a filter opens them
    std::vector<QAction*> menuActions_;
    QString filter_;
    bool refreshing_ = false;
};

}  // namespace widgets
