#include "widgets/panels/mobility_panel.h"
#include "widgets/panels/mobility_text.h"

#include <QButtonGroup>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "widgets/panels/advisor_page.h"
#include "widgets/panels/motion_page.h"

namespace widgets {

using simcore::mobility::ConstraintName;
using simcore::mobility::Model;
using simcore::mobility::Report;

namespace {

constexpr int kJointRole = Qt::UserRole;
constexpr int kWheelRole = Qt::UserRole + 1;
constexpr int kShareRole = Qt::UserRole + 2;

/// A number with a true minus sign, and a plus where the sign matters.
QString signedNumber(int n) {
    return n < 0 ? QString(QChar(0x2212)) + QString::number(-n)
                 : (n > 0 ? "+" : "") + QString::number(n);
}

QString directionText(const simcore::Vec3& d) {
    static constexpr std::array kAxes{"x", "y", "z"};
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (std::abs(d[i]) > 0.9999) {
            return kAxes.at(static_cast<std::size_t>(i));
        }
    }
    return QString("(%1, %2, %3)")
        .arg(d.x(), 0, 'f', 2)
        .arg(d.y(), 0, 'f', 2)
        .arg(d.z(), 0, 'f', 2);
}

QString constraintText(const ConstraintName& constraint) {
    const QString direction = directionText(constraint.direction);
    if (constraint.kind == "turn") {
        return MobilityPanel::tr("holds the turn about %1").arg(direction);
    }
    if (constraint.kind == "gear") {
        return MobilityPanel::tr("couples two joints");
    }
    return MobilityPanel::tr("holds the slide along %1").arg(direction);
}

/// Draws a share from 0 to 1 as a bar with its percentage.
class ShareDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const QVariant share = index.data(kShareRole);
        if (!share.isValid()) {
            return;
        }
        const QRectF place =
            QRectF(option.rect)
                .adjusted(4, 6, -4 - option.fontMetrics.horizontalAdvance("100 %"), -6);
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        QColor color =
            option.palette.color(selected ? QPalette::HighlightedText : QPalette::Highlight);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        color.setAlphaF(0.25F);
        painter->setBrush(color);
        painter->drawRoundedRect(place, 2, 2);
        color.setAlphaF(1.0F);
        painter->setBrush(color);
        QRectF filled = place;
        filled.setWidth(place.width() * std::clamp(share.toDouble(), 0.0, 1.0));
        painter->drawRoundedRect(filled, 2, 2);
        painter->setPen(
            option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        painter->drawText(QRectF(option.rect).adjusted(0, 0, -4, 0),
                          Qt::AlignRight | Qt::AlignVCenter,
                          QString("%1 %").arg(100.0 * share.toDouble(), 0, 'f', 0));
        painter->restore();
    }
};

QString jointsTooltip(const Report& report) {
    QString text = MobilityPanel::tr("Joints by their freedoms, wheel contacts counted:");
    for (std::size_t i = 0; i < report.jointsByFreedom.size(); ++i) {
        text += QString("\nf%1 = %2").arg(i + 1).arg(report.jointsByFreedom[i]);
    }
    return text;
}

}  // namespace

