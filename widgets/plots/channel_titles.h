#pragma once

#include <QString>
#include <string>

namespace widgets {

/// What simcore calls a channel or says of it, in the user's language: files have it in English.
QString channelTitle(const std::string& label);

}  // namespace widgets
