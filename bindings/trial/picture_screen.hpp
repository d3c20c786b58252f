// SPDX-License-Identifier: GPL-3.0-or-later
// A window with pictures beside each other and a table under them, for whoever has such: the shared object with windows
// makes one, and another that knows nothing of windows shows in it what its cameras see.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/frame.hpp"

namespace rhexis {

struct ScreenPicture {
    std::string name{};
    Image image{};        ///< empty: as it was the last time
    bool warned = false;  ///< something is wrong with what it shows: framed
};

/// A line of the table.
struct ScreenRow {
    std::array<unsigned char, 3> colour{};  ///< of its first cell: red, green, blue
    std::vector<std::string> cells{};       ///< as many as there are titles, or fewer
};

struct ScreenMoment {
    std::string state{};    ///< a line over everything
    std::string warning{};  ///< beside it, in another colour; empty: none
    std::vector<ScreenPicture> pictures{};
    std::vector<std::string>
        titles{};  ///< of the table's columns; the first one's cells are to the left, others' to the right
    std::vector<ScreenRow> rows{};
    std::vector<std::string> legend{};  ///< what is drawn in pictures: lines of the help
};

/// What a person at the window wants.
struct ScreenWish {
    bool end = false;         ///< it was closed, or Escape was pressed
    int one = -1;             ///< number of the picture that is wanted alone; -1: all
    int picture_width = 400;  ///< of pictures that fill their place [pixels]
};

class PictureScreen {
public:
    virtual ~PictureScreen() = default;
    /// Draws a moment and takes what keys and mouse asked for since. Waits for the display at most.
    virtual ScreenWish show(const ScreenMoment& moment) = 0;
    /// Draws a moment and keeps what the window shows of it as a PNG file.
    virtual Status keep(const ScreenMoment& moment, const std::string& png) = 0;
};

struct ScreenOptions {
    std::string title{};
    int width = 1280;  ///< of the window [pixels]
    int height = 800;
    std::string screenshot{};  ///< PNG file for what the window shows in the end; empty: none
};

/// Opens one for the thread that calls, which alone may use it and takes it down. The error says that a display is
/// missing.
using OpenScreen = void(const ScreenOptions& options, Result<std::unique_ptr<PictureScreen>>& screen);
inline constexpr const char* open_screen_name = "rhexis_station_picture_screen";

}  // namespace rhexis
