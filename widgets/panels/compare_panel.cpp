#include "widgets/panels/compare_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QStyle>
#include <QTableWidget>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "simcore/project/names.h"
#include "widgets/panels/compare_text.h"
#include "widgets/panels/statics_text.h"
#include "widgets/plots/wheel_plot.h"
#include "widgets/session/run_titles.h"

namespace widgets {

using simcore::experiment::Outcome;
using simcore::project::ControllerKind;

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr int kNameColumn = 0;
constexpr int kCurvesColumn = 1;
constexpr int kGhostColumn = 2;
/// Of the run on show.
constexpr int kShownId = 0;

/// A line of the table: what all runs came to by one measure.
struct Line {
    const char* name;
    const char* unit;
    const char* meaning;
    double Outcome::*value;
    double factor;
    int digits;
    bool lessIsBetter;
};

constexpr std::array kLines{
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "Time"), "s",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "Simulated time"), &Outcome::time, 1.0, 1,
         false},
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "Slip"), "mm",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "Absolute slip of all wheels"),
         &Outcome::slipAbs, 1e3, 1, true},
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "Loaded slip"), "mm",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "The same of wheels that carry load"),
         &Outcome::slipLoaded, 1e3, 1, true},
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "Friction work"), "J",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "Energy lost where something slides"),
         &Outcome::frictionWork, 1.0, 2, true},
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "Energy"), "J",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "Work of the drives"), &Outcome::energy, 1.0, 1,
         true},
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "Peak torque"), "N\u00b7m",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "Largest torque of any wheel"),
         &Outcome::peakTorque, 1.0, 2, true},
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "End x"), "m",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "Where the chassis' origin ended"),
         &Outcome::endX, 1.0, 3, false},
    Line{QT_TRANSLATE_NOOP("widgets::ComparePanel", "End y"), "m",
         QT_TRANSLATE_NOOP("widgets::ComparePanel", "Where the chassis' origin ended"),
         &Outcome::endY, 1.0, 3, false},
};

QString shortTitle(const RunSession& run) {
    return ComparePanel::tr("%1\nμ %2, %3")
        .arg(controllerTitle(run.settings().controller))
        .arg(run.settings().friction, 0, 'f', 2)
        .arg(engineTitle(run.settings().engine));
}

}  // namespace

