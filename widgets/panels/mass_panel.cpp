#include "widgets/panels/mass_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "simcore/base/text.h"
#include "simcore/project/edit.h"
#include "simcore/project/units.h"
#include "widgets/editors/quantity_field.h"

namespace widgets {

using simcore::Problems;
using simcore::project::Quantity;

namespace {

constexpr std::array kAxes{"x", "y", "z"};

QString inUnit(double value, const char* unit, int digits) {
    return QString::fromStdString(simcore::project::formatIn(value, unit, digits)) + ' ' + unit;
}

}  // namespace

MassPanel::MassPanel(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      mass_(new QLabel(this)),
      stance_(new QLabel(this)),
      message_(new QLabel(this)),
      bodies_(new QTreeWidget(this)) {
    mass_->setObjectName("massTotal");
    mass_->setAccessibleName(tr("Mass of the rover"));
    mass_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    stance_->setObjectName("massStance");
    stance_->setAccessibleName(tr("Wheelbase and track"));
    stance_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->setWordWrap(true);
    message_->setObjectName("errorMessage");
    message_->hide();
    auto* form = new QFormLayout;
    form->setVerticalSpacing(3);
    form->addRow(tr("Mass"), mass_);
    form->addRow(tr("Wheelbase, track"), stance_);
    for (int axis = 0; axis < 3; ++axis) {
        const QString name = tr("Centre of mass %1").arg(kAxes.at(static_cast<std::size_t>(axis)));
        auto* field = new QuantityField(
            document_, name, "mm", [this, axis](const Quantity& value, const QString& key) {
                const auto number = simcore::project::evaluate(
                    value, document_->derived().parameters, simcore::Text::of("centre of mass"));
                return number ? moveCenterOfMass(axis, *number, key) : number.problems();
            });
        field->setObjectName(QString("com:%1").arg(axis));
        field->setToolTip(
            tr("Of the whole rover, in the rover frame. Editing it moves the centre "
               "of mass of the chassis."));
        connect(field, &QuantityField::refused, this, [this](const QString& why) {
            message_->setText(why);
            message_->setVisible(!why.isEmpty());
        });
        form->addRow(name, field);
        com_.at(static_cast<std::size_t>(axis)) = field;
    }
    bodies_->setObjectName("massBodies");
    bodies_->setColumnCount(3);
    bodies_->setHeaderLabels({tr("Body"), tr("Mass"), tr("Share")});
    bodies_->setRootIsDecorated(false);
    bodies_->setUniformRowHeights(true);
    bodies_->setFrameShape(QFrame::NoFrame);
    bodies_->setAccessibleName(tr("Masses of the bodies"));
    bodies_->header()->setStretchLastSection(false);
    bodies_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    bodies_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    bodies_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    connect(bodies_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!refreshing_ && item != nullptr) {
            emit bodyChosen(bodies_->indexOfTopLevelItem(item));
        }
    });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 0);
    layout->addLayout(form);
    layout->addWidget(message_);
    layout->addWidget(bodies_, 1);
    connect(document_, &Document::changed, this, &MassPanel::refresh);
    refresh();
}

void MassPanel::refresh() {
    const auto& mechanism = document_->derived().mechanism;
    for (QuantityField* field : com_) {
        field->setEnabled(mechanism.has_value());
    }
    if (!mechanism) {
        mass_->setText(tr("unknown while the project has problems"));
        stance_->clear();
        return;
    }
    mass_->setText(inUnit(mechanism->mass(), "kg", 5));
    double left = 0.0;
    double right = 0.0;
    for (const auto& wheel : mechanism->wheels) {
        left = std::max(left, wheel.center.y());
        right = std::min(right, wheel.center.y());
    }
    stance_->setText(inUnit(mechanism->wheelbase(), "mm", 4) + ", " +
                     inUnit(left - right, "mm", 4));
    const simcore::Vec3 com = mechanism->centerOfMass();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Rounded to a micrometre: a mean of many numbers has no better digits to show.
        const double shown = std::round(com[static_cast<Eigen::Index>(axis)] * 1e6) * 1e-6;
        com_.at(axis)->setQuantity(shown == 0.0 ? 0.0 : shown);
    }
    showBodies();
}

void MassPanel::showBodies() {
    refreshing_ = true;
    const auto& mechanism = *document_->derived().mechanism;
    const int count = static_cast<int>(mechanism.bodies.size());
    while (bodies_->topLevelItemCount() > count) {
        delete bodies_->takeTopLevelItem(count);
    }
    while (bodies_->topLevelItemCount() < count) {
        auto* item = new QTreeWidgetItem(bodies_);
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    }
    const double total = mechanism.mass();
    for (int i = 0; i < count; ++i) {
        const auto& body = mechanism.bodies[static_cast<std::size_t>(i)];
        QTreeWidgetItem* item = bodies_->topLevelItem(i);
        const std::array<QString, 3> texts{
            QString::fromStdString(body.name), inUnit(body.mass, "kg", 4),
            QString("%1 %").arg(total > 0.0 ? 100.0 * body.mass / total : 0.0, 0, 'f', 1)};
        for (int column = 0; column < 3; ++column) {
            const QString& text = texts.at(static_cast<std::size_t>(column));
            if (item->text(column) != text) {
                item->setText(column, text);
            }
        }
    }
    refreshing_ = false;
}

Problems MassPanel::moveCenterOfMass(int axis, double value, const QString& mergeKey) {
    const auto& mechanism = document_->derived().mechanism;
    if (!mechanism) {
        return document_->derived().problems;
    }
    simcore::Vec3 com = mechanism->centerOfMass();
    com[axis] = value;
    auto next = simcore::project::withCenterOfMass(document_->project(), com);
    if (!next) {
        return next.problems();
    }
    document_->edit(tr("Move the centre of mass"), std::move(next).value(), mergeKey);
    return {};
}

}  // namespace widgets
