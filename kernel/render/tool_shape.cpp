// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_shape.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "base/assert.hpp"
#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "render/instrument_text.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

constexpr double farthest_mm = 200.0;
constexpr int bends = 6;  ///< pieces between two points of a smooth wire

const std::vector<std::pair<std::string, ToolFinish>>& finishes() {
    static const std::vector<std::pair<std::string, ToolFinish>> table = {
        {"titanium", ToolFinish::titanium}, {"bore", ToolFinish::bore},   {"sleeve", ToolFinish::sleeve},
        {"steel", ToolFinish::steel},       {"clear", ToolFinish::clear}, {"hub", ToolFinish::hub},
        {"sponge", ToolFinish::sponge},     {"nylon", ToolFinish::nylon}};
    return table;
}

const std::vector<std::pair<std::string, WireEnds>>& all_ends() {
    static const std::vector<std::pair<std::string, WireEnds>> table = {
        {"round", WireEnds::round}, {"flat", WireEnds::flat}, {"open", WireEnds::open}};
    return table;
}

/// Reads the fields of one part; the first mistake is kept.
class PartReader {
public:
    PartReader(const json& part, std::string where) : part_(part), where_(std::move(where)) {}

    void fail(const std::string& what, const std::string& allowed) {
        if (!error_) {
            error_ = Error{what, where_, allowed};
        }
    }

    double number(const char* name, double standard, double low, double high) {
        const json value = part_.value(name, json(standard));
        return in_range(value, name, low, high);
    }

    template <typename T>
    T choice(const char* name, T standard, const std::vector<std::pair<std::string, T>>& table) {
        if (!part_.contains(name)) {
            return standard;
        }
        const json& given = part_.at(name);
        std::vector<std::string> known;
        for (const auto& [word, value] : table) {
            if (given == word) {
                return value;
            }
            known.push_back(word);
        }
        fail(std::string(name) + " is " + given.dump(),
             suggestion(given.is_string() ? given.get<std::string>() : "", known));
        return standard;
    }

    template <int N>
    Eigen::Matrix<double, N, 1> point(const json& value, const char* name) {
        Eigen::Matrix<double, N, 1> place = Eigen::Matrix<double, N, 1>::Zero();
        if (!value.is_array() || value.size() != N) {
            fail(std::string(name) + " holds " + value.dump(), "points of " + std::to_string(N) + " numbers");
            return place;
        }
        for (int i = 0; i < N; ++i) {
            place[i] = in_range(value[static_cast<std::size_t>(i)], name, -farthest_mm, farthest_mm);
        }
        return place;
    }

    template <int N>
    std::vector<Eigen::Matrix<double, N, 1>> points(const char* name, std::size_t least) {
        std::vector<Eigen::Matrix<double, N, 1>> list;
        const json& given = part_.at(name);
        if (!given.is_array() || given.size() < least) {
            fail(std::string(name) + " is " + given.dump(), std::to_string(least) + " points or more");
            return list;
        }
        for (const json& one : given) {
            list.push_back(point<N>(one, name));
        }
        return list;
    }

    [[nodiscard]] const json& part() const { return part_; }
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

    double in_range(const json& value, const char* name, double low, double high) {
        const double number = value.is_number() ? value.get<double>() : std::nan("");
        if (!(number >= low && number <= high)) {
            fail(std::string(name) + " is " + value.dump(),
                 "a number, " + short_number(low) + " to " + short_number(high));
            return low;
        }
        return number;
    }

private:
    const json& part_;
    std::string where_;
    std::optional<Error> error_;
};

/// Through all points, each piece in several (Catmull and Rom).
void bend_smoothly(ToolWire& wire) {
    const std::vector<Vec3> points = std::exchange(wire.points, {});
    const std::vector<double> radii = std::exchange(wire.radii, {});
    const auto last = static_cast<int>(points.size()) - 1;
    for (int i = 0; i < last; ++i) {
        const Vec3& a = points[static_cast<std::size_t>(std::max(0, i - 1))];
        const Vec3& b = points[static_cast<std::size_t>(i)];
        const Vec3& c = points[static_cast<std::size_t>(i + 1)];
        const Vec3& d = points[static_cast<std::size_t>(std::min(last, i + 2))];
        // tangents no longer than the piece itself, or a long piece would swing out beside a short one
        const double length = (c - b).norm();
        const auto held = [length](const Vec3& way) {
            return Vec3(way.norm() > length ? length * way.normalized() : way);
        };
        const Vec3 from = held(0.5 * (c - a));
        const Vec3 to = held(0.5 * (d - b));
        for (int k = 0; k < bends; ++k) {
            const double s = static_cast<double>(k) / bends;
            const double s2 = s * s;
            const double s3 = s2 * s;
            wire.points.emplace_back((2 * s3 - 3 * s2 + 1) * b + (s3 - 2 * s2 + s) * from + (3 * s2 - 2 * s3) * c +
                                     (s3 - s2) * to);
            wire.radii.push_back((1 - s) * radii[static_cast<std::size_t>(i)] +
                                 s * radii[static_cast<std::size_t>(i + 1)]);
        }
    }
    wire.points.push_back(points.back());
    wire.radii.push_back(radii.back());
}

