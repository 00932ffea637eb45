#pragma once

#include <string>

#include <fmt/core.h>

namespace simcore {

/// Sentences for people, in the language of the program: every sentence of this library that a
/// user may read is made here. Patterns are English, in the notation of fmt; a program with another
/// language installs a look-up. File formats, keys, columns, names and what developers read
/// (exceptions for a caller's mistake) are no sentences for people: they stay as they are.
///
/// The tools that collect the patterns find `Text::of("...")` and `Text::mark("...")` with a
/// literal in them, so both are always written with the class' name.
class Text {
  public:
    /// Gives the pattern in another language, or itself (or nothing) where there is none.
    using LookUp = std::string (*)(const char* pattern);

    /// Installs the look-up for all threads, null for English. Once, before threads are started:
    /// what was said before stays as it was.
    static void setLookUp(LookUp lookUp);

    /// The pattern in the program's language, with its arguments. Translations may number the
    /// arguments ({0}, {1:.2f}) to change their order, or leave some away. A translation that
    /// cannot be formatted gives way to the English pattern: nothing throws.
    template <class... Args>
    static std::string of(fmt::format_string<Args...> pattern, Args&&... args) {
        return format(pattern, fmt::make_format_args(args...));
    }

    /// Marks a text in a table, which translated() then looks up. No pattern: braces are braces.
    static constexpr const char* mark(const char* text) { return text; }

    /// A marked text in the program's language.
    static std::string translated(const char* marked);

  private:
    static std::string format(fmt::string_view pattern, fmt::format_args args);
};

}  // namespace simcore
