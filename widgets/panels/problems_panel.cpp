#include "widgets/panels/problems_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QResizeEvent>
#include <QSettings>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;

namespace {

constexpr int kEntryRole = Qt::UserRole;  // place in what is shown
constexpr const char* kHiddenSetting = "problems/hidden";

/// Lines as high as their wrapped text: the tree's own delegate knows no width to wrap to.
class WrappedLines : public QStyledItemDelegate {
  public:
    explicit WrappedLines(QTreeWidget* tree) : QStyledItemDelegate(tree), tree_(tree) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QSize size = QStyledItemDelegate::sizeHint(option, index);
        if (index.parent().isValid()) {
            constexpr int kMargin = 12;
            const int width =
                std::max(80, tree_->viewport()->width() - 2 * tree_->indentation() - kMargin);
            const QRect text = tree_->fontMetrics().boundingRect(
                QRect(0, 0, width, 10000), Qt::TextWordWrap, index.data().toString());
            size.setHeight(std::max(size.height(), text.height() + 6));
        }
        return size;
    }

  private:
    QTreeWidget* tree_;
};

/// Titles of the kinds of findings.
QString titleOf(const QString& kind) {
    for (const auto& [name, title] : simcore::review::kinds()) {
        if (kind.toStdString() == name) {
            return QString::fromStdString(title);
        }
    }
    return kind;
}

}  // namespace

ProblemsPanel::ProblemsPanel(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      none_(new QLabel(tr("No problems."), this)),
      list_(new QTreeWidget(this)),
      hiddenButton_(new QToolButton(this)),
      hidden_(QSettings().value(kHiddenSetting).toStringList()) {
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
    layout->addWidget(hiddenButton_);
    list_->setObjectName("problemList");
    list_->setItemDelegate(new WrappedLines(list_));
    list_->setTextElideMode(Qt::ElideNone);
    list_->viewport()->installEventFilter(this);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QTreeWidget::customContextMenuRequested, this, &ProblemsPanel::openMenu);
    hiddenButton_->setObjectName("hiddenKinds");
    hiddenButton_->setAccessibleName(tr("Hidden advice"));
    hiddenButton_->setToolTip(tr("Choose a kind of advice to show it again"));
    hiddenButton_->setAutoRaise(true);
    hiddenButton_->setPopupMode(QToolButton::InstantPopup);
    hiddenButton_->setMenu(new QMenu(hiddenButton_));
    showHidden();
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

bool ProblemsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        // Lines wrap anew; later, for a bar that comes or goes resizes once more.
        QMetaObject::invokeMethod(
            list_, [this] { list_->doItemsLayout(); }, Qt::QueuedConnection);
    }
    return QWidget::eventFilter(watched, event);
}

void ProblemsPanel::setStanding(const Problems& problems) {
    standing_ = problems;
    refresh();
}

void ProblemsPanel::setMoreFindings(const std::vector<simcore::review::Finding>& findings) {
    moreFindings_ = findings;
    fill(problems_);
}

void ProblemsPanel::showMore(const Problems& problems) {
    Problems all = standing_;
    appendNew(all, document_->derived().problems);
    appendNew(all, problems);
    fill(all);
}

void ProblemsPanel::refresh() {
    showMore({});
}

void ProblemsPanel::fill(const Problems& problems) {
    problems_ = problems;
    std::vector<Entry> entries;
    for (const Problem& problem : problems) {
        entries.push_back({problem, {}, {}});
    }
    std::vector<simcore::review::Finding> findings = document_->derived().findings;
    findings.insert(findings.end(), moreFindings_.begin(), moreFindings_.end());
    for (const auto& finding : findings) {
        if (!hidden_.contains(QString::fromStdString(finding.kind))) {
            entries.push_back({asProblem(finding), finding.kind,
                               finding.fix ? finding.fix->label : std::string()});
        }
    }
    if (entries != shown_ || entries.empty()) {
        list_->clear();
        shown_ = entries;
        for (const Entry& entry : shown_) {
            addRow(entry);
        }
    }
    none_->setVisible(entries.empty());
    list_->setVisible(!entries.empty());
    emit countChanged(count());
}

