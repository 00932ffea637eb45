#pragma once

#include <QString>
#include <QStringList>

namespace widgets {

/// Languages of the window: "en", and those with a file in widgets/translations.
QStringList languages();

/// "Deutsch" for "de": a language's name in itself.
QString languageName(const QString& language);

/// The language kept in the settings; empty = that of the system.
QString chosenLanguage();

/// Keeps a language (empty = that of the system) for the next start.
void chooseLanguage(const QString& language);

/// The system's language, or English where there is no translation into it.
QString systemLanguage();

/// Translates everything that is made from now on; call it with the application in place and no
/// window. Numbers stay as they are in every language: with a decimal point, as in files.
void installLanguage(const QString& language);

}  // namespace widgets
