#include "widgets/plots/plot_panel.h"

#include <qcustomplot.h>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QPdfWriter>
#include <QPushButton>
#include <QSaveFile>
#include <QSettings>
#include <QSvgGenerator>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "simcore/base/text.h"
#include "simcore/io/csv.h"
#include "widgets/plots/export_dialog.h"
#include "widgets/plots/wheel_marks.h"
#include "widgets/plots/wheel_plot.h"
#include "widgets/session/may_replace.h"
#include "widgets/session/run_titles.h"

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;

namespace {

constexpr int kMaxPlots = 4;
constexpr int kLeastChooser = 120;  ///< [px]; long names are cut in a narrow plot
constexpr int kReplotPeriod_ms = 80;
constexpr std::array kFirstChoice{"slip_abs", "torque_applied", "normal_force", "contact_angle"};
constexpr double kWholeRun = 0.0;
constexpr double kFree = -1.0;

/// Short enough for a table cell.
QString cellText(double value) {
    if (!std::isfinite(value)) {
        return QString(QChar(0x2013));
    }
    const int digits = std::abs(value) >= 100.0 ? 1 : std::abs(value) >= 10.0 ? 2 : 3;
    const QString text = QString::number(value, 'f', digits);
    return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

}  // namespace

struct PlotPanel::Impl {
    PlotPanel* panel;
    RunSession* session;
    RunLibrary* library;
    std::vector<std::string> wheels;
    std::vector<bool> wheelShown;
    std::vector<ShownQuantity> quantities;
    std::vector<QString> chosen;  ///< quantity of every plot
    int count = 2;
    std::vector<const RunSession*> runs;  ///< that have curves; the first is the one on show
    std::vector<std::size_t> plotted;     ///< rows that the curves of each have
    double from = 0.0, to = 10.0;
    std::optional<double> mouseTime;
    std::optional<double> reference;  ///< differences are taken to this instant [s]

    std::array<std::unique_ptr<WheelPlot>, kMaxPlots> plots;
    std::array<QWidget*, kMaxPlots> columns{};
    std::array<QComboBox*, kMaxPlots> choosers{};
    QWidget* table = nullptr;
    QGridLayout* grid = nullptr;
    QLabel* cursor = nullptr;
    QLabel* legend = nullptr;
    QLabel* roverName = nullptr;
    std::vector<QToolButton*> toggles;
    std::vector<std::array<QLabel*, kMaxPlots>> cells;
    std::array<QLabel*, kMaxPlots> heads{};
    QComboBox* follow = nullptr;
    QComboBox* counts = nullptr;
    QTimer replotTimer;

    Impl(PlotPanel* p, RunSession* s, RunLibrary* l) : panel(p), session(s), library(l) {}

