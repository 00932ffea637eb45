#include "widgets/window/new_rover_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "simcore/io/project_file.h"
#include "simcore/project/templates.h"
#include "simcore/project/units.h"
#include "widgets/editors/quantity_field.h"
#include "widgets/editors/rover_sketch.h"

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;
using simcore::project::Parameter;
using simcore::project::Project;
using simcore::project::Quantity;

namespace {

constexpr QSize kPicture(108, 64);

/// "wheel_radius" -> "Wheel radius".
QString labelOf(const std::string& name) {
    QString text = QString::fromStdString(name).replace('_', ' ');
    text[0] = text[0].toUpper();
    return text;
}

QString signedNumber(int value) {
    return value < 0 ? QChar(0x2212) + QString::number(-value) : QString::number(value);
}

}  // namespace

NewRoverDialog::NewRoverDialog(QWidget* parent)
    : QDialog(parent),
      list_(new QListWidget),
      description_(new QLabel),
      sketch_(new RoverSketch),
      dimensions_(new QWidget),
      summary_(new QLabel),
      problem_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("New rover"));
    setObjectName("newRover");
    list_->setAccessibleName(tr("Topology"));
    list_->setObjectName("topology");
    list_->setIconSize(kPicture);
    list_->setSpacing(2);
    list_->setFixedWidth(20 * fontMetrics().height());
    for (const auto& file : simcore::io::templateFiles()) {
        auto project = simcore::io::loadProject(file);
        if (!project) {
            continue;
        }
        auto* item = new QListWidgetItem(QString::fromStdString(project->rover.name), list_);
        item->setData(Qt::UserRole, QString::fromStdString(file.stem().string()));
        if (const auto mechanism = simcore::project::resolve(*project)) {
            // On the selection's colour, it is drawn in that of its text.
            QPalette chosen = palette();
            for (const auto role : {QPalette::WindowText, QPalette::Highlight}) {
                chosen.setColor(role, palette().color(QPalette::HighlightedText));
            }
            chosen.setColor(QPalette::Base, palette().color(QPalette::Highlight));
            QIcon icon;
            icon.addPixmap(
                RoverSketch::picture(*mechanism, kPicture, palette(), devicePixelRatioF()));
            icon.addPixmap(RoverSketch::picture(*mechanism, kPicture, chosen, devicePixelRatioF()),
                           QIcon::Selected);
            item->setIcon(icon);
        }
        templates_.push_back(std::move(project).value());
    }
    description_->setWordWrap(true);
    description_->setMinimumHeight(3 * fontMetrics().height());
    description_->setAlignment(Qt::AlignTop);
    summary_->setObjectName("summary");
    summary_->setWordWrap(true);
    problem_->setObjectName("problem");
    problem_->setWordWrap(true);
    problem_->setMinimumHeight(2 * fontMetrics().height());
    problem_->setAlignment(Qt::AlignTop);
    buttons_->button(QDialogButtonBox::Cancel)->setObjectName("cancel");
    QPushButton* create = buttons_->addButton(tr("Create"), QDialogButtonBox::AcceptRole);
    create->setObjectName("create");
    create->setDefault(true);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* right = new QVBoxLayout;
    right->setSpacing(10);
    right_ = right;
    right->addWidget(description_);
    right->addWidget(sketch_, 1);
    right->addWidget(dimensions_);
    right->addWidget(summary_);
    right->addWidget(problem_);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(16);
    columns->addWidget(list_);
    columns->addLayout(right, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addLayout(columns, 1);
    layout->addWidget(buttons_);
    resize(QSize(57, 43) * fontMetrics().height());

    connect(list_, &QListWidget::currentRowChanged, this, &NewRoverDialog::choose);
    // A double click takes it as it is.
    connect(list_, &QListWidget::itemDoubleClicked, create, &QPushButton::click);
    connect(&draft_, &Document::changed, this, &NewRoverDialog::update);
    // The first is the empty one, for which nobody comes here.
    list_->setCurrentRow(std::min(1, list_->count() - 1));
}

void NewRoverDialog::choose(int row) {
    if (row < 0) {
        return;
    }
    const Project& chosen = templates_.at(static_cast<std::size_t>(row));
    description_->setText(QString::fromStdString(chosen.rover.description));
    draft_.openProject(chosen, {});
    makeFields();
}