ToolWire read_wire(PartReader& reader) {
    ToolWire wire;
    wire.points = reader.points<3>("wire", 2);
    const json radii = reader.part().value("radius", json());
    if (!radii.is_array() || radii.size() != wire.points.size()) {
        reader.fail("radius is " + radii.dump(), "a list, one for each point of the wire");
        return wire;
    }
    for (const json& radius : radii) {
        wire.radii.push_back(reader.in_range(radius, "radius", 0.001, 20.0));
    }
    if (reader.part().contains("section")) {
        const Vec2 section = reader.point<2>(reader.part().at("section"), "section");
        wire.section = {reader.in_range(section.x(), "section", 0.05, 20.0),
                        reader.in_range(section.y(), "section", 0.05, 20.0)};
    }
    wire.ends = reader.choice("ends", WireEnds::round, all_ends());
    wire.bore = reader.number("bore", 0.0, 0.0, 20.0);
    if (reader.part().value("smooth", json(false)) == true && wire.points.size() > 2) {
        bend_smoothly(wire);
    }
    return wire;
}

std::optional<Hinge> read_hinge(PartReader& reader) {
    if (!reader.part().contains("opens")) {
        return std::nullopt;
    }
    const json& opens = reader.part().at("opens");
    if (!opens.is_object() || !opens.contains("about") || !opens.contains("axis") || !opens.contains("deg")) {
        reader.fail("opens is " + opens.dump(), "about, axis and deg");
        return std::nullopt;
    }
    Hinge hinge;
    hinge.about = reader.point<3>(opens.at("about"), "opens");
    const Vec3 axis = reader.point<3>(opens.at("axis"), "opens");
    hinge.axis = axis.norm() > 0.0 ? Vec3(axis.normalized()) : Vec3(Vec3::UnitZ());
    hinge.open_rad = reader.in_range(opens.at("deg"), "deg", -90.0, 90.0) * std::numbers::pi / 180.0;
    return hinge;
}

ToolShapePart read_part(PartReader& reader) {
    ToolShapePart part;
    part.finish = reader.choice("finish", ToolFinish::steel, finishes());
    part.hinge = read_hinge(reader);
    if (reader.part().contains("wire")) {
        part.wire = read_wire(reader);
    } else if (reader.part().contains("plate")) {
        part.plate = ToolPlate{reader.points<2>("plate", 3), reader.number("thickness", 0.1, 0.01, 20.0),
                               reader.number("edge", 0.1, 0.0, 20.0)};
    } else if (reader.part().contains("own_part")) {
        part.own_part = static_cast<int>(reader.number("own_part", 0.0, 0.0, 100.0));
        part.own_ends = reader.choice("ends", WireEnds::round, all_ends());
    } else {
        reader.fail("it is of no kind", "a wire, a plate, or an own_part");
    }
    return part;
}

}  // namespace

Result<ToolShape> read_tool_shape(const std::string& text, const std::string& where) {
    const json file = json::parse(text, nullptr, false);
    if (!file.is_object() || !file.contains("parts") || !file.at("parts").is_array()) {
        return Error{"this is no shape of an instrument", where, "a JSON object with parts"};
    }
    ToolShape shape;
    shape.with_own_parts = file.value("with_own_parts", json(false)) == true;
    for (std::size_t i = 0; i < file.at("parts").size(); ++i) {
        const std::string place = where + ": part " + std::to_string(i + 1);
        const json& given = file.at("parts").at(i);
        if (!given.is_object()) {
            return Error{"it is no object", place, "{ \"wire\": ... }"};
        }
        PartReader reader(given, place);
        shape.parts.push_back(read_part(reader));
        if (reader.error()) {
            return *reader.error();
        }
    }
    return shape;
}

std::optional<ToolShape> shape_of_instrument(const std::string& name) {
    const std::string file = name + ".json";
    const std::string_view text = instrument_text(file);
    if (text.empty()) {
        return std::nullopt;
    }
    const json parsed = json::parse(text, nullptr, false);
    if (parsed.is_object() && parsed.contains("same_as")) {
        return shape_of_instrument(parsed.at("same_as").get<std::string>());
    }
    Result<ToolShape> shape = read_tool_shape(std::string(text), file);
    RHEXIS_ASSERT(shape.ok());  // the files of the program are tested
    return std::move(shape).value();
}

}  // namespace rhexis