void ProblemsPanel::addRow(const Entry& entry) {
    const Problem& problem = entry.problem;
    auto* item = new QTreeWidgetItem(list_, {QString::fromStdString(problem.element)});
    item->setData(0, kEntryRole, list_->topLevelItemCount() - 1);
    item->setIcon(0, style()->standardIcon(problem.severity == Severity::Critical
                                               ? QStyle::SP_MessageBoxCritical
                                           : problem.severity == Severity::Warning
                                               ? QStyle::SP_MessageBoxWarning
                                               : QStyle::SP_MessageBoxInformation));
    item->setToolTip(0, QString::fromStdString(toString(problem)));
    auto* reason =
        new QTreeWidgetItem(item, {QString::fromStdString(problem.reason + " " + problem.remedy)});
    reason->setToolTip(0, reason->text(0));
    item->setExpanded(true);
    const QString kind = QString::fromStdString(entry.kind);
    if (!entry.fix.empty()) {
        addButton(item, kind, QString::fromStdString(entry.fix),
                  [this, entry] { applyFix(entry); });
    } else if (entry.kind == "hyperstatic") {
        addButton(item, kind, tr("Find exact joints"), [this] { emit adviceRequested(); });
    }
}

void ProblemsPanel::addButton(QTreeWidgetItem* item, const QString& kind, const QString& label,
                              const std::function<void()>& act) {
    auto* row = new QTreeWidgetItem(item);
    auto* button = new QPushButton(label);
    button->setObjectName("fix:" + kind);
    button->setAccessibleName(tr("Fix %1: %2").arg(item->text(0), label));
    // As wide as its text: the view would stretch it over the whole row.
    auto* place = new QWidget;
    auto* layout = new QHBoxLayout(place);
    layout->setContentsMargins(0, 2, 8, 4);
    layout->addWidget(button);
    layout->addStretch();
    list_->setItemWidget(row, 0, place);
    // Later: an edit fills the list anew, and the button with it.
    connect(button, &QPushButton::clicked, this, act, Qt::QueuedConnection);
}

void ProblemsPanel::applyFix(const Entry& entry) {
    for (const auto& finding : document_->derived().findings) {
        if (finding.fix && finding.kind == entry.kind && asProblem(finding) == entry.problem) {
            const auto fix = *finding.fix;  // the edit makes new findings
            document_->edit(tr("Fix: %1").arg(QString::fromStdString(fix.label)), fix.project);
            return;
        }
    }
}

void ProblemsPanel::openMenu(const QPoint& place) {
    const QTreeWidgetItem* item = list_->itemAt(place);
    if (item == nullptr) {
        return;
    }
    const QTreeWidgetItem* top = item->parent() ? item->parent() : item;
    const auto at = static_cast<std::size_t>(top->data(0, kEntryRole).toInt());
    const QString kind = QString::fromStdString(shown_.at(at).kind);
    if (kind.isEmpty()) {
        return;  // a mistake stays a mistake
    }
    QMenu menu;
    menu.setObjectName("problemMenu");
    menu.addAction(tr("Hide \u201c%1\u201d").arg(titleOf(kind)), this,
                   [this, kind] { setHidden(kind, true); });
    menu.exec(list_->viewport()->mapToGlobal(place));
}

void ProblemsPanel::setHidden(const QString& kind, bool hidden) {
    hidden_.removeAll(kind);
    if (hidden) {
        hidden_ << kind;
    }
    QSettings().setValue(kHiddenSetting, hidden_);
    showHidden();
    fill(problems_);
}

void ProblemsPanel::showHidden() {
    hiddenButton_->setVisible(!hidden_.isEmpty());
    hiddenButton_->setText(hidden_.size() == 1
                               ? tr("1 kind of advice hidden")
                               : tr("%1 kinds of advice hidden").arg(hidden_.size()));
    QMenu* menu = hiddenButton_->menu();
    menu->clear();
    for (const QString& kind : hidden_) {
        menu->addAction(tr("Show \u201c%1\u201d").arg(titleOf(kind)), this,
                        [this, kind] { setHidden(kind, false); });
    }
}

}  // namespace widgets
