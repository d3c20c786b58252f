// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to choose from before an exercise begins: `rhexis train` alone.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis::station {

struct MenuExercise {
    std::string name;  ///< of its folder
    std::string title;
    std::vector<std::string> objectives;
    std::vector<std::string> levels;
    bool lesson = false;  ///< of the course, in whose order they stand; the others follow
    std::string last;     ///< how the last attempt of a person here went; "": there was none
};

struct MenuPatient {
    std::string file;  ///< as for --patient; "": as the exercise says
    std::string note;
};

struct Menu {
    std::vector<MenuExercise> exercises;
    std::vector<MenuPatient> patients;
    std::string root;      ///< folder of scripts/, for words
    std::string language;  ///< "": English
};

struct MenuChoice {
    std::string exercise;  ///< "": none, the station is left
    std::string patient;
    std::string level;
    bool pad = false;
};

/// root: folder with curricula/ and assets/. runs: folder in which attempts lie. language: of the titles. lessons:
/// names of exercises in the order in which they are taught.
Menu collect_menu(const std::string& root, const std::string& runs, const std::string& language,
                  const std::vector<std::string>& lessons);

inline constexpr const char* menu_entry_name = "rhexis_station_choose";
using MenuEntry = void(const Menu& menu, Result<MenuChoice>& choice);

}  // namespace rhexis::station
