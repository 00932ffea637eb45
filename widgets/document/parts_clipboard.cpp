#include "widgets/document/parts_clipboard.h"

#include <QClipboard>
#include <QGuiApplication>

#include "simcore/io/project_file.h"

namespace widgets::clipboard {

using simcore::project::Project;

void copyParts(const Project& project, const std::vector<simcore::project::ElementRef>& elements) {
    QGuiApplication::clipboard()->setText(
        QString::fromStdString(simcore::io::formatParts(partsOf(project, elements))));
}

simcore::Result<Project> pasted(const Project& project, int body) {
    const auto parts = simcore::io::parseParts(QGuiApplication::clipboard()->text().toStdString());
    if (!parts) {
        return parts.problems();
    }
    return withParts(project, *parts, body);
}

}  // namespace widgets::clipboard
