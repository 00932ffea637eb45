#pragma once

#include <QTreeWidget>
#include <map>
#include <vector>

#include "simcore/project/edit.h"
#include "widgets/document/document.h"

namespace widgets {

/// Name of a kind of element, "Body", for menus and titles.
QString kindTitle(simcore::project::ElementKind kind);

/// All elements of the project by kind, with a short detail each; several can be selected. Adds,
/// deletes, copies, mirrors and renames them; dragging moves them within their kind.
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
    /// "fork_a", or "3 parts".
    QString titleOf(const std::vector<simcore::project::ElementRef>& elements) const;
    /// Makes it the project, or says why not.
    bool apply(const QString& text, const simcore::Result<simcore::project::Project>& next);
    void selectThese(const std::vector<simcore::project::ElementRef>& elements);
    void selectAppended(const simcore::project::Project& before,
                        simcore::project::ElementRef current = {});
    /// Where a drop would put what is dragged; -1 = nowhere.
    int dropPlace(QDropEvent* event) const;
    /// The elements, of one kind, before what is now at `place` of their list.
    void moveTo(const std::vector<simcore::project::ElementRef>& elements, int place);
    void applyFilter();

    Document* document_;
    std::map<simcore::project::ElementRef, QTreeWidgetItem*> items_;
    std::map<int, bool> expanded_;  ///< of the groups, while a filter opens them all
    std::vector<QAction*> menuActions_;
    QString filter_;
    bool refreshing_ = false;
};

}  // namespace widgets
