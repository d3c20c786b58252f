// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/bodies/known_bodies.hpp"

#include "base/assert.hpp"
#include "tracking/marker_body_text.hpp"
#include "tracking/rig.hpp"

namespace rhexis::tracking {

std::optional<MarkerBody> known_body(const std::string& name) {
    const std::string file = name + ".json";
    const std::string_view text = marker_body_text(file);
    if (text.empty()) {
        return std::nullopt;
    }
    Result<MarkerBody> body = marker_body_of(std::string(text), file);
    RHEXIS_ASSERT(body.ok());  // the files of the program are tested
    return std::move(body).value();
}

Result<std::vector<MarkerBody>> known_bodies(std::span<const std::string> instruments) {
    std::vector<MarkerBody> bodies;
    std::vector<std::string> names{head_name};
    names.insert(names.end(), instruments.begin(), instruments.end());
    for (const std::string& name : names) {
        std::optional<MarkerBody> body = known_body(name);
        if (!body) {
            return Error{"no marker body comes with \"" + name + "\"", "marker bodies", "rhexis track design " + name};
        }
        bodies.push_back(std::move(*body));
    }
    return bodies;
}

}  // namespace rhexis::tracking
