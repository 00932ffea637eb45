#pragma once

#include <cctype>
#include <string>

#include "simcore/base/text.h"

namespace testsupport {

/// While it lives, sentences of simcore are in another language: English in capitals.
class InOtherLanguage {
  public:
    InOtherLanguage() {
        simcore::Text::setLookUp([](const char* pattern) {
            std::string capitals;
            int depth = 0;
            for (; *pattern != '\0'; ++pattern) {
                depth += *pattern == '{' ? 1 : *pattern == '}' ? -1 : 0;
                capitals +=
                    depth > 0
                        ? *pattern
                        : static_cast<char>(std::toupper(static_cast<unsigned char>(*pattern)));
            }
            return capitals;
        });
    }

    ~InOtherLanguage() { simcore::Text::setLookUp(nullptr); }

    InOtherLanguage(const InOtherLanguage&) = delete;
    InOtherLanguage& operator=(const InOtherLanguage&) = delete;
};

}  // namespace testsupport
