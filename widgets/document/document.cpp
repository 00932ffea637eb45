#include "widgets/document/document.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QUndoCommand>
#include <filesystem>
#include <utility>

#include "simcore/io/atomic_file.h"
#include "simcore/io/project_file.h"

namespace widgets {

using simcore::Problems;
using simcore::project::Project;

namespace {

/// A chassis alone, and level ground to stand on.
Project emptyProject() {
    Project project;
    project.rover.name = "rover";
    simcore::project::Body chassis;
    chassis.name = "chassis";
    chassis.mass = 5.0;
    chassis.com = {0.0, 0.0, 0.2};
    simcore::project::Shape box;
    box.center = {0.0, 0.0, 0.2};
    box.size = {0.4, 0.3, 0.1};
    box.color = "chassis";
    chassis.shapes.push_back(box);
    project.rover.bodies.push_back(chassis);
    simcore::project::Scenario flat;
    flat.name = "flat";
    project.scenarios.push_back(flat);
    return project;
}

QByteArray digestOf(const std::string& text) {
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
        .toHex();
}

}  // namespace

/// Puts one project in the place of another.
class ProjectCommand : public QUndoCommand {
  public:
    using ProjectPtr = Document::ProjectPtr;

    ProjectCommand(Document* document, ProjectPtr next, const QString& text, QString mergeKey)
        : QUndoCommand(text),
          document_(document),
          before_(document->project_),
          after_(std::move(next)),
          mergeKey_(std::move(mergeKey)),
          mergeRun_(document->mergeRun_) {}

    void undo() override { document_->show(before_); }

    void redo() override { document_->show(after_); }

    int id() const override { return mergeKey_.isEmpty() ? -1 : 1; }

    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = static_cast<const ProjectCommand*>(other);
        if (next->mergeKey_ != mergeKey_ || next->mergeRun_ != mergeRun_) {
            return false;
        }
        after_ = next->after_;
        setObsolete(*after_ == *before_);
        return true;
    }

  private:
    Document* document_;
    ProjectPtr before_, after_;
    QString mergeKey_;
    int mergeRun_;
};

Document::Document(QObject* parent) : QObject(parent) {
    connect(&undo_, &QUndoStack::cleanChanged, this,
            [this](bool clean) { emit modifiedChanged(!clean); });
    createNew();
}

void Document::edit(const QString& text, Project next, const QString& mergeKey) {
    if (next == *project_) {
        return;
    }
    undo_.push(
        new ProjectCommand(this, std::make_shared<const Project>(std::move(next)), text, mergeKey));
}

void Document::endMerging() {
    ++mergeRun_;
}

void Document::createNew() {
    start(emptyProject(), {});
}

Problems Document::open(const QString& file) {
    const auto text = simcore::io::readFile(file.toStdString());
    if (!text) {
        return text.problems();
    }
    auto project = simcore::io::parseProject(*text, file.toStdString());
    if (!project) {
        return project.problems();
    }
    start(std::move(project).value(), QFileInfo(file).absoluteFilePath(), {}, digestOf(*text));
    return {};
}

Problems Document::openCopy(const QString& file) {
    auto project = simcore::io::loadProject(file.toStdString());
    if (!project) {
        return project.problems();
    }
    start(std::move(project).value(), {});
    return {};
}

Problems Document::saveAs(const QString& file) {
    const QString path = QFileInfo(file).absoluteFilePath();
    const std::string text = simcore::io::formatProject(*project_);
    Problems warnings;
    const bool changed = path == file_ && compareWithDisk() == OnDisk::Changed;
    const bool keep = QFileInfo::exists(path) && (changed || backedUp_.count(path) == 0);
    if (keep) {
        warnings = simcore::io::backUp(path.toStdString()).problems();
        for (simcore::Problem& problem : warnings) {
            problem.severity = simcore::Severity::Warning;
        }
    }
    if (auto written = simcore::io::writeFileAtomically(path.toStdString(), text); !written) {
        return written.problems();
    }
    backedUp_.insert(path);
    const auto before = files();
    file_ = path;
    digest_ = digestOf(text);
    if (files() != before) {
        show(project_);  // terrain files may be found now, or no longer
    }
    undo_.setClean();
    endMerging();
    emit fileChanged();
    return warnings;
}

void Document::openProject(Project project, simcore::project::ProjectFiles files) {
    start(std::move(project), {}, std::move(files));
}

void Document::recover(Project project, const QString& file, const QByteArray& digest) {
    start(std::move(project), file, {}, digest);
    undo_.resetClean();
}

Document::OnDisk Document::compareWithDisk() const {
    if (file_.isEmpty()) {
        return OnDisk::Same;
    }
    const auto text = simcore::io::readFile(file_.toStdString());
    return !text ? OnDisk::Gone : digestOf(*text) == digest_ ? OnDisk::Same : OnDisk::Changed;
}

Problems Document::reload() {
    const auto text = simcore::io::readFile(file_.toStdString());
    if (!text) {
        return text.problems();
    }
    auto project = simcore::io::parseProject(*text, file_.toStdString());
    if (!project) {
        return project.problems();
    }
    edit(tr("Reload"), std::move(project).value());
    digest_ = digestOf(*text);
    undo_.setClean();
    endMerging();
    return {};
}

void Document::keepMine() {
    const auto text = simcore::io::readFile(file_.toStdString());
    digest_ = text ? digestOf(*text) : QByteArray();
    undo_.resetClean();
}

simcore::project::ProjectFiles Document::files() const {
    return file_.isEmpty()
               ? files_
               : simcore::project::ProjectFiles(
                     std::filesystem::path(file_.toStdString()).parent_path(), files_.carried);
}

QString Document::displayName() const {
    return file_.isEmpty() ? tr("Untitled") : QFileInfo(file_).fileName();
}

void Document::show(ProjectPtr project) {
    project_ = std::move(project);
    derived_ = derive(*project_, files());
    emit changed();
}

void Document::start(Project project, const QString& file, simcore::project::ProjectFiles files,
                     const QByteArray& digest) {
    undo_.clear();
    undo_.setClean();
    endMerging();
    file_ = file;
    digest_ = digest;
    backedUp_.clear();
    files_ = std::move(files);
    show(std::make_shared<const Project>(std::move(project)));
    emit replaced();
    emit fileChanged();
}

}  // namespace widgets
