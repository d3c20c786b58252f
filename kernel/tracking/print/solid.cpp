// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/print/solid.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

namespace rhexis::tracking {
namespace {

constexpr int sectors = 48;  ///< of a surface of revolution

/// Corners of a ring of a surface of revolution; all alike on the axis.
std::array<Vec3, sectors> ring_of(const Axis& axis, const ProfilePoint& point) {
    const Vec3 across = axis.along.unitOrthogonal();
    const Vec3 beside = axis.along.cross(across);
    std::array<Vec3, sectors> ring;
    for (int i = 0; i < sectors; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sectors;
        ring[static_cast<std::size_t>(i)] = axis.from + point.height * axis.along +
                                            point.radius * (std::cos(angle) * across + std::sin(angle) * beside);
    }
    return ring;
}

/// Between two rings; a side on the axis has no width, and gives no triangle.
void add_band(const Axis& axis, const ProfilePoint& low, const ProfilePoint& high, Solid& solid) {
    const std::array<Vec3, sectors> lower = ring_of(axis, low);
    const std::array<Vec3, sectors> upper = ring_of(axis, high);
    for (std::size_t i = 0; i < sectors; ++i) {
        const std::size_t next = (i + 1) % sectors;
        if (low.radius > 0.0) {
            solid.push_back({lower[i], lower[next], upper[next]});
        }
        if (high.radius > 0.0) {
            solid.push_back({lower[i], upper[next], upper[i]});
        }
    }
}

/// Triangles by the numbers of their corners.
class Welded {
public:
    /// A triangle with two corners at one place has no area.
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const std::array<int, 3> triangle{number_of(a), number_of(b), number_of(c)};
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
            triangles_.push_back(triangle);
        }
    }

    /// False: it is no surface.
    bool close() {
        std::map<std::pair<int, int>, int> edges;
        for (const std::array<int, 3>& triangle : triangles_) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (++edges[{triangle[i], triangle[(i + 1) % 3]}] > 1) {
                    return false;
                }
            }
        }
        std::map<int, int> rim;  // of holes: the way that a triangle goes which closes them
        for (const auto& [edge, count] : edges) {
            const auto& [from, to] = edge;
            if (!edges.contains({to, from}) && !rim.emplace(to, from).second) {
                return false;
            }
        }
        while (!rim.empty()) {
            if (!close_hole(rim)) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] Solid solid() const {
        Solid all;
        for (const auto& [a, b, c] : triangles_) {
            all.push_back({place(a), place(b), place(c)});
        }
        return all;
    }

private:
    [[nodiscard]] const Vec3& place(int number) const { return places_[static_cast<std::size_t>(number)]; }

    int number_of(const Vec3& at) {
        constexpr double one_place = 1e6;  // per millimetre
        std::array<std::int64_t, 3> cell{};
        for (int i = 0; i < 3; ++i) {
            cell[static_cast<std::size_t>(i)] = std::llround(one_place * at[i]);
        }
        const auto [found, fresh] = numbers_.emplace(cell, static_cast<int>(places_.size()));
        if (fresh) {
            places_.push_back(at);
        }
        return found->second;
    }

    bool close_hole(std::map<int, int>& rim) {
        std::vector<int> loop;
        Vec3 middle = Vec3::Zero();
        for (auto next = rim.begin(); next != rim.end(); next = rim.find(loop.back())) {
            loop.push_back(next->second);
            middle += place(next->second);
            rim.erase(next);
        }
        const auto count = loop.size();
        if (count < 3) {
            return false;
        }
        const int hub = static_cast<int>(places_.size());
        places_.emplace_back(middle / static_cast<double>(count));
        for (std::size_t i = 0; i < count; ++i) {
            triangles_.push_back({loop[i], loop[(i + 1) % count], hub});
        }
        return true;
    }

    std::vector<Vec3> places_;
    std::map<std::array<std::int64_t, 3>, int> numbers_;
    std::vector<std::array<int, 3>> triangles_;
};

void append_word(std::uint32_t word, int bytes, std::string& out) {
    for (int i = 0; i < bytes; ++i) {
        out += static_cast<char>((word >> (8 * i)) & 0xffU);
    }
}

void append_vector(const Eigen::Vector3f& vector, std::string& out) {
    for (int i = 0; i < 3; ++i) {
        append_word(std::bit_cast<std::uint32_t>(vector[i]), 4, out);
    }
}

}  // namespace

Solid revolved(const Axis& axis, std::span<const ProfilePoint> profile) {
    Solid solid;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        add_band(axis, profile[i], profile[i + 1], solid);
    }
    return solid;
}

Result<Solid> closed_shell(std::span<const Vec3> corners, const std::string& where) {
    Welded welded;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        welded.add(corners[i], corners[i + 1], corners[i + 2]);
    }
    if (!welded.close()) {
        return Error{"its triangles make no closed shell", where, "each edge is one of two triangles, or a hole's"};
    }
    return welded.solid();
}

std::string binary_stl(const Solid& solid) {
    std::string triangles;
    std::uint32_t count = 0;
    for (const Triangle& triangle : solid) {
        const Eigen::Vector3f a = triangle[0].cast<float>();
        const Eigen::Vector3f b = triangle[1].cast<float>();
        const Eigen::Vector3f c = triangle[2].cast<float>();
        if (a == b || b == c || c == a) {
            continue;
        }
        const Vec3 normal = (b - a).cast<double>().cross((c - a).cast<double>());
        append_vector(Vec3(normal.normalized()).cast<float>(), triangles);
        for (const Eigen::Vector3f& corner : {a, b, c}) {
            append_vector(corner, triangles);
        }
        append_word(0, 2, triangles);
        ++count;
    }
    std::string out = "millimetres";
    out.resize(80, ' ');
    append_word(count, 4, out);
    return out + triangles;
}

}  // namespace rhexis::tracking