    void build();
    QWidget* makeToolbar();
    QWidget* makePlotColumn(int plot);
    void startRun();
    void startPlots();
    std::vector<std::pair<int, QString>> legendEntries() const;
    void drawLegend(QPainter& painter, QPoint place, const QColor& color) const;
    void showLegend();
    void buildTable();
    void showSigns();
    void buildRoverRow();
    void showColumns();
    void startPlot(int plot);
    void takeData(bool anew);
    void showWindow();
    void followTime();
    void setFree(double newFrom, double newTo);
    void updateCells();
    void updateHints();
    void schedule();
    void replotAll();
    void colors();
    void fonts();
    void saveChoice() const;
    double end() const;
    bool onMouse(int plot, QMouseEvent* event, bool clicked);
    void paintPicture(QPainter& painter, const QSize& size);
    QString suggestedName(const QString& ending) const;
    void complain(const Problems& problems, const QString& what);
    /// Whether the curves of this wheel, or of the chassis, are shown.
    bool showsObject(const std::string& object) const;
};

void PlotPanel::Impl::build() {
    const QSettings settings;
    chosen = {kFirstChoice.begin(), kFirstChoice.end()};
    const QStringList saved = settings.value("plots/quantities").toStringList();
    for (int i = 0; i < std::min<int>(kMaxPlots, static_cast<int>(saved.size())); ++i) {
        chosen[static_cast<std::size_t>(i)] = saved[i];
    }
    count = std::clamp(settings.value("plots/count", 2).toInt(), 1, kMaxPlots);
    table = new QWidget;
    table->setAccessibleName(PlotPanel::tr("Values at the cursor"));
    simcore::mechanism::Mechanism anyRover;
    anyRover.wheels.emplace_back().name = "wheel";
    quantities = quantitiesIn(simcore::run::makeChannels(anyRover));
    auto* body = new QHBoxLayout;
    body->setSpacing(6);
    body->addWidget(table);
    for (int i = 0; i < kMaxPlots; ++i) {
        body->addWidget(makePlotColumn(i), 1);
    }
    auto* layout = new QVBoxLayout(panel);
    layout->setContentsMargins(8, 0, 8, 6);
    layout->setSpacing(4);
    layout->addWidget(makeToolbar());
    layout->addLayout(body, 1);
    replotTimer.setSingleShot(true);
    replotTimer.setInterval(kReplotPeriod_ms);
    connect(&replotTimer, &QTimer::timeout, panel, [this] { replotAll(); });
    connect(session, &RunSession::runChanged, panel, [this] { startRun(); });
    connect(session, &RunSession::dataAppended, panel, [this] { schedule(); });
    connect(session, &RunSession::dataReplaced, panel, [this] { takeData(true); });
    connect(session, &RunSession::snapshotChanged, panel, [this] { schedule(); });
    connect(session, &RunSession::stateChanged, panel, [this] {
        schedule();  // the whole run's window depends on whether it goes on
    });
    connect(library, &RunLibrary::changed, panel, [this] {
        startPlots();
        takeData(true);
    });
    connect(library, &RunLibrary::dataChanged, panel, [this] { schedule(); });
    startRun();
    panel->setPlotCount(count);
    colors();
}

QWidget* PlotPanel::Impl::makeToolbar() {
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    cursor = new QLabel;
    cursor->setAccessibleName(PlotPanel::tr("Time at the cursor"));
    layout->addWidget(cursor);
    layout->addSpacing(12);
    legend = new QLabel;
    legend->setObjectName("runLegend");
    legend->setAccessibleName(PlotPanel::tr("Runs and their lines"));
    legend->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    layout->addWidget(legend, 1);
    counts = new QComboBox;
    counts->setObjectName("plotCount");
    counts->setAccessibleName(PlotPanel::tr("Number of plots"));
    for (int i = 1; i <= kMaxPlots; ++i) {
        counts->addItem(i == 1 ? PlotPanel::tr("1 plot") : PlotPanel::tr("%1 plots").arg(i), i);
    }
    layout->addWidget(counts);
    follow = new QComboBox;
    follow->setObjectName("timeWindow");
    follow->setAccessibleName(PlotPanel::tr("Time window"));
    follow->setToolTip(
        PlotPanel::tr("Drag a plot to pan, turn the wheel to zoom: then the window "
                      "is free and stays put"));
    follow->addItem(PlotPanel::tr("Whole run"), kWholeRun);
    for (const double seconds : {5.0, 10.0, 30.0}) {
        follow->addItem(PlotPanel::tr("Last %1 s").arg(seconds), seconds);
    }
    follow->addItem(PlotPanel::tr("Free"), kFree);
    layout->addWidget(follow);
    const auto button = [&](const QString& text, const QString& name, auto slot) {
        auto* one = new QPushButton(text);
        one->setObjectName(name);
        connect(one, &QPushButton::clicked, panel, slot);
        layout->addWidget(one);
    };
    button(PlotPanel::tr("Fit"), "fit", &PlotPanel::fit);
    button(PlotPanel::tr("Export CSV..."), "exportCsv", &PlotPanel::exportChannels);
    button(PlotPanel::tr("Save picture..."), "exportPicture", &PlotPanel::exportPicture);
    connect(counts, &QComboBox::activated, panel,
            [this] { panel->setPlotCount(counts->currentData().toInt()); });
    connect(follow, &QComboBox::activated, panel, [this] {
        followTime();
        replotAll();
    });
    return bar;
}

QWidget* PlotPanel::Impl::makePlotColumn(int index) {
    const auto at = static_cast<std::size_t>(index);
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* chooser = new QComboBox;
    chooser->setObjectName(QString("quantity:%1").arg(index));
    chooser->setAccessibleName(PlotPanel::tr("Quantity of plot %1").arg(index + 1));
    for (const ShownQuantity& q : quantities) {
        if (q.ofChassis && chooser->count() > 0 && !std::prev(&q)->ofChassis) {
            chooser->insertSeparator(chooser->count());
        }
        chooser->addItem(
            q.unit == "-" ? q.label : QString("%1 [%2]").arg(q.label, prettyUnit(q.unit)),
            q.quantity);
        if (q.quantity.startsWith("slip_")) {
            chooser->setItemData(chooser->count() - 1,
                                 PlotPanel::tr("After equations 5 and 6 of Lamon et al. 2004"),
                                 Qt::ToolTipRole);
        }
    }
    chooser->setMinimumWidth(kLeastChooser);
    layout->addWidget(chooser);
    plots.at(at) = std::make_unique<WheelPlot>(column);
    QCustomPlot* plot = plots.at(at)->widget();
    plot->setObjectName(QString("plot:%1").arg(index));
    layout->addWidget(plot, 1);
    choosers.at(at) = chooser;
    columns.at(at) = column;
    connect(chooser, &QComboBox::activated, panel, [this, index, chooser] {
        panel->setQuantity(index, chooser->currentData().toString());
    });
    connect(plot, &QCustomPlot::mouseMove, panel,
            [this, index](QMouseEvent* event) { onMouse(index, event, false); });
    // A drag pans; only a press and release at one place chooses a time.
    connect(plot, &QCustomPlot::mousePress, panel,
            [plot](QMouseEvent* event) { plot->setProperty("pressedAt", event->position()); });
    connect(plot, &QCustomPlot::mouseRelease, panel, [this, index, plot](QMouseEvent* event) {
        const QPointF moved = event->position() - plot->property("pressedAt").toPointF();
        if (event->button() == Qt::LeftButton && moved.manhattanLength() < 4.0) {
            onMouse(index, event, true);
        }
    });
    connect(plot->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), panel,
            [this](const QCPRange& range) {
                if (range.lower != from || range.upper != to) {
                    setFree(range.lower, range.upper);
                }
            });
    plot->installEventFilter(panel);
    return column;
}

