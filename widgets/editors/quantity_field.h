#pragma once

#include <QLineEdit>
#include <functional>
#include <optional>

#include "widgets/document/document.h"

namespace widgets {

/// A line for one number: shows it with its display unit, or the expression with its value behind.
/// Takes "80", "8 cm" or "2*wheel_radius"; up, down and the mouse wheel step plain numbers. What
/// cannot be applied stays in the line, marked, with the reason; Escape brings the old text back.
class QuantityField : public QLineEdit {
    Q_OBJECT
  public:
    /// Applies a new value to the document and tells why it could not. `mergeKey` is empty for a
    /// typed value.
    using Apply = std::function<simcore::Problems(const simcore::project::Quantity&,
                                                  const QString& mergeKey)>;

    /// `element` is what problems call it; `unit` the display unit, "" for a plain number.
    QuantityField(const Document* document, QString element, QString unit, Apply apply,
                  QWidget* parent = nullptr);

    void setQuantity(const simcore::project::Quantity& quantity);
    void setUnit(const QString& unit);

    const simcore::project::Quantity& quantity() const { return quantity_; }

    /// The value [SI]; nothing when the expression has none.
    std::optional<double> value() const { return value_; }

    /// Why the text was refused; empty when it was not.
    QString refusal() const { return refusal_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    /// The text could not be applied; "" when that is over.
    void refused(const QString& why);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void commit();
    void restore();
    void step(int count);
    void refuse(const QString& why);
    QString shownText() const;
    /// "= 12 mm"; empty where an expression has no value.
    QString shownValue() const;
    QRect contents() const;
    QRect valuePlace() const;
    /// Whether the text has not all its room; the tooltip then tells it.
    bool isCut() const;

    const Document* document_;
    QString element_, unit_;
    Apply apply_;
    simcore::project::Quantity quantity_;
    std::optional<double> value_;
    QString refusal_;
};

}  // namespace widgets
