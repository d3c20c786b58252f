// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/json_fields.hpp"

#include <algorithm>
#include <cmath>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "base/text_file.hpp"

namespace rhexis::tracking {
namespace {

constexpr std::size_t longest_file = 1 << 20;  ///< [bytes]

bool read_numbers(const Json& list, double largest, VecX& all) {
    if (!list.is_array() || static_cast<Eigen::Index>(list.size()) != all.size()) {
        return false;
    }
    for (Eigen::Index i = 0; i < all.size(); ++i) {
        const Json& number = list[static_cast<std::size_t>(i)];
        if (!number.is_number() || !(std::abs(number.get<double>()) <= largest)) {
            return false;
        }
        all[i] = number.get<double>();
    }
    return true;
}

}  // namespace

Result<Json> read_json_object(const std::string& path) {
    const Result<std::string> text = read_text_file(path, longest_file);
    if (!text) {
        return text.error();
    }
    Json json = Json::parse(without_mark(text.value()), nullptr, false);
    if (!json.is_object()) {
        return Error{"this is not an object of JSON", path, "{...}"};
    }
    return json;
}

double Fields::number(const char* name, double low, double high, std::optional<double> otherwise) {
    if (otherwise && !json_.contains(name)) {
        return *otherwise;
    }
    const auto found = json_.find(name);
    if (found == json_.end() || !found->is_number() || !(found->get<double>() >= low) ||
        !(found->get<double>() <= high)) {
        refuse(name, "a number, " + range_text(low, high));
        return low;
    }
    return found->get<double>();
}

int Fields::whole(const char* name, int low, int high, std::optional<int> otherwise) {
    const double given = number(name, low, high, otherwise ? std::optional<double>(*otherwise) : std::nullopt);
    if (given != std::floor(given)) {
        refuse(name, "a whole number, " + range_text(low, high));
    }
    return static_cast<int>(given);
}

bool Fields::yes(const char* name, bool otherwise) {
    const auto found = json_.find(name);
    if (found == json_.end()) {
        return otherwise;
    }
    if (!found->is_boolean()) {
        refuse(name, "true or false");
        return otherwise;
    }
    return found->get<bool>();
}

std::string Fields::text(const char* name, std::optional<std::string> otherwise) {
    const auto found = json_.find(name);
    if (found == json_.end() && otherwise) {
        return *otherwise;
    }
    if (found == json_.end() || !found->is_string() || found->get<std::string>().empty()) {
        refuse(name, "a text");
        return "";
    }
    return found->get<std::string>();
}

std::vector<std::string> Fields::texts(const char* name) {
    std::vector<std::string> all;
    const auto found = json_.find(name);
    bool listed = found != json_.end() && found->is_array();
    for (std::size_t i = 0; listed && i < found->size(); ++i) {
        listed = (*found)[i].is_string();
        all.push_back(listed ? (*found)[i].get<std::string>() : "");
    }
    if (!listed) {
        refuse(name, "a list of texts");
    }
    return all;
}

VecX Fields::numbers(const char* name, int count, double largest) {
    const auto found = json_.find(name);
    VecX all = VecX::Zero(count);
    if (found == json_.end() || !read_numbers(*found, largest, all)) {
        refuse(name, std::to_string(count) + " numbers, " + range_text(-largest, largest));
    }
    return all;
}

std::vector<Vec3> Fields::points(const char* name, double largest) {
    std::vector<Vec3> all;
    const auto found = json_.find(name);
    const bool listed = found != json_.end() && found->is_array();
    for (std::size_t i = 0; listed && i < found->size(); ++i) {
        VecX point = VecX::Zero(3);
        if (!read_numbers((*found)[i], largest, point)) {
            refuse(name, "points of 3 numbers, " + range_text(-largest, largest));
        }
        all.emplace_back(point);
    }
    if (!listed) {
        refuse(name, "a list of points");
    }
    return all;
}

const Json& Fields::object(const char* name) {
    static const Json none = Json::object();
    const auto found = json_.find(name);
    if (found == json_.end()) {
        return none;
    }
    if (!found->is_object()) {
        refuse(name, "{...}");
        return none;
    }
    return *found;
}

void Fields::only(const std::vector<std::string>& known) {
    for (const auto& [name, value] : json_.items()) {
        if (std::find(known.begin(), known.end(), name) != known.end() || wrong_) {
            continue;
        }
        std::string allowed;
        for (const std::string& one : known) {
            allowed.append(allowed.empty() ? "one of " : ", ").append(one);
        }
        wrong_ = Error{"unknown field \"" + name + "\"" + did_you_mean(name, known), where_, allowed};
    }
}

void Fields::refuse(const char* name, std::string allowed) {
    if (!wrong_) {
        const auto found = json_.find(name);
        const std::string given = found == json_.end() ? "is missing" : "is " + found->dump();
        wrong_ = Error{std::string("\"") + name + "\" " + given, where_, std::move(allowed)};
    }
}

}  // namespace rhexis::tracking
