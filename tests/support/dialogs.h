#pragma once

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

/// Modal windows in tests: what will be done with the next one, said before it opens.
namespace testsupport {

/// Calls `act` with the next modal window of this kind.
template <class Window, class Act>
void onNext(Act act) {
    auto* retry = new QTimer(QApplication::instance());
    QObject::connect(retry, &QTimer::timeout, [retry, act] {
        if (auto* window = qobject_cast<Window*>(QApplication::activeModalWidget())) {
            retry->deleteLater();
            retry->stop();
            act(window);
        }
    });
    retry->start(30);
}

/// Answers the next message box with a real click.
inline void answerNextBox(QMessageBox::StandardButton button, QString* text = nullptr) {
    onNext<QMessageBox>([button, text](QMessageBox* box) {
        if (text != nullptr) {
            *text = box->text() + "\n" + box->informativeText();
        }
        QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
}

/// Gives the next file dialog a name and clicks on its button.
inline void chooseFile(const QString& file) {
    onNext<QFileDialog>([file](QFileDialog* dialog) {
        auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
        ASSERT_NE(line, nullptr);
        line->setText(file);
        auto* buttons = dialog->findChild<QDialogButtonBox*>("buttonBox");
        ASSERT_NE(buttons, nullptr);
        for (QAbstractButton* button : buttons->buttons()) {
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) {
                QTest::mouseClick(button, Qt::LeftButton);
            }
        }
    });
}

inline std::string bytesOf(const QString& file) {
    std::ifstream in(file.toStdString(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace testsupport
