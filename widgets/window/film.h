#pragma once

#include <QString>
#include <functional>

#include "simcore/base/problem.h"
#include "widgets/session/run_session.h"
#include "widgets/viewport/viewport.h"

namespace widgets {

/// What is to be filmed of the run on show.
struct FilmRequest {
    QString file;        ///< .mp4, .webm or .gif
    double from = 0.0;   ///< [s], simulated
    double to = 0.0;     ///< [s]
    double speed = 1.0;  ///< simulated over film time
    int rate = 25;       ///< pictures a second
};

/// Writes the 3-D view of a run as a film, by the program ffmpeg: the view as large as it is, from
/// where one looks now. The run is paused; what was on show is on show again at the end.
/// `goOn` is called with the part that is done [0 to 1]; false ends it, and nothing is left behind.
///
/// Problems: no run, no ffmpeg, an ending that is not known, a file that cannot be written. None
/// when it was ended.
simcore::Problems writeFilm(RunSession& session, Viewport& viewport, const FilmRequest& request,
                            const std::function<bool(double)>& goOn);

}  // namespace widgets
