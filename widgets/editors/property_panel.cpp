#include "widgets/editors/property_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <utility>

#include "simcore/project/fields.h"
#include "simcore/project/names.h"
#include "widgets/editors/field_info.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/editors/quantity_field.h"

namespace widgets {

using simcore::Problems;
using simcore::project::ElementKind;
using simcore::project::ElementRef;
using simcore::project::Project;
using simcore::project::Quantity;

namespace {

/// Combo boxes and spin boxes of a scrolling panel leave the wheel to the panel.
template <class Base>
class Unwheeled : public Base {
  public:
    using Base::Base;

  protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

/// Finds the element to edit in any copy of the project.
template <class Element>
using Access = std::function<Element&(Project&)>;

QString joined(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts) {
        list << QString::fromStdString(text);
    }
    return list.join(", ");
}

std::vector<std::string> separated(const QString& text) {
    std::vector<std::string> texts;
    for (const QString& part : text.split(',', Qt::SkipEmptyParts)) {
        if (!part.trimmed().isEmpty()) {
            texts.push_back(part.trimmed().toStdString());
        }
    }
    return texts;
}

/// The kind of element a text field refers to; nothing for plain text.
std::optional<ElementKind> referredKind(const QString& element, const QString& key) {
    if (key == "first" || key == "second" || (key == "body" && element != "body")) {
        return ElementKind::Body;
    }
    if (key == "axle" || key == "steering" || key == "joint" || key == "first_joint" ||
        key == "second_joint") {
        return ElementKind::Joint;
    }
    if (key == "variant") {
        return ElementKind::Variant;
    }
    return std::nullopt;
}

}  // namespace

/// Makes one row for every field of an element.
class PropertyFormBuilder {
  public:
    PropertyFormBuilder(PropertyPanel* panel, QFormLayout* form)
        : panel_(panel),
          document_(panel->document_),
          form_(form) {}

    void heading(const QString& text) {
        auto* label = new QLabel("<b>" + text.toHtmlEscaped() + "</b>");
        label->setContentsMargins(0, 8, 0, 0);
        form_->addRow(label);
    }

    template <class Element>
    void build(Access<Element> access) {
        const Element& element = read(access);
        const char* word = elementWord(&element);
        Fields<Element> fields{*this, access, word};
        describe(fields, static_cast<const Element*>(nullptr));
    }

  private:
    /// Visitor of fields.h: the key and member of every field of one element.
    template <class Element>
    struct Fields {
        PropertyFormBuilder& builder;
        Access<Element> access;
        QString word;

        template <class Member>
        void required(const char* key, Member Element::*member) {
            add(key, member);
        }

        template <class Member>
        void optional(const char* key, Member Element::*member) {
            add(key, member);
        }

        template <class Member>
        void add(const char* key, Member Element::*member) {
            if constexpr (std::is_same_v<Element, simcore::project::Terrain>) {
                if (!terrainUses(builder.read(access).kind, key)) {
                    return;
                }
            }
            if constexpr (std::is_same_v<Element, simcore::project::Shape>) {
                if (!shapeUses(builder.read(access).kind, key)) {
                    return;
                }
            }
            FieldInfo info = fieldInfo(word, key);
            if constexpr (std::is_same_v<Element, simcore::project::Parameter>) {
                if (info.unit.isEmpty() &&
                    (std::string_view(key) == "value" || std::string_view(key).ends_with("imum"))) {
                    info.unit = QString::fromStdString(builder.read(access).unit);
                }
            }
            if constexpr (std::is_same_v<Element, simcore::project::Spring>) {
                builder.useTorsionUnits(builder.read(access), key, info);
            }
            const Access<Member> field = [access = access, member](Project& project) -> Member& {
                return access(project).*member;
            };
            builder.row(word, key, info, field);
        }
    };

    template <class T>
    const T& read(const Access<T>& access) const {
        // Accessors serve reading and writing; this one only reads.
        return access(const_cast<Project&>(document_->project()));  // NOLINT
    }

