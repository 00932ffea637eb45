#pragma once

#include <QTreeWidget>
#include <map>

#include "simcore/project/edit.h"
#include "widgets/document/document.h"

namespace widgets {

/// All elements of the project by kind, with a short detail each. Delete, duplicate and rename
/// from the keyboard or the context menu.
class PartsTree : public QTreeWidget {
    Q_OBJECT
  public:
    explicit PartsTree(Document* document, QWidget* parent = nullptr);

    /// Selects without emitting elementSelected(); index -1 clears.
    void select(simcore::project::ElementRef element);

    simcore::project::ElementRef selected() const;

  public slots:
    void deleteSelected();
    void duplicateSelected();

  signals:
    /// The user selected another element.
    void elementSelected(simcore::project::ElementRef element);
    /// A change was refused.
    void refused(const QString& why);

  protected:
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    void refresh();
    void rename(QTreeWidgetItem* item);
    QString detail(simcore::project::ElementRef element) const;

    Document* document_;
    std::map<simcore::project::ElementRef, QTreeWidgetItem*> items_;
    bool refreshing_ = false;
};

}  // namespace widgets
