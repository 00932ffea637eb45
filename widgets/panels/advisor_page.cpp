#include "widgets/panels/advisor_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <string_view>

#include "widgets/panels/advice_text.h"

namespace widgets {

using simcore::mobility::Advice;
using simcore::mobility::AdviceEnd;
using simcore::mobility::JointChange;
using simcore::mobility::Proposal;

namespace {

constexpr double kFirstLimit = 10.0;  // [s]
constexpr double kLonger = 6.0;       // how much longer the next search may take
constexpr int kTick_ms = 100;
constexpr int kProposalRole = Qt::UserRole;
constexpr int kChangeRole = Qt::UserRole + 1;

QTreeWidgetItem* proposalItem(const Proposal& proposal, int index) {
    auto* item = new QTreeWidgetItem(
        {QCoreApplication::translate("widgets::AdvisorPage", "%1: %2 changes")
             .arg(index + 1)
             .arg(proposal.changed),
         QString::number(proposal.cost), QString::number(proposal.margin, 'f', 2)});
    item->setData(0, kProposalRole, index);
    item->setData(0, kChangeRole, -1);
    item->setToolTip(0, QString::fromStdString(proposal.why));
    for (const int column : {1, 2}) {
        item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    for (std::size_t c = 0; c < proposal.changes.size(); ++c) {
        const QString text = changeText(proposal.changes[c]);
        auto* child = new QTreeWidgetItem(item, {text});
        child->setData(0, kProposalRole, index);
        child->setData(0, kChangeRole, static_cast<int>(c));
        child->setToolTip(0, text);
    }
    return item;
}

}  // namespace

AdvisorPage::AdvisorPage(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      headline_(new QLabel),
      text_(new QLabel),
      list_(new QTreeWidget),
      counts_(new QLabel),
      apply_(new QPushButton) {
    setAccessibleName(tr("Advisor"));
    headline_->setObjectName("advisorVerdict");
    headline_->setAccessibleName(tr("What the Advisor found"));
    headline_->setWordWrap(true);
    text_->setObjectName("advisorText");
    text_->setAccessibleName(tr("Advice in words"));
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    counts_->setObjectName("advisorCounts");
    counts_->setAccessibleName(tr("Counts with the proposal"));
    counts_->setWordWrap(true);
    apply_->setObjectName("advisorApply");
    apply_->setToolTip(tr("Make this the relaxed model of the project; the rover as built stays"));
    makeList();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(headline_);
    layout->addWidget(text_);
    layout->addWidget(makeButtons());
    layout->addWidget(list_, 1);
    layout->addWidget(counts_);
    layout->addWidget(apply_);
    layout->addStretch(0);
    tick_.setInterval(kTick_ms);
    connect(&tick_, &QTimer::timeout, this, &AdvisorPage::showProgress);
    connect(apply_, &QPushButton::clicked, this, &AdvisorPage::apply);
    connect(&session_, &AdvisorSession::changed, this, &AdvisorPage::refresh);
    connect(document_, &Document::changed, this,
            [this] { session_.setProject(document_->project()); });
    connect(document_, &Document::replaced, &session_, &AdvisorSession::forget);
    session_.setProject(document_->project());
}

QWidget* AdvisorPage::makeButtons() {
    start_ = new QPushButton;
    start_->setObjectName("advisorStart");
    start_->setToolTip(tr("Search joints that would leave nothing redundant (Ctrl+Shift+A)"));
    cancel_ = new QPushButton(tr("Cancel"));
    cancel_->setObjectName("advisorCancel");
    cancel_->setAccessibleName(tr("Cancel the search"));
    progress_ = new QProgressBar;
    progress_->setObjectName("advisorProgress");
    progress_->setAccessibleName(tr("Time of the search"));
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(start_, 1);
    layout->addWidget(progress_, 1);
    layout->addWidget(cancel_);
    connect(start_, &QPushButton::clicked, this, &AdvisorPage::search);
    connect(cancel_, &QPushButton::clicked, &session_, &AdvisorSession::cancel);
    return row;
}

void AdvisorPage::makeList() {
    list_->setObjectName("advisorList");
    list_->setAccessibleName(tr("Proposals"));
    list_->setHeaderLabels({tr("Proposal"), tr("Points"), tr("Margin")});
    list_->headerItem()->setToolTip(
        1, tr("What the changes cost: a ball 2, a ball with slide 5, a contact 1, ..."));
    list_->headerItem()->setToolTip(
        2, tr("0 to 1: a small one is barely exact, and magnifies errors of make"));
    for (const int column : {1, 2}) {
        list_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setMinimumHeight(90);
    list_->setIndentation(14);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionsMovable(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    connect(list_, &QTreeWidget::currentItemChanged, this, &AdvisorPage::choose);
}

void AdvisorPage::search() {
    if (session_.isWorking()) {
        return;
    }
    const Advice* last = session_.advice();
    const bool longer = last != nullptr && last->end == AdviceEnd::TimeUp && !session_.isStale();
    session_.start(longer ? kLonger * session_.limit() : kFirstLimit);
}

int AdvisorPage::selected() const {
    const QTreeWidgetItem* item = list_->currentItem();
    return item == nullptr ? -1 : item->data(0, kProposalRole).toInt();
}

void AdvisorPage::refresh() {
    const Advice* advice = session_.advice();
    const bool working = session_.isWorking();
    const bool timeUp = advice != nullptr && advice->end == AdviceEnd::TimeUp;
    start_->setVisible(!working);
    start_->setText(advice == nullptr               ? tr("Find exact joints")
                    : timeUp && !session_.isStale() ? tr("Search longer")
                                                    : tr("Search again"));
    progress_->setVisible(working);
    cancel_->setVisible(working);
    if (working) {
        tick_.start();
        showProgress();
    } else {
        tick_.stop();
    }
    showHeadline();
    fillList();
    const bool proposals = advice != nullptr && !advice->proposals.empty();
    for (QWidget* widget : std::initializer_list<QWidget*>{list_, counts_, apply_}) {
        widget->setVisible(proposals);
    }
    showSelected();
}

void AdvisorPage::showProgress() {
    progress_->setRange(0, static_cast<int>(1e3 * session_.limit()));
    progress_->setValue(std::min(progress_->maximum(), static_cast<int>(1e3 * session_.elapsed())));
    progress_->setFormat(tr("%1 s of at most %2 s")
                             .arg(session_.elapsed(), 0, 'f', 0)
                             .arg(session_.limit(), 0, 'f', 0));
}

void AdvisorPage::showHeadline() {
    const Advice* advice = session_.advice();
    QString level = "warning";
    QString headline;
    QString text;
    if (session_.isWorking()) {
        text = tr("Searching for joints to free. Edit the rover, and the search ends.");
    } else if (session_.wasInterrupted()) {
        headline = tr("The rover was edited: the search has ended");
    } else if (session_.isStale()) {
        headline = tr("For the rover before it was edited: search again");
    } else if (!session_.problems().empty()) {
        level = "bad";
        headline = tr("No advice");
        text = QString::fromStdString(toString(session_.problems()));
    } else if (advice != nullptr) {
        level = adviceLevel(*advice);
        headline = adviceHeadline(*advice);
        QStringList sentences{QString::fromStdString(describe(*advice))};
        for (const std::string& note : advice->notes) {
            sentences << QString::fromStdString(note);
        }
        text = sentences.join(' ');
    } else {
        text =
            tr("Which joints need more freedom so that nothing is redundant or idle, and the "
               "rover still moves as it does? The cheapest sets are proposed; one of them can "
               "become the relaxed model.");
    }
    headline_->setVisible(!headline.isEmpty());
    headline_->setText(headline);
    text_->setVisible(!text.isEmpty());
    text_->setText(text);
    if (headline_->property("level") != level) {
        headline_->setProperty("level", level);
        // A changed property shows only after the style is applied anew.
        headline_->style()->unpolish(headline_);
        headline_->style()->polish(headline_);
    }
}

void AdvisorPage::fillList() {
    const Advice* advice = session_.advice();
    if (advice == listed_ && advice != nullptr) {
        return;
    }
    listed_ = advice;
    const QSignalBlocker quiet(list_);
    list_->clear();
    if (advice == nullptr) {
        return;
    }
    for (int i = 0; i < static_cast<int>(advice->proposals.size()); ++i) {
        QTreeWidgetItem* item = proposalItem(advice->proposals[static_cast<std::size_t>(i)], i);
        list_->addTopLevelItem(item);
        for (int c = 0; c < item->childCount(); ++c) {
            item->child(c)->setFirstColumnSpanned(true);
        }
    }
    if (list_->topLevelItemCount() > 0) {
        list_->setCurrentItem(list_->topLevelItem(0));
        list_->topLevelItem(0)->setExpanded(true);
    }
}

void AdvisorPage::showSelected() {
    const Advice* advice = session_.advice();
    const int at = selected();
    const bool stale = session_.isStale();
    const int applied = session_.appliedProposal();
    list_->setEnabled(!stale);
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QFont font = list_->font();
        font.setBold(i == applied);
        list_->topLevelItem(i)->setFont(0, font);
    }
    if (advice != nullptr && at >= 0) {
        counts_->setText(proposalCounts(*advice, advice->proposals[static_cast<std::size_t>(at)]));
        counts_->setToolTip(
            QString::fromStdString(advice->proposals[static_cast<std::size_t>(at)].why));
    }
    counts_->setEnabled(!stale);
    apply_->setEnabled(at >= 0 && !stale && at != applied);
    apply_->setText(at >= 0 && at == applied ? tr("Proposal %1 is applied").arg(at + 1)
                                             : tr("Apply proposal %1").arg(at + 1));
    markSelected();
}

void AdvisorPage::choose(QTreeWidgetItem* item) {
    if (item == nullptr) {
        return;
    }
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        list_->topLevelItem(i)->setExpanded(i == selected());
    }
    list_->scrollToItem(item);
    showSelected();
    const int change = item->data(0, kChangeRole).toInt();
    if (change < 0) {
        return;
    }
    const JointChange& chosen = session_.advice()
                                    ->proposals[static_cast<std::size_t>(selected())]
                                    .changes[static_cast<std::size_t>(change)];
    const std::string& name = chosen.copies.front();
    if (chosen.wheel >= 0) {
        emit wheelChosen(QString::fromStdString(simcore::mobility::wheelOfContact(name)));
    } else {
        emit jointChosen(QString::fromStdString(name));
    }
}

void AdvisorPage::markSelected() {
    if (!active_) {
        return;
    }
    QStringList joints;
    QStringList wheels;
    const Advice* advice = session_.advice();
    if (advice != nullptr && !session_.isStale() && selected() >= 0) {
        for (const JointChange& change :
             advice->proposals[static_cast<std::size_t>(selected())].changes) {
            for (const std::string& copy : change.copies) {
                if (change.wheel >= 0) {
                    wheels << QString::fromStdString(simcore::mobility::wheelOfContact(copy));
                } else {
                    joints << QString::fromStdString(copy);
                }
            }
        }
    }
    emit marked(joints, wheels);
}

void AdvisorPage::apply() {
    const int proposal = selected();
    auto next = session_.withProposal(proposal);
    if (next) {
        document_->edit(tr("Apply proposal %1").arg(proposal + 1), std::move(next).value());
    }
}

void AdvisorPage::setActive(bool active) {
    if (active == active_) {
        return;
    }
    active_ = active;
    if (active_) {
        markSelected();
    } else {
        emit marked({}, {});
    }
}

}  // namespace widgets
