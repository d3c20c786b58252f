// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a JSON object that a person wrote: the first that is wrong is told, with what is allowed.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis::tracking {

using Json = nlohmann::json;

/// A file that holds one object, of at most 1 MiB. The error names the file.
Result<Json> read_json_object(const std::string& path);

/// Reads on after a field that is wrong, with a value within its range; status() tells the first.
class Fields {
public:
    /// json outlives it. where: for errors, as in "rig.json, camera 2".
    Fields(const Json& json, std::string where) : json_(json), where_(std::move(where)) {}

    double number(const char* name, double low, double high, std::optional<double> otherwise = {});
    int whole(const char* name, int low, int high, std::optional<int> otherwise = {});
    bool yes(const char* name, bool otherwise);
    std::string text(const char* name, std::optional<std::string> otherwise = {});
    std::vector<std::string> texts(const char* name);
    VecX numbers(const char* name, int count, double largest);
    std::vector<Vec3> points(const char* name, double largest);
    /// An object in it; an empty one where there is none.
    const Json& object(const char* name);
    [[nodiscard]] bool has(const char* name) const { return json_.contains(name); }
    /// Any field but these is unknown, and its name told.
    void only(const std::vector<std::string>& known);
    void refuse(const char* name, std::string allowed);
    [[nodiscard]] Status status() const { return wrong_ ? Status(*wrong_) : success(); }

private:
    const Json& json_;
    std::string where_;
    std::optional<Error> wrong_{};
};

}  // namespace rhexis::tracking
