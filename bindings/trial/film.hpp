// SPDX-License-Identifier: GPL-3.0-or-later
// A recording simulated again and filmed.
#pragma once

#include "base/result.hpp"
#include "session/recording.hpp"
#include "trial/pictures.hpp"

namespace rhexis {

/// label: of the progress shown. stills: also pictures of the start and the end. The book is finished then.
Status film_recording(const Recording& recording, PictureBook& book, bool stills, bool quiet,
                      const std::string& label = "film");

}  // namespace rhexis