MobilityPanel::MobilityPanel(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      models_(new QButtonGroup(this)),
      pageButtons_(new QButtonGroup(this)),
      pages_(new QStackedWidget),
      advisor_(new AdvisorPage(document)),
      motions_(new MotionPage(document)),
      content_(new QWidget(this)),
      unavailable_(new QLabel(this)),
      headline_(new QLabel(this)),
      verdict_(new QLabel(this)),
      listTitle_(new QLabel(this)),
      list_(new QTreeWidget(this)) {
    headline_->setObjectName("headline");
    headline_->setWordWrap(true);
    headline_->setAccessibleName(tr("Verdict on mobility"));
    verdict_->setObjectName("mobilityVerdict");
    verdict_->setAccessibleName(tr("Verdict on mobility, in words"));
    verdict_->setWordWrap(true);
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    unavailable_->setWordWrap(true);
    unavailable_->setAlignment(Qt::AlignCenter);
    listTitle_->setWordWrap(true);
    listTitle_->setToolTip(tr(
        "Removing any one of these gives no new motion. The bar is the "
        "constraint's share in the self-stress, forces λ with Jᵀλ = 0 and no load: 100 % is wholly "
        "redundant."));

    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setObjectName("removableList");
    list_->setAccessibleName(tr("Removable constraints"));
    list_->setMinimumHeight(4 * fontMetrics().height());
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
    fitShares();
    list_->setItemDelegateForColumn(1, new ShareDelegate(list_));

    auto* table = new QWidget;
    auto* grid = new QGridLayout(table);
    grid->setContentsMargins(0, 0, 0, 0);
    buildTable(grid);

    auto* counts = new QWidget;
    auto* layout = new QVBoxLayout(counts);
    layout->setContentsMargins(8, 6, 8, 0);
    layout->setSpacing(6);
    layout->addWidget(headline_);
    layout->addWidget(table);
    layout->addWidget(verdict_);
    layout->addWidget(listTitle_);
    layout->addWidget(list_, 1);
    // In a low window, or with large text, one scrolls rather than reads squeezed lines.
    auto* scroll = new QScrollArea;
    scroll->setObjectName("countsScroll");
    scroll->setAccessibleName(tr("Counts"));
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(counts);
    scroll->setMinimumWidth(counts->minimumSizeHint().width());
    for (QWidget* page : std::initializer_list<QWidget*>{scroll, advisor_, motions_}) {
        pages_->addWidget(page);
    }
    auto* inner = new QVBoxLayout(content_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(0);
    inner->addWidget(makePageButtons());
    inner->addWidget(pages_, 1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(content_, 1);
    outer->addWidget(unavailable_, 1);

    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!refreshing_ && item != nullptr) {
            emit jointChosen(item->data(0, kJointRole).toInt());
            if (item->data(0, kWheelRole).toInt() >= 0) {
                emit wheelChosen(item->data(0, kWheelRole).toInt());
            }
        }
    });
    connect(document_, &Document::changed, this, &MobilityPanel::refresh);
    connectPages();
    refresh();
}

QWidget* MobilityPanel::makePageButtons() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(8, 4, 8, 0);
    layout->setSpacing(4);
    const auto add = [&](Page page, const QString& text, const QString& name, const QString& tip) {
        auto* button = new QPushButton(text);
        button->setCheckable(true);
        button->setFlat(true);
        button->setObjectName(name);
        button->setToolTip(tip);
        pageButtons_->addButton(button, static_cast<int>(page));
        layout->addWidget(button, 1);
    };
    add(Page::Counts, tr("Counts"), "pageCounts", tr("How much it moves, and what is redundant"));
    add(Page::Advisor, tr("Exact joints"), "pageAdvisor",
        tr("Which joints to free so that nothing is redundant"));
    add(Page::Motions, tr("Free motions"), "pageMotions", tr("How it moves, to look at"));
    pageButtons_->button(0)->setChecked(true);
    connect(pageButtons_, &QButtonGroup::idClicked, this, &MobilityPanel::showPage);
    return row;
}

void MobilityPanel::setPage(Page page) {
    pageButtons_->button(static_cast<int>(page))->setChecked(true);
    showPage();
}

void MobilityPanel::setActive(bool active) {
    active_ = active;
    showPage();
}

void MobilityPanel::showPage() {
    const int page = pageButtons_->checkedId();
    pages_->setCurrentIndex(page);
    const bool advisor = active_ && page == static_cast<int>(Page::Advisor);
    const bool motions = active_ && page == static_cast<int>(Page::Motions);
    // The one that leaves goes first: what it marked must not end what the other marks.
    if (advisor) {
        motions_->setActive(false);
        advisor_->setActive(true);
    } else {
        advisor_->setActive(false);
        motions_->setActive(motions);
    }
}

void MobilityPanel::connectPages() {
    connect(motions_, &MotionPage::modelChosen, this, &MobilityPanel::setModel);
    connect(motions_, &MotionPage::marked, this,
            [this](const QStringList& joints, const QString& body) {
                emit marked(joints, body.isEmpty() ? QStringList() : QStringList{body});
            });
    const auto& derived = document_->derived();
    connect(advisor_, &AdvisorPage::marked, this,
            [this, &derived](const QStringList& joints, const QStringList& wheels) {
                QStringList bodies;
                for (const QString& wheel : wheels) {
                    const int index =
                        derived.mechanism ? derived.mechanism->findWheel(wheel.toStdString()) : -1;
                    if (index >= 0) {
                        const auto at = static_cast<std::size_t>(index);
                        const auto body =
                            static_cast<std::size_t>(derived.mechanism->wheels[at].body);
                        bodies << QString::fromStdString(derived.mechanism->bodies[body].name);
                    }
                }
                emit marked(joints, bodies);
            });
    connect(advisor_, &AdvisorPage::jointChosen, this, [this, &derived](const QString& joint) {
        emit jointChosen(derived.mechanism ? derived.mechanism->findJoint(joint.toStdString())
                                           : -1);
    });
    connect(advisor_, &AdvisorPage::wheelChosen, this, [this, &derived](const QString& wheel) {
        const int index =
            derived.mechanism ? derived.mechanism->findWheel(wheel.toStdString()) : -1;
        if (index >= 0) {
            emit wheelChosen(index);
        }
    });
}

