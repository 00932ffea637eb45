#include "widgets/window/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <clocale>

#include "simcore/base/text.h"

/// In the namespace of all: the name that rcc gives.
static void initResources() {
    Q_INIT_RESOURCE(translations);
}

namespace widgets {

namespace {

constexpr const char* kSetting = "window/language";

/// Of the translators that installLanguage() made, to be replaced by the next call.
constexpr const char* kTranslatorName = "widgetsLanguage";

void install(const QString& name, const QString& folder) {
    auto* translator = new QTranslator(qApp);
    translator->setObjectName(kTranslatorName);
    if (translator->load(name, folder)) {
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator;
    }
}

/// The window's languages for the sentences of simcore.
std::string translated(const char* pattern) {
    return QCoreApplication::translate("simcore", pattern).toStdString();
}

}  // namespace

QStringList languages() {
    return {"en", "de"};
}

QString languageName(const QString& language) {
    return language == "de" ? QStringLiteral("Deutsch") : QStringLiteral("English");
}

QString chosenLanguage() {
    const QString language = QSettings().value(kSetting).toString();
    return languages().contains(language) ? language : QString();
}

void chooseLanguage(const QString& language) {
    QSettings().setValue(kSetting, language);
}

QString systemLanguage() {
    // Only the first: who prefers English to German has both in the list.
    const QString language = QLocale::system().uiLanguages().value(0).left(2);
    return languages().contains(language) ? language : QStringLiteral("en");
}

void installLanguage(const QString& language) {
    // Qt has taken over the user's decimal separator for C's functions; files have a point.
    std::setlocale(LC_NUMERIC, "C");
    initResources();
    for (QTranslator* old : qApp->findChildren<QTranslator*>(kTranslatorName)) {
        delete old;
    }
    if (language != "en") {
        install("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
        install("roverstudio_" + language, ":/translations");
    }
    simcore::Text::setLookUp(language == "en" ? nullptr : translated);
}

}  // namespace widgets
