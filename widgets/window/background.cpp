#include "widgets/window/background.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <exception>
#include <memory>

namespace widgets {
namespace {

constexpr int kPatience_ms = 400;  ///< shorter work shows no dialog
constexpr int kPeriod_ms = 50;
constexpr int kParts = 1000;

}  // namespace

void workInBackground(QWidget* window, const QString& what,
                      const std::function<void(const GoOn&)>& work) {
    std::atomic<int> done = 0;
    std::atomic<bool> stop = false;
    std::exception_ptr failure;
    const GoOn goOn = [&](double part) {
        done = static_cast<int>(kParts * part);
        return !stop;
    };
    const std::unique_ptr<QThread> thread(QThread::create([&] {
        try {
            work(goOn);
        } catch (...) {
            failure = std::current_exception();
        }
    }));
    QEventLoop loop;
    QObject::connect(thread.get(), &QThread::finished, &loop, &QEventLoop::quit);
    QTimer::singleShot(kPatience_ms, &loop, &QEventLoop::quit);
    thread->start();
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    if (!thread->isFinished()) {
        QProgressDialog dialog(what, QCoreApplication::translate("widgets::background", "Cancel"),
                               0, kParts, window);
        dialog.setWindowTitle(QCoreApplication::applicationName());
        dialog.setObjectName("progress");
        dialog.setAccessibleName(what);
        dialog.setWindowModality(Qt::WindowModal);
        dialog.setMinimumDuration(0);
        dialog.setAutoReset(false);
        QObject::connect(&dialog, &QProgressDialog::canceled, &dialog, [&stop] { stop = true; });
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, &dialog, [&] {
            if (!stop) {
                dialog.setValue(done);
            } else if (!dialog.isVisible()) {
                // Work may take a while to stop; the window must not be used before it has.
                dialog.setLabelText(
                    QCoreApplication::translate("widgets::background", "Stopping..."));
                dialog.setCancelButton(nullptr);
                dialog.show();
            }
        });
        timer.start(kPeriod_ms);
        dialog.show();
        while (!thread->isFinished()) {
            loop.exec();
        }
    }
    thread->wait();
    if (failure) {
        std::rethrow_exception(failure);
    }
}

}  // namespace widgets