/// The bar of a share and its number.
void MobilityPanel::fitShares() {
    list_->setColumnWidth(1, 66 + fontMetrics().horizontalAdvance("100 %"));
}

void MobilityPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange && list_ != nullptr) {
        fitShares();
    }
    QWidget::changeEvent(event);
}

void MobilityPanel::buildTable(QGridLayout* grid) {
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(0, 1);
    static constexpr std::array kNames{QT_TR_NOOP("As built"), QT_TR_NOOP("Relaxed")};
    static constexpr std::array kTips{
        QT_TR_NOOP("Every joint with the freedoms it has in the rover"),
        QT_TR_NOOP("With the extra freedoms that the project gives joints for statics")};
    for (int model = 0; model < 2; ++model) {
        auto* button = new QPushButton(tr(kNames.at(static_cast<std::size_t>(model))));
        button->setCheckable(true);
        button->setFlat(true);
        button->setObjectName(model == 0 ? "modelBuilt" : "modelRelaxed");
        button->setToolTip(tr(kTips.at(static_cast<std::size_t>(model))));
        models_->addButton(button, model);
        grid->addWidget(button, 0, model + 1);
    }
    models_->button(0)->setChecked(true);
    connect(models_, &QButtonGroup::idClicked, this,
            [this](int model) { setModel(static_cast<Model>(model)); });

    struct Line {
        const char* label;
        const char* tip;
    };

    static constexpr std::array<Line, kQuantities> kLines{{
        {QT_TR_NOOP("Grübler count"),
         QT_TR_NOOP(
             "6 n minus the constraints: what counting alone says. Lamon et al. 2004, equation 1")},
        {QT_TR_NOOP("Bodies, joints"),
         QT_TR_NOOP("Welded parts merged; wheel contacts and differentials counted as joints")},
        {QT_TR_NOOP("Constraints"), QT_TR_NOOP("Rows of the constraint Jacobian")},
        {QT_TR_NOOP("Rank"), QT_TR_NOOP("Constraints that are independent of each other: rank of "
                                        "the Jacobian J with J v = 0")},
        {QT_TR_NOOP("Mobility"), QT_TR_NOOP("Freedoms the rover truly has: 6 n − rank J")},
        {QT_TR_NOOP("Redundant"), QT_TR_NOOP("Constraints minus rank: 0 = statically determinate")},
    }};
    for (int i = 0; i < kQuantities; ++i) {
        const Line& line = kLines.at(static_cast<std::size_t>(i));
        auto* label = new QLabel(tr(line.label));
        label->setToolTip(tr(line.tip));
        label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
        grid->addWidget(label, i + 1, 0);
        for (int model = 0; model < 2; ++model) {
            auto* cell = new QLabel;
            cell->setAlignment(Qt::AlignCenter);
            cell->setToolTip(tr(line.tip));
            cell->setAccessibleName(tr(line.label) + ", " +
                                    tr(kNames.at(static_cast<std::size_t>(model))));
            cell->setObjectName(QString("mobility:%1:%2").arg(i).arg(model));
            cells_.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(model)) = cell;
            grid->addWidget(cell, i + 1, model + 1);
        }
    }
}

const Report& MobilityPanel::report() const {
    return model_ == Model::Built ? document_->derived().built : document_->derived().relaxed;
}

void MobilityPanel::setModel(Model model) {
    model_ = model;
    models_->button(static_cast<int>(model))->setChecked(true);
    motions_->setModel(model);
    refresh();
    emit modelChanged();
}

void MobilityPanel::refresh() {
    const bool available = document_->derived().mechanism.has_value();
    content_->setVisible(available);
    unavailable_->setVisible(!available);
    if (!available) {
        unavailable_->setText(
            tr("Mobility cannot be worked out: the project has problems.\nThey are listed under "
               "Problems."));
        return;
    }
    showTable();
    showConstraints();
}

