#pragma once

#include <QString>
#include <string>

namespace widgets {

/// A channel's name on the screen in the user's language; English where there is no other.
QString channelTitle(const std::string& label);

}  // namespace widgets
