// SPDX-License-Identifier: GPL-3.0-or-later
// What lies ready for whoever operates: instruments, dials of the machine, requests to the staff.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "flow/tool.hpp"
#include "session/session.hpp"

namespace rhexis::station {

/// What squeezing does to `jaw`.
enum class Squeeze {
    nothing,  ///< it has no moving part
    closes,   ///< jaws: open when nothing presses
    presses,  ///< a syringe: nothing comes out when nothing presses
    pushes    ///< a plunger, or what stays as it was left
};

struct StandInstrument {
    std::string name;
    Squeeze squeeze = Squeeze::nothing;
    double squeeze_per_s = 0.0;  ///< how fast, whole ways
    bool hand_held = true;       ///< the microscope is not
};

struct Dial {
    std::string setting;
    std::string unit;
    double low = 0.0;
    double high = 1.0;
    double notch = 0.1;
    double value = 0.0;  ///< at the start
};

struct Request {
    std::string id;
    std::string title;
};

struct Stand {
    std::vector<StandInstrument> instruments;  ///< in the scene's order
    std::vector<Dial> dials;
    std::vector<Request> requests;
};

/// declared: of the exercise, [{"id", "title", "name"}].
Stand make_stand(const Session& session, const nlohmann::json& declared);

}  // namespace rhexis::station
