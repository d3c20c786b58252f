// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and video of a run, drawn beside it: what is drawn never changes what is simulated.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/frame.hpp"

namespace rhexis {

struct Picture {
    std::string file;  ///< relative to the run's folder
    std::string name;
    std::string caption;
    double time_s = 0.0;
};

/// Which moments of a run are on its video.
class FilmClock {
public:
    explicit FilmClock(double pictures_per_second) : pictures_per_second_(pictures_per_second) {}
    /// True once the run has reached the next picture's time.
    [[nodiscard]] bool wants(double time_s) const;
    /// The next picture is taken.
    void advance() { ++frames_; }
    /// All pictures up to this time are.
    void advance_beyond(double time_s);

private:
    double pictures_per_second_;
    long frames_ = 0;
};

class PictureBook {
public:
    /// Draws into folder/frames, and into folder/video.mp4 if asked. Fails without a device to draw with.
    static Result<PictureBook> create(const std::string& folder, bool video, double pictures_per_second = 25.0);
    ~PictureBook();
    PictureBook(PictureBook&&) noexcept;

    Status keep(const Frame& frame, const std::string& name, const std::string& caption);
    /// From now on what is kept is drawn when the book is finished: who operates by the wall clock is not kept waiting.
    void draw_later();
    /// Adds video frames until the video has reached the frame's time.
    Status film(const Frame& frame);
    /// True when the video wants a frame at this time: only then is one worth making.
    [[nodiscard]] bool wants_film(double time_s) const;
    Status finish();

    [[nodiscard]] const std::vector<Picture>& pictures() const;
    [[nodiscard]] bool has_video() const;
    /// As far as the video is.
    [[nodiscard]] FilmClock clock() const;

private:
    struct Parts;
    explicit PictureBook(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
