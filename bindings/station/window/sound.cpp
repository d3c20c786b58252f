// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/sound.hpp"

namespace rhexis::station {
namespace {

constexpr int samples_per_s = 44100;
constexpr Uint16 samples_at_once = 512;  ///< 12 ms: heard with the picture

void fill(void* voices, Uint8* bytes, int size) {
    static_cast<Voices*>(voices)->mix(
        {reinterpret_cast<float*>(bytes), static_cast<std::size_t>(size) / sizeof(float)});
}

}  // namespace

Result<std::unique_ptr<Sound>> Sound::open() {
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) {
        return Error{std::string("no sound: ") + SDL_GetError(), "", "a loudspeaker, or --silent"};
    }
    std::unique_ptr<Sound> sound(new Sound(samples_per_s));
    SDL_AudioSpec wanted{};
    wanted.freq = samples_per_s;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 1;
    wanted.samples = samples_at_once;
    wanted.callback = fill;
    wanted.userdata = &sound->voices_;
    sound->device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
    if (sound->device_ == 0) {
        return Error{std::string("no sound: ") + SDL_GetError(), "", "a loudspeaker, or --silent"};
    }
    SDL_PauseAudioDevice(sound->device_, 0);
    return sound;
}

Sound::~Sound() {
    if (device_ != 0) {
        SDL_CloseAudioDevice(device_);
    }
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

void Sound::tell(const Heard& heard) {
    if (heard.silent) {
        voices_.hush();
    } else {
        voices_.tell(heard.machine, heard.force_mN);
    }
}

}  // namespace rhexis::station