    static void useTorsionUnits(const simcore::project::Spring& spring, const char* key,
                                FieldInfo& info) {
        if (spring.joint.empty()) {
            return;
        }
        const std::string_view name = key;
        if (name == "stiffness") {
            info.unit = "N*m/rad";
        } else if (name == "preload") {
            info.unit = "N*m";
        } else if (name == "damping") {
            info.unit = "N*m*s/rad";
        }
    }

    template <class T>
    void set(const Access<T>& access, T value, const QString& label, const QString& mergeKey = {}) {
        Project next = document_->project();
        access(next) = std::move(value);
        document_->edit(PropertyPanel::tr("Change %1").arg(label), std::move(next), mergeKey);
    }

    void addRow(const FieldInfo& info, QWidget* editor) {
        auto* label = new QLabel(info.label);
        label->setToolTip(info.tooltip);
        label->setBuddy(editor);
        if (editor->accessibleName().isEmpty()) {
            editor->setAccessibleName(info.label);
        }
        if (editor->toolTip().isEmpty()) {
            editor->setToolTip(info.tooltip);
        }
        form_->addRow(label, editor);
    }

    void onRefresh(std::function<void()> refresher) {
        refresher();
        panel_->refreshers_.push_back(std::move(refresher));
    }

    // One overload for every type of field.

    void row(const QString& word, const char* key, const FieldInfo& info,
             const Access<std::string>& field) {
        if (std::string_view(key) == "name" && word != "override") {
            nameRow(info, field);
        } else if (const auto kind = referredKind(word, key)) {
            referenceRow(info, field, *kind);
        } else if (word == "override" && std::string_view(key) == "parameter") {
            return;  // the row of the value carries the name
        } else {
            textRow(info, field);
        }
    }

    void nameRow(const FieldInfo& info, const Access<std::string>& field) {
        auto* line = new QLineEdit;
        line->setObjectName("property:name");
        addRow(info, line);
        onRefresh([self = *this, line, field] {
            line->setText(QString::fromStdString(self.read(field)));
            line->setCursorPosition(0);
        });
        PropertyPanel* panel = panel_;
        QObject::connect(line, &QLineEdit::editingFinished, panel, [panel, line] {
            Document* document = panel->document_;
            const auto next = simcore::project::renamed(document->project(), panel->element_,
                                                        line->text().trimmed().toStdString());
            emit panel->refused(next ? QString()
                                     : QString::fromStdString(toString(next.problems().front())));
            if (next) {
                document->edit(PropertyPanel::tr("Rename to %1").arg(line->text().trimmed()),
                               *next);
            }
        });
    }

    void textRow(const FieldInfo& info, const Access<std::string>& field) {
        auto* line = new QLineEdit;
        addRow(info, line);
        onRefresh([self = *this, line, field] {
            line->setText(QString::fromStdString(self.read(field)));
            line->setCursorPosition(0);
        });
        QObject::connect(line, &QLineEdit::editingFinished, panel_,
                         [self = *this, line, field, label = info.label]() mutable {
                             self.set(field, line->text().toStdString(), label);
                         });
    }

    void referenceRow(const FieldInfo& info, const Access<std::string>& field, ElementKind kind) {
        auto* box = new Unwheeled<QComboBox>;
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        addRow(info, box);
        onRefresh([self = *this, box, field, kind] {
            const QSignalBlocker quiet(box);
            const Project& project = self.document_->project();
            const QString current = QString::fromStdString(self.read(field));
            box->clear();
            box->addItem(PropertyPanel::tr("(none)"), QString());
            for (int i = 0; i < countOf(project, kind); ++i) {
                const QString name = QString::fromStdString(nameOf(project, ElementRef{kind, i}));
                box->addItem(name, name);
            }
            int at = box->findData(current);
            if (at < 0) {
                box->addItem(current, current);
                at = box->count() - 1;
            }
            box->setCurrentIndex(at);
        });
        QObject::connect(box, &QComboBox::activated, panel_,
                         [self = *this, box, field, label = info.label]() mutable {
                             self.set(field, box->currentData().toString().toStdString(), label);
                         });
    }

