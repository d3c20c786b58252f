// SPDX-License-Identifier: GPL-3.0-or-later
// The station's loudspeaker.
#pragma once

#include <SDL.h>

#include <memory>

#include "base/result.hpp"
#include "station/desk.hpp"
#include "station/voices.hpp"

namespace rhexis::station {

class Sound {
public:
    /// The error says that there is no loudspeaker; without one everything goes on in silence.
    static Result<std::unique_ptr<Sound>> open();
    ~Sound();
    Sound(const Sound&) = delete;
    Sound& operator=(const Sound&) = delete;

    /// Sounds as this step does.
    void tell(const Heard& heard);

private:
    explicit Sound(double samples_per_s) : voices_(samples_per_s) {}

    Voices voices_;
    SDL_AudioDeviceID device_ = 0;
};

}  // namespace rhexis::station