double PlotPanel::Impl::end() const {
    double last = 0.0;
    for (const RunSession* run : runs) {
        const auto& rows = run->recording().rows;
        last = rows.empty() ? last : std::max(last, rows.back()[0]);
    }
    return last;
}

void PlotPanel::Impl::startRun() {
    std::vector<std::string> names;
    if (session->hasRun()) {
        for (const auto& wheel : session->settings().mechanism.wheels) {
            names.push_back(wheel.name);
        }
    }
    if (names != wheels || table->layout() == nullptr) {
        wheels = names;
        wheelShown.assign(wheels.size(), true);
        buildTable();
    }
    startPlots();
    if (follow->currentData().toDouble() == kFree) {
        follow->setCurrentIndex(0);
    }
    reference.reset();
    takeData(true);
}

void PlotPanel::Impl::startPlots() {
    runs = {session};
    for (const HeldRun& held : library->runs()) {
        if (held.curves) {
            runs.push_back(held.session.get());
        }
    }
    plotted.assign(runs.size(), 0);
    for (int i = 0; i < kMaxPlots; ++i) {
        startPlot(i);
    }
    showLegend();
}

/// Runs with curves and what tells their lines apart.
std::vector<std::pair<int, QString>> PlotPanel::Impl::legendEntries() const {
    std::vector<int> styles;
    std::vector<const simcore::run::ResolvedRun*> plottedRuns;
    const auto add = [&](int style, const RunSession& run) {
        styles.push_back(style);
        plottedRuns.push_back(&run.settings());
    };
    if (session->hasRun()) {
        add(0, *session);
    }
    for (const HeldRun& held : library->runs()) {
        if (held.curves) {
            add(held.style, *held.session);
        }
    }
    const QStringList titles = shortTitles(plottedRuns);
    std::vector<std::pair<int, QString>> entries;
    for (std::size_t i = 0; i < styles.size(); ++i) {
        entries.emplace_back(styles[i], titles[static_cast<int>(i)]);
    }
    return entries;
}

/// Draws the entries in a row from `place` (left end, base line) on.
void PlotPanel::Impl::drawLegend(QPainter& painter, QPoint place, const QColor& color) const {
    constexpr int kSample = 36;
    constexpr int kGap = 18;
    const QFontMetrics metrics = painter.fontMetrics();
    painter.setPen(color);
    int x = place.x();
    for (const auto& [style, name] : legendEntries()) {
        painter.drawPixmap(x, place.y() - metrics.ascent() / 2 - 4, lineSample(style, color));
        painter.drawText(x + kSample, place.y(), name);
        x += kSample + metrics.horizontalAdvance(name) + kGap;
    }
}