    void row(const QString& /*word*/, const char* key, const FieldInfo& info,
             const Access<bool>& field) {
        auto* check = new QCheckBox;
        check->setObjectName(QString("property:") + key);
        addRow(info, check);
        onRefresh([self = *this, check, field] {
            const QSignalBlocker quiet(check);
            check->setChecked(self.read(field));
        });
        if (std::string_view(key) == "mirror") {
            connectMirror(check);
            return;
        }
        QObject::connect(check, &QCheckBox::toggled, panel_,
                         [self = *this, field, label = info.label](bool on) mutable {
                             self.set(field, on, label);
                         });
    }

    /// Names and what refers to them follow.
    void connectMirror(QCheckBox* check) {
        PropertyPanel* panel = panel_;
        QObject::connect(check, &QCheckBox::toggled, panel, [panel, check](bool on) {
            Document* document = panel->document_;
            const auto next =
                simcore::project::mirrored(document->project(), {panel->element_}, on);
            emit panel->refused(next ? QString()
                                     : QString::fromStdString(toString(next.problems().front())));
            if (next) {
                const QString name =
                    QString::fromStdString(nameOf(document->project(), panel->element_));
                document->edit(
                    (on ? PropertyPanel::tr("Mirror %1") : PropertyPanel::tr("Do not mirror %1"))
                        .arg(name),
                    *next);
            } else {
                const QSignalBlocker quiet(check);
                check->setChecked(!on);
            }
        });
    }

    void row(const QString& /*word*/, const char* /*key*/, const FieldInfo& info,
             const Access<int>& field) {
        auto* spin = new Unwheeled<QSpinBox>;
        spin->setRange(-1000000000, 1000000000);
        spin->setKeyboardTracking(false);
        addRow(info, spin);
        onRefresh([self = *this, spin, field] {
            const QSignalBlocker quiet(spin);
            spin->setValue(self.read(field));
        });
        QObject::connect(spin, &QSpinBox::valueChanged, panel_,
                         [self = *this, field, label = info.label](int value) mutable {
                             self.set(field, value, label, "spin " + label);
                         });
    }

    QuantityField* makeField(const FieldInfo& info, const Access<Quantity>& field,
                             const QString& name) {
        auto* line =
            new QuantityField(document_, name, info.unit,
                              [self = *this, field, label = info.label](
                                  const Quantity& value, const QString& key) mutable -> Problems {
                                  self.set(field, value, label, key);
                                  return {};
                              });
        onRefresh([self = *this, line, field] { line->setQuantity(self.read(field)); });
        QObject::connect(line, &QuantityField::refused, panel_, &PropertyPanel::refused);
        return line;
    }

    void row(const QString& /*word*/, const char* key, const FieldInfo& info,
             const Access<Quantity>& field) {
        QuantityField* line = makeField(info, field, info.label);
        line->setObjectName(QString("property:") + key);
        addRow(info, line);
    }

    template <std::size_t N>
    void row(const QString& /*word*/, const char* key, const FieldInfo& info,
             const Access<std::array<Quantity, N>>& field) {
        static constexpr std::array kAxes{"x", "y", "z"};
        for (std::size_t i = 0; i < N; ++i) {
            const Access<Quantity> one = [field, i](Project& project) -> Quantity& {
                return field(project)[i];
            };
            FieldInfo row = info;
            row.label = info.label + ' ' +
                        (N == 3   ? QString(kAxes.at(i))
                         : i == 0 ? PropertyPanel::tr("from")
                                  : PropertyPanel::tr("to"));
            QuantityField* line = makeField(row, one, row.label);
            line->setObjectName(QString("property:%1:%2").arg(key).arg(i));
            addRow(row, line);
        }
    }