void MobilityPanel::showTable() {
    const std::array<const Report*, 2> reports{&document_->derived().built,
                                               &document_->derived().relaxed};
    for (std::size_t model = 0; model < 2; ++model) {
        const Report& r = *reports.at(model);
        const std::array<QString, kQuantities> texts{
            signedNumber(r.gruebler), tr("%1, %2").arg(r.bodies).arg(r.joints),
            QString::number(r.rows),  QString::number(r.rank),
            signedNumber(r.mobility), QString::number(r.redundant)};
        for (std::size_t i = 0; i < kQuantities; ++i) {
            QLabel* cell = cells_.at(i).at(model);
            const bool key = i == Gruebler || i == Mobility || i == Redundant;
            const QString text = key ? "<b>" + texts.at(i) + "</b>" : texts.at(i);
            if (cell->text() != text) {
                cell->setText(text);
            }
            cell->setEnabled(static_cast<int>(model) == static_cast<int>(model_));
        }
        cells_[Parts].at(model)->setToolTip(jointsTooltip(r));
    }
    const Report& r = report();
    QString level = "good";
    QString headline = tr("Statically determinate");
    if (r.mobility < 1) {
        level = "bad";
        headline = tr("Cannot move");
    } else if (r.redundant > 0) {
        level = "warning";
        headline = r.redundant == 1 ? tr("Hyperstatic: 1 redundant constraint")
                                    : tr("Hyperstatic: %1 redundant constraints").arg(r.redundant);
    } else if (r.mobility > 1 && !r.idle.empty()) {
        headline = r.idle.size() == 1 ? tr("Determinate, 1 idle freedom")
                                      : tr("Determinate, %1 idle freedoms").arg(r.idle.size());
    }
    headline_->setText(headline);
    if (headline_->property("level") != level) {
        headline_->setProperty("level", level);
        // A changed property shows only after the style is applied anew.
        headline_->style()->unpolish(headline_);
        headline_->style()->polish(headline_);
    }
    verdict_->setText(mobilityVerdict(r));
}

void MobilityPanel::showConstraints() {
    refreshing_ = true;
    const int chosen =
        list_->currentItem() ? list_->currentItem()->data(0, kJointRole).toInt() : -2;
    std::map<QString, bool> expanded;
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        expanded[list_->topLevelItem(i)->text(0)] = list_->topLevelItem(i)->isExpanded();
    }
    list_->clear();
    const Report& r = report();
    listTitle_->setVisible(r.redundant > 0);
    list_->setVisible(r.redundant > 0);
    listTitle_->setText(tr("<b>%1 removable constraints</b>: any one may go, %2 of them together")
                            .arg(r.removable.size())
                            .arg(r.redundant));
    QList<QTreeWidgetItem*> groups;
    std::map<std::string, QTreeWidgetItem*> byElement;
    for (const ConstraintName& constraint : r.removable) {
        QTreeWidgetItem*& group = byElement[constraint.element];
        if (group == nullptr) {
            group = new QTreeWidgetItem({QString::fromStdString(constraint.element)});
            group->setData(0, kJointRole, constraint.joint);
            group->setData(0, kWheelRole, constraint.wheel);
            group->setToolTip(0, group->text(0));
            groups << group;
        }
        auto* item = new QTreeWidgetItem(group, {constraintText(constraint)});
        item->setData(0, kJointRole, constraint.joint);
        item->setData(0, kWheelRole, constraint.wheel);
        item->setData(1, kShareRole, constraint.share);
    }
    for (QTreeWidgetItem* group : groups) {
        double largest = 0.0;
        for (int i = 0; i < group->childCount(); ++i) {
            largest = std::max(largest, group->child(i)->data(1, kShareRole).toDouble());
        }
        group->setData(1, kShareRole, largest);
    }
    list_->addTopLevelItems(groups);
    for (QTreeWidgetItem* group : groups) {
        group->setExpanded(expanded[group->text(0)]);
    }
    refreshing_ = false;
    if (chosen >= 0) {
        selectJoint(chosen);
    }
}

void MobilityPanel::selectJoint(int joint) {
    refreshing_ = true;
    const auto& mechanism = document_->derived().mechanism;
    QTreeWidgetItem* found = nullptr;
    for (int i = 0; i < list_->topLevelItemCount() && joint >= 0 && mechanism; ++i) {
        if (list_->topLevelItem(i)->data(0, kJointRole).toInt() == joint) {
            found = list_->topLevelItem(i);
        }
    }
    list_->setCurrentItem(found);
    if (found != nullptr) {
        list_->scrollToItem(found);
    }
    refreshing_ = false;
}

}  // namespace widgets