void PlotPanel::Impl::showLegend() {
    QStringList names;
    QPixmap picture;
    if (runs.size() > 1) {
        for (const auto& [style, name] : legendEntries()) {
            names << name;
        }
        // A picture, for a label's text cannot hold lines of all styles.
        constexpr double kScale = 2.0;
        constexpr int kWidest = 1600;
        const QFontMetrics metrics = legend->fontMetrics();
        picture = QPixmap(QSize(kWidest, metrics.height() + 2) * kScale);
        picture.setDevicePixelRatio(kScale);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setFont(legend->font());
        drawLegend(painter, QPoint(0, metrics.ascent() + 1),
                   panel->palette().color(QPalette::Text));
    }
    legend->setPixmap(picture);
    legend->setToolTip(names.join('\n'));
}

void PlotPanel::Impl::startPlot(int index) {
    const auto at = static_cast<std::size_t>(index);
    auto found = std::find_if(quantities.begin(), quantities.end(),
                              [&](const auto& q) { return q.quantity == chosen[at]; });
    if (found == quantities.end()) {
        found = quantities.begin();
    }
    choosers.at(at)->setCurrentIndex(choosers.at(at)->findData(found->quantity));
    std::vector<PlottedRun> plottedRuns{{&session->recording().channels, 0}};
    for (const HeldRun& held : library->runs()) {
        if (held.curves) {
            plottedRuns.push_back({&held.session->recording().channels, held.style});
        }
    }
    plots.at(at)->start(*found, wheels, plottedRuns);
    for (std::size_t wheel = 0; wheel < wheels.size(); ++wheel) {
        plots.at(at)->setWheelShown(static_cast<int>(wheel), wheelShown[wheel]);
    }
    if (heads.at(at) != nullptr) {
        const QString unit =
            found->unit == "-" ? QString() : QString(" [%1]").arg(prettyUnit(found->unit));
        heads.at(at)->setText(found->label.section(" (", 0, 0) + unit);
        heads.at(at)->setToolTip(found->label + unit);
    }
}

