// SPDX-License-Identifier: GPL-3.0-or-later
// What an exercise is called, in the language of a page.
#pragma once

#include <string>

namespace rhexis::cli {

/// As a run or a record names it.
struct NamedExercise {
    std::string id;        ///< name of its folder
    std::string title;     ///< in `language`
    std::string language;  ///< of the run; "": English
};

/// The title in another language where root/curricula has the exercise and it is still called so, else as it is named.
std::string title_in(const std::string& language, const NamedExercise& exercise, const std::string& root);

/// The title of one in root/curricula, or its name.
std::string title_of(const std::string& exercise, const std::string& language, const std::string& root);

}  // namespace rhexis::cli
