#include "widgets/panels/problems_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;

ProblemsPanel::ProblemsPanel(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      none_(new QLabel(tr("No problems."), this)),
      list_(new QTreeWidget(this)) {
    none_->setAlignment(Qt::AlignCenter);
    none_->setEnabled(false);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(true);
    list_->setWordWrap(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setAccessibleName(tr("Problems"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->addWidget(none_, 1);
    layout->addWidget(list_, 1);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item == nullptr) {
            return;
        }
        const QTreeWidgetItem* top = item->parent() ? item->parent() : item;
        const auto element =
            simcore::project::findElement(document_->project(), top->text(0).toStdString());
        if (element.index >= 0) {
            emit elementChosen(element);
        }
    });
    connect(document_, &Document::changed, this, &ProblemsPanel::refresh);
    refresh();
}

int ProblemsPanel::count() const {
    return list_->topLevelItemCount();
}

void ProblemsPanel::setStanding(const Problems& problems) {
    standing_ = problems;
    refresh();
}

void ProblemsPanel::showMore(const Problems& problems) {
    Problems all = standing_;
    const Problems& own = document_->derived().problems;
    all.insert(all.end(), own.begin(), own.end());
    for (const Problem& problem : problems) {
        if (std::find(all.begin(), all.end(), problem) == all.end()) {
            all.push_back(problem);
        }
    }
    fill(all);
}

void ProblemsPanel::refresh() {
    showMore({});
}

void ProblemsPanel::fill(const Problems& problems) {
    if (problems != shown_ || problems.empty()) {
        list_->clear();
        for (const Problem& problem : problems) {
            auto* item = new QTreeWidgetItem(list_, {QString::fromStdString(problem.element)});
            item->setIcon(0, style()->standardIcon(problem.severity == Severity::Critical
                                                       ? QStyle::SP_MessageBoxCritical
                                                   : problem.severity == Severity::Warning
                                                       ? QStyle::SP_MessageBoxWarning
                                                       : QStyle::SP_MessageBoxInformation));
            item->setToolTip(0, QString::fromStdString(toString(problem)));
            auto* reason = new QTreeWidgetItem(
                item, {QString::fromStdString(problem.reason + " " + problem.remedy)});
            reason->setToolTip(0, reason->text(0));
            item->setExpanded(true);
        }
        shown_ = problems;
    }
    none_->setVisible(problems.empty());
    list_->setVisible(!problems.empty());
    emit countChanged(count());
}

}  // namespace widgets