void PlotPanel::Impl::buildTable() {
    qDeleteAll(table->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    delete table->layout();
    grid = new QGridLayout(table);
    grid->setContentsMargins(0, 4, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(1);
    toggles.clear();
    cells.clear();
    for (std::size_t i = 0; i < kMaxPlots; ++i) {
        heads.at(i) = new QLabel;
        heads.at(i)->setAlignment(Qt::AlignRight);
        heads.at(i)->setEnabled(false);
        grid->addWidget(heads.at(i), 0, static_cast<int>(i) + 1);
    }
    for (std::size_t wheel = 0; wheel < wheels.size(); ++wheel) {
        auto* toggle = new QToolButton;
        const QString name = QString::fromStdString(wheels[wheel]);
        toggle->setText(name);
        toggle->setIconSize({kWheelSampleWidth, 14});
        toggle->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        toggle->setCheckable(true);
        toggle->setAutoRaise(true);
        toggle->setChecked(wheelShown[wheel]);
        toggle->setObjectName("wheelToggle");
        toggle->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        toggle->setAccessibleName(PlotPanel::tr("Show %1").arg(name));
        toggle->setToolTip(PlotPanel::tr("Show or hide the curves of %1").arg(name));
        connect(toggle, &QToolButton::toggled, panel,
                [this, wheel](bool on) { panel->setWheelShown(static_cast<int>(wheel), on); });
        grid->addWidget(toggle, static_cast<int>(wheel) + 1, 0);
        toggles.push_back(toggle);
        auto& row = cells.emplace_back();
        for (std::size_t i = 0; i < kMaxPlots; ++i) {
            row.at(i) = new QLabel;
            row.at(i)->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
            row.at(i)->setMinimumWidth(
                row.at(i)->fontMetrics().horizontalAdvance(QString(QChar(0x2212)) + "000.0"));
            row.at(i)->setAccessibleName(PlotPanel::tr("%1, plot %2").arg(name).arg(i + 1));
            grid->addWidget(row.at(i), static_cast<int>(wheel) + 1, static_cast<int>(i) + 1);
        }
    }
    showSigns();
    buildRoverRow();
    grid->setRowStretch(static_cast<int>(wheels.size()) + 2, 1);
    table->setVisible(!wheels.empty());
    showColumns();
}

void PlotPanel::Impl::showSigns() {
    const std::vector<WheelMark> marks = wheelMarks(wheels);
    for (std::size_t wheel = 0; wheel < toggles.size(); ++wheel) {
        toggles[wheel]->setIcon(wheelIcon(static_cast<int>(wheel), marks[wheel],
                                          panel->palette().color(QPalette::Window)));
    }
}

/// Values of the chassis, below those of the wheels.
void PlotPanel::Impl::buildRoverRow() {
    const int line = static_cast<int>(wheels.size()) + 1;
    roverName = new QLabel(PlotPanel::tr("rover"));
    roverName->setIndent(20);
    grid->addWidget(roverName, line, 0);
    auto& row = cells.emplace_back();
    for (std::size_t i = 0; i < kMaxPlots; ++i) {
        row.at(i) = new QLabel;
        row.at(i)->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row.at(i)->setAccessibleName(PlotPanel::tr("Rover, plot %1").arg(i + 1));
        grid->addWidget(row.at(i), line, static_cast<int>(i) + 1);
    }
}

/// Of the plots that there are.
void PlotPanel::Impl::showColumns() {
    bool chassis = false;
    for (int i = 0; i < kMaxPlots; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool shown = i < count;
        columns.at(at)->setVisible(shown);
        heads.at(at)->setVisible(shown);
        for (auto& row : cells) {
            row.at(at)->setVisible(shown);
        }
        chassis = chassis || (shown && plots.at(at)->quantity().ofChassis);
    }
    roverName->setVisible(chassis);
    for (QLabel* cell : cells.back()) {
        cell->setVisible(chassis && cell->isVisibleTo(table));
    }
}

void PlotPanel::Impl::takeData(bool anew) {
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const auto& recording = runs[run]->recording();
        // Fewer than there were: it began anew, or was thinned.
        const bool again = anew || recording.rows.size() < plotted[run];
        for (int i = 0; i < count; ++i) {
            WheelPlot& plot = *plots.at(static_cast<std::size_t>(i));
            if (again) {
                plot.clearData(run);
            }
            plot.append(run, recording, again ? 0 : plotted[run]);
        }
        plotted[run] = recording.rows.size();
    }
    updateHints();
    if (anew) {
        followTime();
        replotAll();
    }
}

void PlotPanel::Impl::followTime() {
    const double window = follow->currentData().toDouble();
    if (window == kFree) {
        showWindow();
        return;
    }
    const double last = end();
    if (window == kWholeRun) {
        from = 0.0;
        // Grows by whole steps, so that the curves do not crawl at every frame.
        to = std::max(5.0, std::ceil((last + 1e-9) / 5.0) * 5.0);
        if (session->state() == RunSession::State::Finished ||
            session->state() == RunSession::State::Paused) {
            to = std::max(last, 0.1);
        }
    } else {
        to = std::max(last, window);
        from = to - window;
    }
    showWindow();
}

void PlotPanel::Impl::showWindow() {
    for (int i = 0; i < count; ++i) {
        plots.at(static_cast<std::size_t>(i))->setWindow(from, to);
    }
}

void PlotPanel::Impl::setFree(double newFrom, double newTo) {
    const double last = std::max(end(), 1.0);
    const double width = std::clamp(newTo - newFrom, 0.05, 1.2 * last);
    from = std::clamp(newFrom, -0.1 * width, std::max(last - 0.5 * width, 0.0));
    to = from + width;
    follow->setCurrentIndex(follow->findData(kFree));
    showWindow();
    replotAll();
}

void PlotPanel::Impl::schedule() {
    if (!replotTimer.isActive()) {
        replotTimer.start();
    }
}

void PlotPanel::Impl::replotAll() {
    takeData(false);
    followTime();
    for (int i = 0; i < count; ++i) {
        WheelPlot& plot = *plots.at(static_cast<std::size_t>(i));
        plot.setMarks(session->shownTime(), mouseTime, reference);
        plot.replot();
    }
    updateCells();
}

void PlotPanel::Impl::updateCells() {
    const auto& recording = session->recording();
    const double time = panel->cursorTime();
    const bool any = !recording.rows.empty();
    cursor->setText(recording.rows.size() < 2 ? QString()
                    : reference               ? PlotPanel::tr("From %1 to %2 s: change in %3 s")
                                      .arg(*reference, 0, 'f', 2)
                                      .arg(time, 0, 'f', 2)
                                      .arg(time - *reference, 0, 'f', 2)
                                : PlotPanel::tr("Values at %1 s").arg(time, 0, 'f', 2));
    const auto rowAt = [&](double when) {
        const auto after =
            std::lower_bound(recording.rows.begin(), recording.rows.end(), when - 1e-9,
                             [](const auto& row, double t) { return row[0] < t; });
        return std::min<std::size_t>(
            static_cast<std::size_t>(std::distance(recording.rows.begin(), after)),
            recording.rows.size() - 1);
    };
    const std::size_t row = any ? rowAt(time) : 0;
    const std::size_t before = any && reference ? rowAt(*reference) : 0;
    for (std::size_t line = 0; line < cells.size(); ++line) {
        const bool ofChassis = line == wheels.size();
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const ShownQuantity& q = plots.at(i)->quantity();
            const int channel =
                q.ofChassis == ofChassis
                    ? simcore::run::findChannel(recording.channels, q.quantity.toStdString(),
                                                ofChassis ? "chassis" : wheels[line])
                    : -1;
            if (!any || channel < 0) {
                cells[line].at(i)->clear();
                continue;
            }
            const auto column = static_cast<std::size_t>(channel);
            const double base = reference ? recording.rows[before][column] : 0.0;
            cells[line].at(i)->setText(cellText((recording.rows[row][column] - base) * q.factor));
        }
    }
}

