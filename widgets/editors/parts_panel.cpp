#include "widgets/editors/parts_panel.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/editors/parts_tree.h"

namespace widgets {

PartsPanel::PartsPanel(PartsTree* tree, QMenu* add, QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit) {
    search_->setPlaceholderText(tr("Search parts"));
    search_->setAccessibleName(tr("Search parts"));
    search_->setObjectName("searchParts");
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, tree, &PartsTree::filter);
    connect(tree, &PartsTree::filterCleared, search_, &QLineEdit::clear);
    auto* button = new QToolButton;
    button->setText(tr("Add"));
    button->setToolTip(tr("Add a part"));
    button->setAccessibleName(tr("Add a part"));
    button->setObjectName("addPart");
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(add);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(6, 6, 6, 4);
    row->setSpacing(6);
    row->addWidget(search_, 1);
    row->addWidget(button);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(row);
    layout->addWidget(tree, 1);
}

void PartsPanel::search() {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

}  // namespace widgets
