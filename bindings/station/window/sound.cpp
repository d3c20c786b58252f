// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/sound.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace rhexis::station {
namespace {

constexpr int samples_per_s = 44100;
constexpr Uint16 samples_at_once = 512;  ///< 12 ms: heard with the picture

void fill(void* voices, Uint8* bytes, int size) {
    static_cast<Voices*>(voices)->mix(
        {reinterpret_cast<float*>(bytes), static_cast<std::size_t>(size) / sizeof(float)});
}

/// Libraries of sound tell on the terminal, in many lines, that a machine has no loudspeaker: while this lives, they
/// tell nobody. Before other threads begin.
class QuietTerminal {
public:
    QuietTerminal() : kept_(::dup(STDERR_FILENO)) {
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (kept_ >= 0 && nowhere >= 0) {
            ::dup2(nowhere, STDERR_FILENO);
        }
        if (nowhere >= 0) {
            ::close(nowhere);
        }
    }
    ~QuietTerminal() {
        if (kept_ >= 0) {
            ::dup2(kept_, STDERR_FILENO);
            ::close(kept_);
        }
    }
    QuietTerminal(const QuietTerminal&) = delete;
    QuietTerminal& operator=(const QuietTerminal&) = delete;

private:
    int kept_;
};

}  // namespace

Result<std::unique_ptr<Sound>> Sound::open() {
    const QuietTerminal quiet;
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