void PlotPanel::Impl::updateHints() {
    const bool empty = session->recording().rows.size() < 2;
    for (std::size_t i = 0; i < kMaxPlots; ++i) {
        const QString hint = session->recorded() != nullptr
                                 ? PlotPanel::tr("The recording ends before its first numbers")
                                 : PlotPanel::tr(
                                       "Press Space to drive:\nevery wheel's curve "
                                       "appears here");
        plots.at(i)->setHint(empty && i == 0 ? hint : QString());
    }
}

bool PlotPanel::Impl::onMouse(int plot, QMouseEvent* event, bool clicked) {
    mouseTime = plots.at(static_cast<std::size_t>(plot))
                    ->timeAt(event->position().x(), event->position().y());
    if (clicked && mouseTime && event->modifiers().testFlag(Qt::ShiftModifier)) {
        reference = reference ? std::nullopt : mouseTime;
    } else if (clicked && mouseTime && session->hasRun()) {
        session->scrub(std::clamp(*mouseTime, 0.0, end()));
    }
    schedule();
    return false;
}

void PlotPanel::Impl::colors() {
    showLegend();
    showSigns();
    for (auto& plot : plots) {
        plot->applyColors(panel->palette());
    }
    replotAll();
}

void PlotPanel::Impl::fonts() {
    for (auto& plot : plots) {
        plot->applyFont(panel->font());
    }
    for (auto& row : cells) {
        for (QLabel* cell : row) {
            cell->setMinimumWidth(
                panel->fontMetrics().horizontalAdvance(QString(QChar(0x2212)) + "000.0"));
        }
    }
    showLegend();
    replotAll();
}

void PlotPanel::Impl::saveChoice() const {
    QSettings settings;
    settings.setValue("plots/count", count);
    settings.setValue("plots/quantities", QStringList(chosen.begin(), chosen.end()));
}

void PlotPanel::Impl::paintPicture(QPainter& painter, const QSize& size) {
    painter.fillRect(QRect(QPoint(0, 0), size), Qt::white);
    painter.setPen(Qt::black);
    const int head = 22;
    int x = 8;
    const std::vector<WheelMark> marks = wheelMarks(wheels);
    constexpr int kSample = kWheelSampleWidth;
    for (std::size_t wheel = 0; wheel < wheels.size(); ++wheel) {
        if (!wheelShown[wheel]) {
            continue;
        }
        paintWheelSample(painter, QPointF(x, 12), kSample, static_cast<int>(wheel), marks[wheel],
                         Qt::white);
        painter.setPen(Qt::black);
        const QString name = QString::fromStdString(wheels[wheel]);
        painter.drawText(x + kSample + 5, 17, name);
        x += kSample + 5 + painter.fontMetrics().horizontalAdvance(name) + 16;
    }
    int top = head;
    if (runs.size() > 1) {
        drawLegend(painter, QPoint(8, top + 17), Qt::black);
        top += head;
    }
    const int width = size.width() / count;
    for (int i = 0; i < count; ++i) {
        WheelPlot& plot = *plots.at(static_cast<std::size_t>(i));
        painter.setPen(Qt::black);
        painter.drawText(QRect(i * width, top, width, head), Qt::AlignCenter,
                         plot.quantity().label);
        plot.paint(painter, QRect(i * width, top + head, width, size.height() - top - head));
    }
}

