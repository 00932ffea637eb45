#include "widgets/window/recovery_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {

RecoveryDialog::RecoveryDialog(std::vector<Recovered> found, QWidget* parent)
    : QDialog(parent),
      found_(std::move(found)),
      list_(new QListWidget(this)) {
    setObjectName("recovery");
    setWindowTitle(tr("Unsaved work found"));
    auto* text = new QLabel(found_.size() == 1
                                ? tr("RoverStudio did not end well. This project has changes that "
                                     "were not saved:")
                                : tr("RoverStudio did not end well. These projects have changes "
                                     "that were not saved:"),
                            this);
    text->setWordWrap(true);
    list_->setObjectName("recoverable");
    list_->setAccessibleName(tr("Projects with unsaved changes"));
    for (const Recovered& one : found_) {
        const QFileInfo original(one.leftover.original);
        const QString name =
            one.leftover.original.isEmpty()
                ? tr("%1 (never saved)").arg(QString::fromStdString(one.project.rover.name))
                : original.fileName();
        auto* item = new QListWidgetItem(
            tr("%1, %2").arg(name, QLocale().toString(one.leftover.time, QLocale::ShortFormat)),
            list_);
        item->setToolTip(one.leftover.original.isEmpty() ? one.leftover.copy
                                                         : one.leftover.original);
    }
    list_->setCurrentRow(0);
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* restore = buttons->addButton(tr("&Restore"), QDialogButtonBox::AcceptRole);
    restore->setObjectName("restore");
    restore->setDefault(true);
    QPushButton* discard =
        buttons->addButton(tr("&Throw away..."), QDialogButtonBox::DestructiveRole);
    discard->setObjectName("throwAway");
    discard->setAutoDefault(false);
    QPushButton* later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    later->setObjectName("later");
    later->setToolTip(tr("Asks again at the next start; until then: File > Recover unsaved work"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(discard, &QPushButton::clicked, this, &RecoveryDialog::throwAway);
    connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(list_);
    layout->addWidget(buttons);
    resize(QSize(35, 16) * fontMetrics().height());
}

const Recovered& RecoveryDialog::chosen() const {
    return found_.at(static_cast<std::size_t>(list_->currentRow()));
}

void RecoveryDialog::throwAway() {
    const int row = list_->currentRow();
    if (QMessageBox::question(this, tr("Unsaved work found"),
                              tr("Throw away the changes to %1? They cannot be brought back.")
                                  .arg(list_->item(row)->text()),
                              QMessageBox::Yes | QMessageBox::No,
                              QMessageBox::No) != QMessageBox::Yes) {
        return;
    }
    remove(found_.at(static_cast<std::size_t>(row)).leftover);
    found_.erase(found_.begin() + row);
    delete list_->takeItem(row);
    if (found_.empty()) {
        reject();
    }
}

}  // namespace widgets
