#include "widgets/window/film.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <cmath>
#include <map>

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;

namespace {

constexpr int kStart_ms = 5000;
constexpr int kPicture_ms = 20000;
constexpr int kEnd_ms = 60000;

Problems cannot(const QString& file, const QString& reason, const QString& remedy) {
    return {{Severity::Critical, file.toStdString(), reason.toStdString(), remedy.toStdString()}};
}

/// What ffmpeg is told for a file's ending; nothing when it is not known.
QStringList encoderFor(const QString& ending) {
    static const std::map<QString, QStringList> kEncoders{
        {"mp4",
         {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "20", "-movflags", "+faststart"}},
        {"webm", {"-c:v", "libvpx-vp9", "-crf", "32", "-b:v", "0"}},
        {"gif", {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"}}};
    const auto found = kEncoders.find(ending);
    return found == kEncoders.end() ? QStringList() : found->second;
}

/// The view at an instant; encoders want even sides.
QImage pictureAt(RunSession& session, Viewport& viewport, double time) {
    session.scrub(time);
    const QImage image = viewport.grabImage().convertToFormat(QImage::Format_RGB888);
    return image.copy(0, 0, image.width() / 2 * 2, image.height() / 2 * 2);
}

bool feed(QProcess& encoder, const QImage& picture) {
    for (int y = 0; y < picture.height(); ++y) {
        encoder.write(reinterpret_cast<const char*>(picture.constScanLine(y)),
                      3LL * picture.width());
    }
    while (encoder.bytesToWrite() > 0) {
        if (!encoder.waitForBytesWritten(kPicture_ms)) {
            return false;
        }
    }
    return true;
}

}  // namespace

Problems writeFilm(RunSession& session, Viewport& viewport, const FilmRequest& request,
                   const std::function<bool(double)>& goOn) {
    const QString ending = QFileInfo(request.file).suffix().toLower();
    const QStringList encoding = encoderFor(ending);
    if (encoding.isEmpty()) {
        return cannot(request.file, QObject::tr("the film's format is not known."),
                      QObject::tr("Use a name ending in .mp4, .webm or .gif."));
    }
    if (!session.hasRun() || request.to <= request.from) {
        return cannot(request.file, QObject::tr("there is no run to film."),
                      QObject::tr("Run a scenario first."));
    }
    const QString program = QStandardPaths::findExecutable("ffmpeg");
    if (program.isEmpty()) {
        return cannot(request.file, QObject::tr("films are made by ffmpeg, which is not there."),
                      QObject::tr("Install it; on Debian: apt install ffmpeg."));
    }
    session.pause();
    const double shown = session.shownTime();
    const bool wasLive = session.isLive();
    const QString part =
        QFileInfo(request.file)
            .absoluteDir()
            .filePath("." + QFileInfo(request.file).completeBaseName() + ".part." + ending);
    const double step = request.speed / request.rate;
    const auto count = static_cast<int>(std::floor((request.to - request.from) / step + 1e-9)) + 1;

    QImage picture = pictureAt(session, viewport, request.from);
    const QSize size = picture.size();
    QProcess encoder;
    encoder.setProcessChannelMode(QProcess::MergedChannels);
    encoder.start(program,
                  QStringList{"-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24",
                              "-s", QString("%1x%2").arg(size.width()).arg(size.height()), "-r",
                              QString::number(request.rate), "-i", "-"} +
                      encoding + QStringList{part});
    bool good = encoder.waitForStarted(kStart_ms);
    bool ended = false;
    for (int i = 0; good && i < count; ++i) {
        if (i > 0) {
            picture = pictureAt(session, viewport, request.from + i * step);
        }
        good = picture.size() == size && feed(encoder, picture);
        if (!goOn(static_cast<double>(i + 1) / count)) {
            ended = true;
            break;
        }
    }
    if (ended || !good) {
        encoder.kill();
    } else {
        encoder.closeWriteChannel();
    }
    good = encoder.waitForFinished(kEnd_ms) && good && !ended &&
           encoder.exitStatus() == QProcess::NormalExit && encoder.exitCode() == 0;
    const QString words = QString::fromUtf8(encoder.readAll()).trimmed().section('\n', -1);
    if (wasLive) {
        session.goLive();
    } else {
        session.scrub(shown);
    }
    if (good) {
        QFile::remove(request.file);
        good = QFile::rename(part, request.file);
    }
    QFile::remove(part);
    if (good || ended) {
        return {};
    }
    return cannot(request.file,
                  words.isEmpty() ? QObject::tr("the film could not be written.")
                                  : QObject::tr("the film could not be written: %1.").arg(words),
                  QObject::tr("Check the folder and the free space of the disk."));
}

}  // namespace widgets