QString PlotPanel::Impl::suggestedName(const QString& ending) const {
    QString name = "run";
    if (session->hasRun()) {
        name = QString::fromStdString(session->settings().mechanism.name + "-" +
                                      session->settings().scenario)
                   .replace(' ', '_');
    }
    const QString project = QString::fromStdString(session->projectFile());
    const QString first = project.isEmpty() ? QDir::homePath() : QFileInfo(project).absolutePath();
    return QDir(QSettings().value("export/folder", first).toString()).filePath(name + ending);
}

bool PlotPanel::Impl::showsObject(const std::string& object) const {
    const auto wheel = std::find(wheels.begin(), wheels.end(), object);
    return wheel == wheels.end() ||
           wheelShown[static_cast<std::size_t>(std::distance(wheels.begin(), wheel))];
}

void PlotPanel::Impl::complain(const Problems& problems, const QString& what) {
    QMessageBox::warning(panel, what, QString::fromStdString(toString(problems)));
}

PlotPanel::PlotPanel(RunSession* session, RunLibrary* library, QWidget* parent)
    : QWidget(parent),
      impl_(std::make_unique<Impl>(this, session, library)) {
    impl_->build();
}

PlotPanel::~PlotPanel() = default;

void PlotPanel::setPlotCount(int count) {
    Impl& self = *impl_;
    self.count = std::clamp(count, 1, kMaxPlots);
    self.counts->setCurrentIndex(self.counts->findData(self.count));
    self.showColumns();
    self.saveChoice();
    self.takeData(true);
}

int PlotPanel::plotCount() const {
    return impl_->count;
}

void PlotPanel::setQuantity(int plot, const QString& quantity) {
    impl_->chosen.at(static_cast<std::size_t>(plot)) = quantity;
    impl_->startPlot(plot);
    impl_->showColumns();
    impl_->saveChoice();
    impl_->takeData(true);
}

QString PlotPanel::quantity(int plot) const {
    return impl_->plots.at(static_cast<std::size_t>(plot))->quantity().quantity;
}

void PlotPanel::setWheelShown(int wheel, bool shown) {
    const auto at = static_cast<std::size_t>(wheel);
    impl_->wheelShown.at(at) = shown;
    impl_->toggles.at(at)->setChecked(shown);
    for (auto& plot : impl_->plots) {
        plot->setWheelShown(wheel, shown);
    }
    impl_->replotAll();
}

double PlotPanel::cursorTime() const {
    return impl_->mouseTime.value_or(impl_->session->shownTime());
}

QString PlotPanel::hint() const {
    return impl_->plots.front()->hint();
}

std::pair<double, double> PlotPanel::window() const {
    return {impl_->from, impl_->to};
}

