#pragma once

#include <QString>
#include <optional>

#include "widgets/document/document.h"

/// Copies of unsaved work, kept outside the user's files until the program ends well.
namespace widgets::autosave {

/// What a program that ended badly left behind.
struct Leftover {
    QString copy;      ///< the autosaved file
    QString original;  ///< the file it belongs to; empty when never saved
};

/// Writes the copy of this process. Problems when it cannot be written.
simcore::Problems write(const Document& document);
/// Removes the copy of this process.
void discard();
/// A copy whose process is gone, if there is one.
std::optional<Leftover> findLeftover();
void remove(const Leftover& leftover);

}  // namespace widgets::autosave
