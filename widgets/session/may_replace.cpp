#include "widgets/session/may_replace.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMessageBox>

namespace widgets {

bool mayReplace(QWidget* window, const QString& file) {
    return !QFileInfo::exists(file) ||
           QMessageBox::question(
               window,
               QCoreApplication::translate("widgets::mayReplace", "A file of this name is there"),
               QCoreApplication::translate("widgets::mayReplace", "Replace %1?").arg(file),
               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

}  // namespace widgets
