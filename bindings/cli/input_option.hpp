// SPDX-License-Identifier: GPL-3.0-or-later
// --input: what an exercise is operated with, where no virtual surgeon operates.
#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "station/person.hpp"
#include "station/tracked_source.hpp"

namespace rhexis::cli {

inline constexpr const char* registration_help =
    "With vrpn: JSON file of where the tracked head's frame lies in the eye's [as it is]";

/// For CLI11: empty, or what is wrong with a name that is neither mouse, gamepad nor a tracking system's address.
std::string is_input(const std::string& input);
/// Likewise, with a tracking system only.
std::string is_tracked_input(const std::string& input);

struct TrackedArguments {
    std::string input;         ///< "vrpn://HOST"; empty: a virtual surgeon operates, or nobody
    std::string registration;  ///< file; may be empty
    double wait_s = 10.0;      ///< for a server, before anything begins
    double give_up_s = 60.0;   ///< that the clock may stand: nobody comes back
};

/// A person without a window, whose instruments are seen by a tracking system: the station as far as it needs no
/// screen.
class HeadlessPerson {
public:
    /// Waits for the server. Fails where there is none, with why; until then nothing was written.
    static Result<std::unique_ptr<HeadlessPerson>> connect(const TrackedArguments& given,
                                                           const ExerciseOptions& exercise);
    [[nodiscard]] Guest& guest() { return *person_; }
    /// The clock stood for so long that the attempt was ended.
    [[nodiscard]] bool gave_up() const { return source_->over(); }

private:
    HeadlessPerson() = default;

    station::Desk desk_;  ///< nobody sits at it
    std::unique_ptr<station::TrackedSource> source_;
    std::unique_ptr<station::Person> person_;
};

}  // namespace rhexis::cli
