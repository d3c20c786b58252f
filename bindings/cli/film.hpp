// SPDX-License-Identifier: GPL-3.0-or-later
// A recording simulated again and filmed.
#pragma once

#include "base/result.hpp"
#include "cli/pictures.hpp"
#include "session/recording.hpp"

namespace rhexis::cli {

/// label: of the progress shown. stills: also pictures of the start and the end. The book is finished then.
Status film_recording(const Recording& recording, PictureBook& book, bool stills, bool quiet,
                      const std::string& label = "film");

}  // namespace rhexis::cli
