#include "widgets/plots/channel_titles.h"

#include "simcore/base/text.h"

namespace widgets {

QString channelTitle(const std::string& label) {
    return QString::fromStdString(simcore::Text::translated(label.c_str()));
}

}  // namespace widgets