ComparePanel::ComparePanel(RunSession* shown, RunLibrary* library, Experiment* experiment,
                           QWidget* parent)
    : QWidget(parent),
      shown_(shown),
      library_(library),
      experiment_(experiment) {
    setAccessibleName(tr("Compare runs"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(6);
    layout->addWidget(makeExperiment());
    layout->addWidget(makeRuns(), 1);
    const auto update = [this] {
        fillCells();
        showVerdict();
    };
    connect(shown_, &RunSession::runChanged, this, [this] {
        fillRuns();
        fillTable();
        showVerdict();
    });
    connect(shown_, &RunSession::stateChanged, this, update);
    connect(shown_, &RunSession::staleChanged, this, &ComparePanel::fillRuns);
    connect(shown_, &RunSession::finished, this, update);
    connect(shown_, &RunSession::dataAppended, this, &ComparePanel::fillCells);
    connect(library_, &RunLibrary::changed, this, [this] {
        fillRuns();
        fillTable();
        showVerdict();
    });
    connect(library_, &RunLibrary::dataChanged, this, &ComparePanel::fillCells);
    connect(experiment_, &Experiment::changed, this, update);
    fillRuns();
    fillTable();
    showVerdict();
}

QWidget* ComparePanel::makeExperiment() {
    first_ = new QLabel;
    first_->setObjectName("experimentFirst");
    first_->setAccessibleName(tr("First controller, chosen in the run bar"));
    first_->setToolTip(tr("Chosen in the run bar, as scenario, engine and friction"));
    QFont bold = first_->font();
    bold.setBold(true);
    first_->setFont(bold);
    rival_ = new QComboBox;
    rival_->setObjectName("experimentRival");
    rival_->setAccessibleName(tr("Second controller"));
    for (const std::string& name : simcore::project::allNames<ControllerKind>()) {
        const auto kind = *simcore::project::fromName<ControllerKind>(name);
        if (kind != ControllerKind::Manual) {
            rival_->addItem(controllerTitle(kind), static_cast<int>(kind));
        }
    }
    start_ = new QPushButton(tr("Run both"));
    start_->setObjectName("experimentStart");
    start_->setToolTip(
        tr("Drive the scenario with both controllers side by side; the second is shown pale"));
    connect(start_, &QPushButton::clicked, this, &ComparePanel::startRequested);
    verdict_ = new QLabel;
    verdict_->setObjectName("compareVerdict");
    verdict_->setAccessibleName(tr("Verdict"));
    verdict_->setWordWrap(true);
    details_ = new QLabel;
    details_->setObjectName("compareDetails");
    details_->setAccessibleName(tr("Verdict in detail"));
    details_->setWordWrap(true);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(first_);
    row->addWidget(new QLabel(tr("against")));
    row->addWidget(rival_, 1);
    row->addWidget(start_);
    auto* widget = new QWidget;
    auto* layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(verdict_);
    layout->addWidget(details_);
    return widget;
}

QWidget* ComparePanel::makeRuns() {
    runs_ = new QTreeWidget;
    runs_->setObjectName("runList");
    runs_->setAccessibleName(tr("Runs"));
    runs_->setRootIsDecorated(false);
    runs_->setAllColumnsShowFocus(true);
    runs_->setUniformRowHeights(true);
    runs_->setHeaderLabels({tr("Run"), tr("Curves"), tr("Ghost")});
    runs_->headerItem()->setToolTip(kCurvesColumn, tr("Its curves are drawn in the plots"));
    runs_->headerItem()->setToolTip(kGhostColumn,
                                    tr("Its rover is shown pale in the 3-D view, too"));
    runs_->header()->setStretchLastSection(false);
    runs_->header()->setSectionResizeMode(kNameColumn, QHeaderView::Stretch);
    for (const int column : {kCurvesColumn, kGhostColumn}) {
        runs_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    runs_->setIconSize({30, 12});
    connect(runs_, &QTreeWidget::itemChanged, this, &ComparePanel::onItemChanged);
    connect(runs_, &QTreeWidget::itemSelectionChanged, this, &ComparePanel::updateButtons);
    const auto button = [](const QString& text, const QString& name, const QString& tip) {
        auto* one = new QPushButton(text);
        one->setObjectName(name);
        one->setToolTip(tip);
        return one;
    };
    keep_ = button(tr("Keep run"), "keepRun",
                   tr("Hold a copy of the run on show, to compare the next with it (Ctrl+K)"));
    QPushButton* add = button(tr("Add..."), "addRecording",
                              tr("Hold a recording beside these runs; the project stays"));
    save_ = button(tr("Save..."), "saveRun", tr("Save the selected run as a recording"));
    remove_ = button(tr("Remove"), "removeRun", tr("Drop the selected run"));
    copy_ = button(tr("Copy table"), "copyTable", tr("For a spreadsheet"));
    connect(keep_, &QPushButton::clicked, this, &ComparePanel::keepRequested);
    connect(add, &QPushButton::clicked, this, &ComparePanel::addRequested);
    connect(save_, &QPushButton::clicked, this, &ComparePanel::saveSelected);
    connect(remove_, &QPushButton::clicked, this, &ComparePanel::removeSelected);
    connect(copy_, &QPushButton::clicked, this, &ComparePanel::copyTable);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    buttons->addWidget(keep_);
    buttons->addWidget(add);
    buttons->addWidget(save_);
    buttons->addWidget(remove_);
    buttons->addStretch(1);
    buttons->addWidget(copy_);
    table_ = new QTableWidget;
    table_->setObjectName("compareTable");
    table_->setAccessibleName(tr("What the runs came to"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setCornerButtonEnabled(false);
    table_->setShowGrid(false);
    table_->setAlternatingRowColors(true);
    fitLines();
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    hint_ = new QLabel(
        tr("Drive a scenario, keep the run, drive again: the two stand side by side here."));
    hint_->setObjectName("compareHint");
    hint_->setAccessibleName(tr("How to compare runs"));
    hint_->setWordWrap(true);
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setEnabled(false);
    auto* widget = new QWidget;
    auto* layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(runs_);
    layout->addLayout(buttons);
    aside_ = new QLabel;
    aside_->setObjectName("compareAside");
    aside_->setAccessibleName(tr("Runs out of sight"));
    aside_->setAlignment(Qt::AlignRight);
    aside_->setEnabled(false);
    aside_->hide();
    const auto tellAside = [this] {
        const auto* bar = table_->horizontalScrollBar();
        const bool cut = table_->isVisible() && bar->maximum() > 0;
        aside_->setVisible(cut);
        aside_->setText(bar->value() < bar->maximum() ? tr("More runs to the right \u2192")
                                                      : tr("\u2190 More runs to the left"));
    };
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    connect(table_->horizontalScrollBar(), &QScrollBar::rangeChanged, this, tellAside);
    connect(table_->horizontalScrollBar(), &QScrollBar::valueChanged, this, tellAside);
    layout->addWidget(aside_);
    layout->addWidget(table_, 1);
    layout->addWidget(hint_, 1);
    return widget;
}

ControllerKind ComparePanel::rival() const {
    return static_cast<ControllerKind>(rival_->currentData().toInt());
}

void ComparePanel::setRival(ControllerKind kind) {
    rival_->setCurrentIndex(rival_->findData(static_cast<int>(kind)));
}

void ComparePanel::setController(ControllerKind kind) {
    first_->setText(controllerTitle(kind));
    // Nobody holds a controller against itself.
    if (kind == rival()) {
        setRival(kind == ControllerKind::Speed ? ControllerKind::Hybrid : ControllerKind::Speed);
    }
}

int ComparePanel::idOf(const QTreeWidgetItem* item) const {
    return item->data(kNameColumn, kIdRole).toInt();
}

void ComparePanel::fillRuns() {
    filling_ = true;
    const int selected = runs_->currentItem() != nullptr ? idOf(runs_->currentItem()) : kShownId;
    runs_->clear();
    const auto add = [&](int id, int style, const QString& name, bool stale) {
        auto* item = new QTreeWidgetItem(runs_);
        item->setData(kNameColumn, kIdRole, id);
        item->setIcon(kNameColumn, QIcon(lineSample(style, palette().color(QPalette::Text))));
        item->setText(kNameColumn, stale ? tr("%1 (older design)").arg(name) : name);
        item->setToolTip(kNameColumn,
                         stale ? tr("The design or the settings have changed since") : name);
        if (id == selected) {
            runs_->setCurrentItem(item);
        }
        return item;
    };
    if (shown_->hasRun()) {
        QTreeWidgetItem* item = add(kShownId, 0, runTitle(shown_->settings()), shown_->isStale());
        item->setToolTip(kNameColumn, tr("The run on show"));
        QFont bold = font();
        bold.setBold(true);
        item->setFont(kNameColumn, bold);
    }
    for (const HeldRun& run : library_->runs()) {
        QTreeWidgetItem* item = add(run.id, run.style, run.name, run.stale);
        item->setCheckState(kCurvesColumn, run.curves ? Qt::Checked : Qt::Unchecked);
        item->setCheckState(kGhostColumn,
                            run.id == library_->ghost() ? Qt::Checked : Qt::Unchecked);
    }
    // As high as its lines: the table below needs the room.
    constexpr int kFewestLines = 2;
    const int lines = std::max(kFewestLines, runs_->topLevelItemCount()) + 1;
    runs_->setFixedHeight(lines * (fontMetrics().height() + 6) + 4);
    keep_->setEnabled(shown_->hasRun());
    updateButtons();
    filling_ = false;
}

void ComparePanel::onItemChanged(QTreeWidgetItem* item, int column) {
    if (filling_) {
        return;
    }
    const int id = idOf(item);
    const bool on = item->checkState(column) == Qt::Checked;
    // Later: the list that sends this is about to be filled anew.
    QMetaObject::invokeMethod(
        this,
        [this, id, column, on] {
            if (column == kCurvesColumn) {
                library_->setCurves(id, on);
            } else if (column == kGhostColumn) {
                library_->setGhost(on ? id : 0);
            }
        },
        Qt::QueuedConnection);
}

void ComparePanel::removeSelected() {
    if (runs_->currentItem() != nullptr) {
        library_->remove(idOf(runs_->currentItem()));
    }
}

void ComparePanel::saveSelected() {
    const int id = runs_->currentItem() != nullptr ? idOf(runs_->currentItem()) : -1;
    const int index = library_->find(id);
    if (id == kShownId) {
        emit saveRequested(*shown_);
    } else if (index >= 0) {
        emit saveRequested(*library_->runs()[static_cast<std::size_t>(index)].session);
    }
}

void ComparePanel::updateButtons() {
    const int id = runs_->currentItem() != nullptr ? idOf(runs_->currentItem()) : -1;
    save_->setEnabled(id >= 0);
    remove_->setEnabled(id > 0);
}

void ComparePanel::fillTable() {
    columns_.clear();
    if (shown_->hasRun()) {
        columns_.push_back(shown_);
    }
    for (const HeldRun& run : library_->runs()) {
        columns_.push_back(run.session.get());
    }
    const bool any = !columns_.empty();
    table_->setVisible(any);
    hint_->setVisible(!any);
    copy_->setEnabled(any);
    table_->setColumnCount(static_cast<int>(columns_.size()));
    table_->setRowCount(static_cast<int>(kLines.size()) + 1);
    QStringList heads;
    for (const RunSession* run : columns_) {
        heads << shortTitle(*run);
    }
    table_->setHorizontalHeaderLabels(heads);
    QStringList names{tr("Ended")};
    for (const Line& line : kLines) {
        names << QString("%1 [%2]").arg(tr(line.name), QString::fromUtf8(line.unit));
    }
    table_->setVerticalHeaderLabels(names);
    for (std::size_t i = 0; i < kLines.size(); ++i) {
        table_->verticalHeaderItem(static_cast<int>(i) + 1)->setToolTip(tr(kLines.at(i).meaning));
    }
    for (int column = 0; column < table_->columnCount(); ++column) {
        for (int row = 0; row < table_->rowCount(); ++row) {
            auto* item = new QTableWidgetItem;
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(row, column, item);
        }
    }
    table_->horizontalHeader()->setSectionResizeMode(
        columns_.size() > 2 ? QHeaderView::ResizeToContents : QHeaderView::Stretch);
    fillCells();
}

void ComparePanel::fillCells() {
    std::vector<Outcome> outcomes;
    for (const RunSession* run : columns_) {
        if (!run->hasRun()) {
            return;  // dropped just now: others heard of it first, the table is about to be made
                     // anew
        }
        outcomes.push_back(outcomeOf(*run));
    }
    const bool allEnded =
        outcomes.size() > 1 &&
        std::all_of(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return o.completed; });
    for (std::size_t column = 0; column < outcomes.size(); ++column) {
        const int c = static_cast<int>(column);
        table_->item(0, c)->setText(endText(outcomes[column]));
        for (std::size_t i = 0; i < kLines.size(); ++i) {
            const Line& line = kLines.at(i);
            const auto of = [&](const Outcome& o) { return line.factor * (o.*line.value); };
            QTableWidgetItem* item = table_->item(static_cast<int>(i) + 1, c);
            item->setText(numberText(of(outcomes[column]), line.digits));
            // What reads alike is no better.
            const auto best = [&] {
                const bool less = std::all_of(outcomes.begin(), outcomes.end(), [&](const auto& o) {
                    return of(o) >= of(outcomes[column]);
                });
                const bool differs = std::any_of(outcomes.begin(), outcomes.end(), [&](auto& o) {
                    return numberText(of(o), line.digits) != item->text();
                });
                return allEnded && line.lessIsBetter && less && differs;
            };
            QFont face = font();
            face.setBold(best());
            item->setFont(face);
        }
    }
}

void ComparePanel::showVerdict() {
    const RunSession* rival = experiment_->rival();
    const auto verdict = experiment_->verdict();
    verdict_->setVisible(verdict.has_value());
    details_->setVisible(rival != nullptr);
    if (!verdict) {
        if (rival != nullptr) {
            details_->setText(
                shown_->state() == RunSession::State::Finished
                    ? tr("%1 still drives...").arg(controllerTitle(rival->settings().controller))
                    : tr("Both drive; the pale rover is %1.")
                          .arg(controllerTitle(rival->settings().controller)));
        }
        return;
    }
    const VerdictText text = verdictText(outcomeOf(*shown_), outcomeOf(*rival), *verdict,
                                         controllerTitle(shown_->settings().controller),
                                         controllerTitle(rival->settings().controller));
    verdict_->setText(text.headline);
    details_->setText(text.details);
    verdict_->setProperty("level", text.level == VerdictLevel::Good      ? "good"
                                   : text.level == VerdictLevel::Warning ? "warning"
                                                                         : "bad");
    // A changed property shows only after the style is applied anew.
    verdict_->style()->unpolish(verdict_);
    verdict_->style()->polish(verdict_);
}

void ComparePanel::copyTable() {
    QStringList lines;
    QStringList row{QString()};
    for (const RunSession* run : columns_) {
        row << runTitle(run->settings());
    }
    lines << row.join('\t');
    for (int r = 0; r < table_->rowCount(); ++r) {
        row = {table_->verticalHeaderItem(r)->text()};
        for (int c = 0; c < table_->columnCount(); ++c) {
            // Spreadsheets know the plain minus only.
            row << table_->item(r, c)->text().replace(QChar(0x2212), '-');
        }
        lines << row.join('\t');
    }
    QApplication::clipboard()->setText(lines.join('\n'));
}

void ComparePanel::fitLines() {
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 7);
}

void ComparePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && runs_ != nullptr) {
        fillRuns();
    } else if (event->type() == QEvent::FontChange && table_ != nullptr) {
        fitLines();
        fillRuns();
    }
    QWidget::changeEvent(event);
}

}  // namespace widgets