    template <std::size_t N>
    void row(const QString& /*word*/, const char* key, const FieldInfo& info,
             const Access<std::optional<std::array<Quantity, N>>>& field) {
        auto* check = new QCheckBox(N == 6 ? PropertyPanel::tr("given") : PropertyPanel::tr("on"));
        addRow(info, check);
        onRefresh([self = *this, check, field] {
            const QSignalBlocker quiet(check);
            check->setChecked(self.read(field).has_value());
        });
        QObject::connect(check, &QCheckBox::toggled, panel_,
                         [self = *this, field, label = info.label](bool on) mutable {
                             self.set(field, on ? defaultOf<N>() : std::nullopt, label);
                         });
        if (!read(field)) {
            return;
        }
        static constexpr std::array kMoments{"Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};
        for (std::size_t i = 0; i < N; ++i) {
            const Access<Quantity> one = [field, i](Project& project) -> Quantity& {
                return field(project)->at(i);
            };
            FieldInfo row = info;
            row.label = N == 6   ? QString(kMoments.at(i))
                        : i == 0 ? PropertyPanel::tr("Lower stop")
                                 : PropertyPanel::tr("Upper stop");
            QuantityField* line = makeField(row, one, row.label);
            line->setObjectName(QString("property:%1:%2").arg(key).arg(i));
            addRow(row, line);
        }
    }

    /// What a switched-on optional field starts with.
    template <std::size_t N>
    static std::optional<std::array<Quantity, N>> defaultOf() {
        std::array<Quantity, N> values{};
        if constexpr (N == 2) {
            values[0] = -1.0;
            values[1] = 1.0;
        } else {
            values[0] = values[1] = values[2] = 0.01;
        }
        return values;
    }

    void row(const QString& /*word*/, const char* key, const FieldInfo& info,
             const Access<std::optional<double>>& field) {
        const Access<std::optional<double>> access = field;
        auto* line = new QLineEdit;
        line->setPlaceholderText(PropertyPanel::tr("no limit"));
        line->setObjectName(QString("property:") + key);
        addRow(info, line);
        const std::string unit = info.unit.toStdString();
        onRefresh([self = *this, line, field, unit] {
            const auto& value = self.read(field);
            line->setText(value ? QString::fromStdString(simcore::project::textOf(*value, unit)) +
                                      ' ' + QString::fromStdString(unit)
                                : QString());
        });
        QObject::connect(
            line, &QLineEdit::editingFinished, panel_,
            [self = *this, line, field, unit, label = info.label]() mutable {
                if (line->text().trimmed().isEmpty()) {
                    self.set(field, std::optional<double>(), label);
                    return;
                }
                const auto value = simcore::project::quantityFromText(
                    line->text().toStdString(), unit, {}, label.toStdString());
                const bool number = value && value->isLiteral();
                emit self.panel_->refused(number ? QString()
                                                 : PropertyPanel::tr("%1: a number is needed, not "
                                                                     "'%2'.")
                                                       .arg(label, line->text()));
                if (number) {
                    self.set(field, std::optional(value->literal()), label);
                }
            });
    }

    void row(const QString& /*word*/, const char* /*key*/, const FieldInfo& info,
             const Access<std::vector<std::string>>& field) {
        auto* line = new QLineEdit;
        addRow(info, line);
        onRefresh([self = *this, line, field] { line->setText(joined(self.read(field))); });
        QObject::connect(line, &QLineEdit::editingFinished, panel_,
                         [self = *this, line, field, label = info.label]() mutable {
                             self.set(field, separated(line->text()), label);
                         });
    }

    template <class Enum, std::enable_if_t<std::is_enum_v<Enum>, int> = 0>
    void row(const QString& /*word*/, const char* key, const FieldInfo& info,
             const Access<Enum>& field) {
        auto* box = new Unwheeled<QComboBox>;
        box->setObjectName(QString("property:") + key);
        for (const std::string& name : simcore::project::allNames<Enum>()) {
            box->addItem(QString::fromStdString(name));
        }
        addRow(info, box);
        onRefresh([self = *this, box, field] {
            const QSignalBlocker quiet(box);
            box->setCurrentText(QString::fromStdString(simcore::project::nameOf(self.read(field))));
        });
        QObject::connect(box, &QComboBox::activated, panel_,
                         [self = *this, box, field, label = info.label]() mutable {
                             const auto value =
                                 simcore::project::fromName<Enum>(box->currentText().toStdString());
                             if (value) {
                                 self.set(field, *value, label);
                             }
                         });
    }

    void row(const QString& /*word*/, const char* /*key*/, const FieldInfo& info,
             const Access<std::vector<simcore::project::Override>>& field) {
        heading(info.label);
        const auto& parameters = document_->project().rover.parameters;
        for (std::size_t i = 0; i < read(field).size(); ++i) {
            const Access<Quantity> one = [field, i](Project& project) -> Quantity& {
                return field(project).at(i).value;
            };
            FieldInfo row;
            row.label = QString::fromStdString(read(field)[i].parameter);
            for (const auto& parameter : parameters) {
                if (parameter.name == read(field)[i].parameter) {
                    row.unit = QString::fromStdString(parameter.unit);
                }
            }
            addRow(row, makeField(row, one, row.label));
            listButton(PropertyPanel::tr("Remove"), PropertyPanel::tr("Remove %1").arg(row.label),
                       field, [i](std::vector<simcore::project::Override>& all) {
                           all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
                       });
        }
        auto* box = new Unwheeled<QComboBox>;
        box->setObjectName("add:set");
        box->setAccessibleName(PropertyPanel::tr("Set another parameter"));
        box->addItem(PropertyPanel::tr("Set another parameter..."));
        for (const auto& parameter : parameters) {
            const bool set =
                std::any_of(read(field).begin(), read(field).end(),
                            [&](const auto& change) { return change.parameter == parameter.name; });
            if (!set && parameter.value.isLiteral()) {
                box->addItem(QString::fromStdString(parameter.name));
            }
        }
        form_->addRow(box);
        QObject::connect(
            box, &QComboBox::activated, panel_, [self = *this, box, field](int at) mutable {
                if (at < 1) {
                    return;
                }
                const std::string name = box->currentText().toStdString();
                std::vector<simcore::project::Override> all = self.read(field);
                for (const auto& parameter : self.document_->project().rover.parameters) {
                    if (parameter.name == name) {
                        all.push_back({name, parameter.value});
                    }
                }
                self.set(field, std::move(all), QString::fromStdString(name));
            });
    }

    /// Shapes of a body have properties of their own: a button for each leads to them.
    void row(const QString& /*word*/, const char* /*key*/, const FieldInfo& info,
             const Access<std::vector<simcore::project::Shape>>& field) {
        heading(info.label);
        PropertyPanel* panel = panel_;
        for (std::size_t i = 0; i < read(field).size(); ++i) {
            ElementRef shape = panel_->element_;
            shape.shape = static_cast<int>(i);
            auto* button = new QPushButton(labelOf(document_->project(), shape));
            button->setObjectName(QString("shape:%1").arg(i));
            button->setAccessibleName(button->text());
            button->setToolTip(PropertyPanel::tr("Edit this shape"));
            form_->addRow(button);
            QObject::connect(button, &QPushButton::clicked, panel,
                             [panel, shape] { emit panel->chosen(shape); });
        }
        auto* add = new QPushButton(PropertyPanel::tr("Add"));
        add->setObjectName("add:shapes");
        add->setAccessibleName(PropertyPanel::tr("Add to %1").arg(inSentence(info.label)));
        add->setToolTip(add->accessibleName());
        auto* menu = new QMenu(add);
        using simcore::project::ShapeKind;
        for (const std::string& name : simcore::project::allNames<ShapeKind>()) {
            const ShapeKind kind = *simcore::project::fromName<ShapeKind>(name);
            menu->addAction(kindTitle(kind), panel,
                            [panel, kind] { emit panel->shapeWanted(kind); });
        }
        add->setMenu(menu);
        form_->addRow(add);
    }

    /// A list of parts with fields of their own: a heading and a button to remove for each, one
    /// to add.
    template <class Part, std::enable_if_t<std::is_same_v<Part, simcore::project::Terrain> ||
                                               std::is_same_v<Part, simcore::project::SoilRegion>,
                                           int> = 0>
    void row(const QString& /*word*/, const char* key, const FieldInfo& info,
             const Access<std::vector<Part>>& field) {
        for (std::size_t i = 0; i < read(field).size(); ++i) {
            heading(QString("%1: %2").arg(info.label).arg(i + 1));
            build<Part>([field, i](Project& project) -> Part& { return field(project).at(i); });
            listButton(PropertyPanel::tr("Remove"),
                       PropertyPanel::tr("Remove %1 %2").arg(inSentence(info.label)).arg(i + 1),
                       field, [i](std::vector<Part>& parts) {
                           parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
                       });
        }
        const QString meaning = PropertyPanel::tr("Add to %1").arg(inSentence(info.label));
        auto* add = listButton(meaning, meaning, field,
                               [](std::vector<Part>& parts) { parts.push_back(Part{}); });
        add->setObjectName(QString("add:") + key);
    }

    template <class Part, class Change>
    QPushButton* listButton(const QString& text, const QString& meaning,
                            const Access<std::vector<Part>>& field, Change change) {
        auto* button = new QPushButton(text);
        button->setAccessibleName(meaning);
        button->setToolTip(meaning);
        form_->addRow(button);
        QObject::connect(button, &QPushButton::clicked, panel_,
                         [self = *this, field, meaning, change]() mutable {
                             std::vector<Part> parts = self.read(field);
                             change(parts);
                             self.set(field, std::move(parts), meaning);
                         });
        return button;
    }

    /// A part of the element with fields of its own, under a heading.
    template <class Part, std::enable_if_t<std::is_class_v<Part>, int> = 0>
    void row(const QString& /*word*/, const char* /*key*/, const FieldInfo& info,
             const Access<Part>& field) {
        heading(info.label);
        build<Part>(field);
    }

    PropertyPanel* panel_;
    Document* document_;
    QFormLayout* form_;
};

namespace {

void buildForm(PropertyFormBuilder& builder, const Project& project, ElementRef element) {
    if (element.isShape()) {
        builder.heading(
            PropertyPanel::tr("%1 of %2", "shape")
                .arg(labelOf(project, element), QString::fromStdString(nameOf(project, element))));
        return builder.build<simcore::project::Shape>([element](Project & p) -> auto& {
            return p.rover.bodies.at(static_cast<std::size_t>(element.index))
                .shapes.at(static_cast<std::size_t>(element.shape));
        });
    }
    const auto at = static_cast<std::size_t>(element.index);
    switch (element.kind) {
        case ElementKind::Parameter:
            return builder.build<simcore::project::Parameter>([at](Project & p) -> auto& {
                return p.rover.parameters.at(at);
            });
        case ElementKind::Body:
            return builder.build<simcore::project::Body>([at](Project & p) -> auto& {
                return p.rover.bodies.at(at);
            });
        case ElementKind::Joint:
            return builder.build<simcore::project::Joint>([at](Project & p) -> auto& {
                return p.rover.joints.at(at);
            });
        case ElementKind::Wheel:
            return builder.build<simcore::project::Wheel>([at](Project & p) -> auto& {
                return p.rover.wheels.at(at);
            });
        case ElementKind::Spring:
            return builder.build<simcore::project::Spring>([at](Project & p) -> auto& {
                return p.rover.springs.at(at);
            });
        case ElementKind::Gear:
            return builder.build<simcore::project::Gear>([at](Project & p) -> auto& {
                return p.rover.gears.at(at);
            });
        case ElementKind::Payload:
            return builder.build<simcore::project::Payload>([at](Project & p) -> auto& {
                return p.rover.payloads.at(at);
            });
        case ElementKind::Variant:
            return builder.build<simcore::project::Variant>([at](Project & p) -> auto& {
                return p.variants.at(at);
            });
        case ElementKind::Scenario:
            return builder.build<simcore::project::Scenario>([at](Project & p) -> auto& {
                return p.scenarios.at(at);
            });
    }
}

/// What decides which rows a form has, as text: kinds, switched-on optional fields, list sizes.
std::string shapeOf(const Project& project, ElementRef element) {
    if (element.index < 0 || element.index >= countOf(project, element.kind)) {
        return {};
    }
    const auto at = static_cast<std::size_t>(element.index);
    std::string shape = wordFor(element.kind) + std::to_string(element.index);
    if (element.isShape()) {
        return element.shape < shapeCountOf(project, element.index)
                   ? shape + '+' + nameOf(shapeAt(project, element).kind) +
                         std::to_string(element.shape) + nameOf(project, element)
                   : std::string();
    }
    switch (element.kind) {
        case ElementKind::Parameter:
            return shape + project.rover.parameters[at].unit;
        case ElementKind::Body:
            shape += project.rover.bodies[at].inertia ? "inertia" : "";
            for (const simcore::project::Shape& drawn : project.rover.bodies[at].shapes) {
                shape += '+' + nameOf(drawn.kind);
            }
            return shape;
        case ElementKind::Joint:
            return shape + (project.rover.joints[at].stops ? "stops" : "");
        case ElementKind::Spring:
            return shape + (project.rover.springs[at].joint.empty() ? "" : "torsion");
        case ElementKind::Variant:
            for (const auto& change : project.variants[at].set) {
                shape += '+' + change.parameter;
            }
            return shape + '/' + std::to_string(project.rover.parameters.size());
        case ElementKind::Scenario:
            shape += nameOf(project.scenarios[at].terrain.kind);
            for (const auto& part : project.scenarios[at].terrain.terrains) {
                shape += '+' + nameOf(part.kind);
            }
            return shape + std::to_string(project.scenarios[at].soil.regions.size());
        default:
            return shape;
    }
}

}  // namespace

PropertyPanel::PropertyPanel(Document* document, QWidget* parent)
    : QScrollArea(parent),
      document_(document) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setObjectName("properties");
    setAccessibleName(tr("Properties"));
    connect(document_, &Document::changed, this, &PropertyPanel::refresh);
    rebuild();
}

void PropertyPanel::setElement(ElementRef element) {
    element_ = element;
    rebuild();
}

void PropertyPanel::rebuild() {
    refreshers_.clear();
    shape_ = shapeOf(document_->project(), element_);
    auto* content = new QWidget;
    if (shape_.empty()) {
        element_.index = -1;
        auto* layout = new QVBoxLayout(content);
        auto* hint = new QLabel(tr("Select a part in the tree\nor in the 3D view to edit it."));
        hint->setAlignment(Qt::AlignCenter);
        hint->setEnabled(false);
        layout->addWidget(hint);
    } else {
        auto* form = new QFormLayout(content);
        form->setContentsMargins(6, 6, 8, 6);
        form->setVerticalSpacing(3);
        form->setHorizontalSpacing(8);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        PropertyFormBuilder builder(this, form);
        buildForm(builder, document_->project(), element_);
    }
    // The form may be rebuilt from a signal of one of its own editors.
    if (QWidget* old = takeWidget()) {
        old->hide();
        old->deleteLater();
    }
    setWidget(content);
}

void PropertyPanel::refresh() {
    if (shapeOf(document_->project(), element_) != shape_) {
        rebuild();
        return;
    }
    for (const auto& refresher : refreshers_) {
        refresher();
    }
}

}  // namespace widgets