void NewRoverDialog::makeFields() {
    auto* dimensions = new QWidget;
    auto* form = new QFormLayout(dimensions);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    for (const int place : mainDimensions(draft_.project())) {
        const Parameter& parameter =
            draft_.project().rover.parameters[static_cast<std::size_t>(place)];
        const QString unit = QString::fromStdString(parameter.unit);
        const QString meaning = QString::fromStdString(parameter.meaning);
        auto* field =
            new QuantityField(&draft_, labelOf(parameter.name), unit,
                              [this, place](const Quantity& value, const QString& /*key*/) {
                                  return setDimension(place, value);
                              });
        field->setQuantity(parameter.value);
        field->setObjectName("dimension:" + QString::fromStdString(parameter.name));
        field->setAccessibleName(labelOf(parameter.name));
        field->setToolTip(meaning);
        field->setFixedWidth(8 * fontMetrics().height());
        connect(field, &QuantityField::refused, problem_,
                [this](const QString& why) { why.isEmpty() ? update() : problem_->setText(why); });
        auto* range = new QLabel(tr("%1 to %2 %3 · %4")
                                     .arg(QString::fromStdString(simcore::project::formatIn(
                                              *parameter.minimum, parameter.unit)),
                                          QString::fromStdString(simcore::project::formatIn(
                                              *parameter.maximum, parameter.unit)),
                                          unit, meaning));
        range->setForegroundRole(QPalette::PlaceholderText);
        auto* row = new QHBoxLayout;
        row->setSpacing(12);
        row->addWidget(field);
        row->addWidget(range, 1);
        auto* label = new QLabel(labelOf(parameter.name));
        label->setBuddy(field);
        form->addRow(label, row);
    }
    delete right_->replaceWidget(dimensions_, dimensions);
    delete dimensions_;
    dimensions_ = dimensions;
    dimensions_->show();
}

Problems NewRoverDialog::setDimension(int place, const Quantity& value) {
    Project next = draft_.project();
    Parameter& parameter = next.rover.parameters.at(static_cast<std::size_t>(place));
    const auto number = simcore::project::evaluate(
        value, draft_.derived().parameters,
        titleFor(simcore::project::ElementKind::Parameter, parameter.name));
    if (!number) {
        return number.problems();
    }
    const bool low = *number < *parameter.minimum;
    if (low || *number > *parameter.maximum) {
        const double limit = low ? *parameter.minimum : *parameter.maximum;
        const std::string text =
            simcore::project::formatIn(limit, parameter.unit) + " " + parameter.unit;
        return {Problem{Severity::Critical, labelOf(parameter.name).toStdString(),
                        (low ? tr("it is less than %1.") : tr("it is more than %1."))
                            .arg(QString::fromStdString(text))
                            .toStdString(),
                        tr("Stay within the range.").toStdString()}};
    }
    parameter.value = *number;
    parameter.source = tr("chosen").toStdString();
    draft_.edit({}, std::move(next));
    return {};
}

void NewRoverDialog::update() {
    const Derived& derived = draft_.derived();
    for (const int place : mainDimensions(draft_.project())) {
        const Parameter& parameter =
            draft_.project().rover.parameters[static_cast<std::size_t>(place)];
        auto* field =
            findChild<QuantityField*>("dimension:" + QString::fromStdString(parameter.name));
        if (field != nullptr && field->refusal().isEmpty()) {
            field->setQuantity(parameter.value);
        }
    }
    sketch_->setMechanism(derived.mechanism);
    const bool good = derived.mechanism && !simcore::hasCritical(derived.problems);
    buttons_->findChild<QPushButton*>("create")->setEnabled(good);
    if (derived.mechanism) {
        const auto& report = derived.built;
        summary_->setText(
            tr("<b>Mobility %1</b>, %2 redundant · Grübler count %3, %4 rows, rank %5 · %6 bodies, "
               "%7 wheels, %8 kg")
                .arg(signedNumber(report.mobility))
                .arg(report.redundant)
                .arg(signedNumber(report.gruebler))
                .arg(report.rows)
                .arg(report.rank)
                .arg(report.bodies)
                .arg(derived.mechanism->wheels.size())
                .arg(QString::fromStdString(
                    simcore::project::formatIn(derived.mechanism->mass(), "kg", 4))));
    } else {
        summary_->setText(tr("These dimensions do not go together."));
    }
    QString text;
    for (const Problem& problem : derived.problems) {
        if (problem.severity != Severity::Critical) {
            continue;
        }
        // A derived parameter says by its meaning what is in the way.
        QString where = QString::fromStdString(problem.element);
        for (const Parameter& parameter : draft_.project().rover.parameters) {
            if (problem.element ==
                    titleFor(simcore::project::ElementKind::Parameter, parameter.name) &&
                !parameter.meaning.empty()) {
                where = QString::fromStdString(parameter.meaning);
            }
        }
        text +=
            (text.isEmpty() ? "" : "\n") + where + ": " + QString::fromStdString(problem.reason);
    }
    problem_->setText(text);
}

}  // namespace widgets
