#include "widgets/panels/mobility_panel.h"
#include "widgets/panels/mobility_text.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/panels/advisor_page.h"
#include "widgets/panels/mobility_list.h"
#include "widgets/panels/motion_page.h"

namespace widgets {

using simcore::mobility::Model;
using simcore::mobility::Report;

namespace {

constexpr int kWhole = 0;  // in the list of scopes
constexpr int kSelection = 1;

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
      scope_(new QComboBox(this)),
      list_(new MobilityList(this)) {
    headline_->setObjectName("headline");
    headline_->setWordWrap(true);
    headline_->setAccessibleName(tr("Verdict on mobility"));
    verdict_->setObjectName("mobilityVerdict");
    verdict_->setAccessibleName(tr("Verdict on mobility, in words"));
    verdict_->setWordWrap(true);
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    unavailable_->setWordWrap(true);
    unavailable_->setAlignment(Qt::AlignCenter);
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

    connect(list_, &MobilityList::jointChosen, this, [this](const QString& joint) {
        const auto& mechanism = document_->derived().mechanism;
        emit jointChosen(mechanism ? mechanism->findJoint(joint.toStdString()) : -1);
    });
    connect(list_, &MobilityList::wheelChosen, this, [this](const QString& wheel) {
        const auto& mechanism = document_->derived().mechanism;
        const int index = mechanism ? mechanism->findWheel(wheel.toStdString()) : -1;
        if (index >= 0) {
            emit jointChosen(-1);
            emit wheelChosen(index);
        }
    });
    connect(list_, &MobilityList::marked, this, &MobilityPanel::marked);
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
    if (!active_ || page != static_cast<int>(Page::Counts)) {
        list_->unmark();
    }
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

void MobilityPanel::buildTable(QGridLayout* grid) {
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(0, 1);
    scope_->addItem(tr("Whole rover"));
    scope_->addItem(tr("Selection"));
    scope_->setObjectName("mobilityScope");
    scope_->setAccessibleName(tr("What the counts are of"));
    scope_->setToolTip(
        tr("The whole rover, or only the parts selected in the tree and the joints between them"));
    grid->addWidget(scope_, 0, 0);
    connect(scope_, &QComboBox::currentIndexChanged, this, &MobilityPanel::refresh);
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
    return reports_.at(static_cast<std::size_t>(model_));
}

void MobilityPanel::setSelection(const std::vector<simcore::project::ElementRef>& selection) {
    if (selection == selection_) {
        return;
    }
    selection_ = selection;
    if (scope_->currentIndex() == kSelection) {
        refresh();
    }
}

void MobilityPanel::analyse() {
    const auto& derived = document_->derived();
    part_.reset();
    if (scope_->currentIndex() == kWhole) {
        reports_ = {derived.built, derived.relaxed};
        return;
    }
    // An edit may have taken what was selected, before the tree says so.
    std::vector<simcore::project::ElementRef> there;
    std::copy_if(selection_.begin(), selection_.end(), std::back_inserter(there),
                 [this](const auto& element) {
                     return element.index < countOf(document_->project(), element.kind);
                 });
    const auto& mechanism = *derived.mechanism;
    part_ = simcore::mobility::partOf(
        mechanism, simcore::mobility::drawnStance(mechanism),
        simcore::mobility::selectionOf(document_->project(), mechanism, there));
    for (const Model model : {Model::Built, Model::Relaxed}) {
        reports_.at(static_cast<std::size_t>(model)) =
            part_->constraints == 0
                ? Report()
                : simcore::mobility::analyse(part_->mechanism, model, part_->stance);
    }
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
    analyse();
    showTable();
    showList();
}

void MobilityPanel::showTable() {
    const bool counted = !part_ || part_->constraints > 0;
    for (std::size_t model = 0; model < 2; ++model) {
        const Report& r = reports_.at(model);
        const std::array<QString, kQuantities> texts{
            signedNumber(r.gruebler), tr("%1, %2").arg(r.bodies).arg(r.joints),
            QString::number(r.rows),  QString::number(r.rank),
            signedNumber(r.mobility), QString::number(r.redundant)};
        for (std::size_t i = 0; i < kQuantities; ++i) {
            QLabel* cell = cells_.at(i).at(model);
            const bool key = i == Gruebler || i == Mobility || i == Redundant;
            const QString text = !counted ? QString(QChar(0x2013))
                                 : key    ? "<b>" + texts.at(i) + "</b>"
                                          : texts.at(i);
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
    if (!counted) {
        level.clear();
        headline = tr("Nothing to count");
    } else if (r.mobility < 1 && !part_) {
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
    verdict_->setText(!counted ? tr("Select parts that a joint connects, a joint, or a wheel with "
                                    "its contact: in the tree with Ctrl, or in the 3-D view.")
                      : part_  ? partVerdict(*part_, r)
                               : mobilityVerdict(r));
}

void MobilityPanel::showList() {
    const auto& mechanism = document_->derived().mechanism;
    if (!part_) {
        list_->show(*mechanism, simcore::mobility::drawnStance(*mechanism), report());
    } else if (part_->constraints > 0) {
        list_->show(part_->mechanism, part_->stance, report());
    }
    list_->setVisible(!part_ || part_->constraints > 0);
}

void MobilityPanel::selectJoint(int joint) {
    const auto& mechanism = document_->derived().mechanism;
    list_->selectElement(
        joint >= 0 && mechanism
            ? QString::fromStdString(mechanism->joints.at(static_cast<std::size_t>(joint)).name)
            : QString());
}

}  // namespace widgets