Problems PlotPanel::savePicture(const QString& file) {
    const auto cannot = [&](std::string reason, std::string remedy) {
        return Problems{
            {Severity::Critical, file.toStdString(), std::move(reason), std::move(remedy)}};
    };
    const QSize size(520 * plotCount(), 340);
    const QString ending = QFileInfo(file).suffix().toLower();
    if (ending != "png" && ending != "svg" && ending != "pdf") {
        return cannot(simcore::Text::of("the picture's format is not known."),
                      simcore::Text::of("Use a name ending in .png, .svg or .pdf."));
    }
    QSaveFile device(file);
    if (!device.open(QIODevice::WriteOnly)) {
        return cannot(simcore::Text::of("the picture cannot be written."),
                      simcore::Text::of("Check that the folder exists and can be written."));
    }
    if (ending == "png") {
        QImage image(size * 2, QImage::Format_RGB32);
        image.setDevicePixelRatio(2.0);
        QPainter painter(&image);
        impl_->paintPicture(painter, size);
        painter.end();
        image.save(&device, "PNG");
    } else if (ending == "svg") {
        QSvgGenerator generator;
        generator.setOutputDevice(&device);
        generator.setSize(size);
        generator.setViewBox(QRect(QPoint(0, 0), size));
        QPainter painter(&generator);
        impl_->paintPicture(painter, size);
    } else {
        QPdfWriter writer(&device);
        writer.setResolution(96);
        writer.setPageMargins(QMarginsF(0, 0, 0, 0));
        writer.setPageSize(QPageSize(QSizeF(size) * 72.0 / 96.0, QPageSize::Point));
        QPainter painter(&writer);
        impl_->paintPicture(painter, size);
    }
    if (!device.commit()) {
        return cannot(simcore::Text::of("the picture could not be written whole."),
                      simcore::Text::of("Check the free space of the disk."));
    }
    return {};
}

void PlotPanel::copyPicture() {
    const QSize size(520 * plotCount(), 340);
    QImage image(size, QImage::Format_RGB32);
    QPainter painter(&image);
    impl_->paintPicture(painter, size);
    painter.end();
    QApplication::clipboard()->setImage(image);
}

void PlotPanel::exportCsv() {
    writeCsv({});
}

void PlotPanel::exportChannels() {
    const auto& recording = impl_->session->recording();
    if (recording.rows.size() < 2) {
        writeCsv({});  // says that there is nothing
        return;
    }
    impl_->session->pause();  // what is written is what was looked at
    std::vector<std::string> plotted;
    for (int i = 0; i < impl_->count; ++i) {
        const ShownQuantity& q = impl_->plots.at(static_cast<std::size_t>(i))->quantity();
        for (const auto& channel : recording.channels) {
            if (channel.quantity == q.quantity.toStdString() &&
                impl_->showsObject(channel.object)) {
                plotted.push_back(channel.id());
            }
        }
    }
    ExportDialog dialog(recording, plotted,
                        {impl_->from, impl_->to, impl_->reference, impl_->session->shownTime()},
                        this);
    if (dialog.exec() == QDialog::Accepted) {
        writeCsv(dialog.cut());
    }
}

void PlotPanel::writeCsv(const simcore::io::TableCut& cut) {
    if (impl_->session->recording().rows.size() < 2) {
        QMessageBox::information(this, tr("Export CSV"),
                                 tr("There is no run to export yet. Press Space to drive first."));
        return;
    }
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Export CSV"), impl_->suggestedName(".csv"), tr("CSV tables (*.csv)"));
    if (file.isEmpty()) {
        return;
    }
    // Beside a table that may be replaced stands its own; else it is somebody's.
    const auto beside = simcore::io::csvMetadataFile(file.toStdString());
    if (!QFileInfo::exists(file) && !mayReplace(this, QString::fromStdString(beside.string()))) {
        return;
    }
    QSettings().setValue("export/folder", QFileInfo(file).absolutePath());
    const auto result = impl_->session->exportCsv(file, cut);
    if (result) {
        emit written(file);
    } else {
        impl_->complain(result.problems(), tr("Export CSV"));
    }
}

void PlotPanel::exportPicture() {
    const QString file = QFileDialog::getSaveFileName(this, tr("Save picture of the plots"),
                                                      impl_->suggestedName(".png"),
                                                      tr("Pictures (*.png *.svg *.pdf)"));
    if (file.isEmpty()) {
        return;
    }
    QSettings().setValue("export/folder", QFileInfo(file).absolutePath());
    const Problems problems = savePicture(file);
    if (problems.empty()) {
        emit written(file);
    } else {
        impl_->complain(problems, tr("Save picture"));
    }
}

void PlotPanel::fit() {
    impl_->follow->setCurrentIndex(impl_->follow->findData(kWholeRun));
    impl_->followTime();
    impl_->replotAll();
}

void PlotPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && impl_ != nullptr && impl_->grid != nullptr) {
        impl_->colors();
    } else if (event->type() == QEvent::FontChange && impl_ != nullptr && impl_->grid != nullptr) {
        impl_->fonts();
    }
    QWidget::changeEvent(event);
}

bool PlotPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Leave) {
        impl_->mouseTime.reset();
        impl_->schedule();
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace widgets
