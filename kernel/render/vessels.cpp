// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/vessels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/rng.hpp"
#include "math/types.hpp"

namespace rhexis {

namespace {

constexpr double step_mm = 0.09;
constexpr int most_branches = 900;

/// One vessel that still grows.
struct Sprout {
    Vec2 place;
    double heading;     ///< [rad]
    double half_width;  ///< [mm]
    double strength;    ///< 0 to 1
    double layer;       ///< 0 near the surface, 1 deep
    double length;      ///< left to grow [mm]
    int generation;
};

struct Garden {
    double limbus_radius;
    double outer_radius;
    Rng chance;
    std::vector<Sprout> sprouts;
    std::vector<float> ribbons;
    int branches = 0;
};

double spread(Garden& garden, double low, double high) { return low + (high - low) * garden.chance.uniform(); }

void add_piece(const Vec2& from, const Vec2& to, const Vec2& side_from, const Vec2& side_to, const Sprout& sprout,
               Garden& garden) {
    struct Corner {
        Vec2 place;
        double across;
    };
    const std::array<Corner, 4> corners{
        {{from - side_from, -1.0}, {from + side_from, 1.0}, {to + side_to, 1.0}, {to - side_to, -1.0}}};
    for (int i : {0, 1, 2, 0, 2, 3}) {
        const Corner& corner = corners[i];
        for (double value :
             {corner.place.x(), corner.place.y(), corner.across, sprout.length, sprout.strength, sprout.layer}) {
            garden.ribbons.push_back(static_cast<float>(value));
        }
    }
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

void branch(const Sprout& from, Garden& garden) {
    if (garden.branches >= most_branches || from.half_width < 0.010) {
        return;
    }
    ++garden.branches;
    Sprout twig = from;
    const double side = garden.chance.uniform() < 0.5 ? -1.0 : 1.0;
    twig.heading += side * spread(garden, 0.35, 0.9);
    twig.half_width *= spread(garden, 0.55, 0.8);
    twig.strength *= spread(garden, 0.75, 0.98);
    twig.length *= spread(garden, 0.4, 0.9);
    ++twig.generation;
    garden.sprouts.push_back(twig);
}

/// Wavers, and is drawn towards the cornea, near which it turns to run along the limbus.
double turn(const Sprout& sprout, double& sway, Garden& garden) {
    const double radius = sprout.place.norm();
    const double inward = std::atan2(-sprout.place.y(), -sprout.place.x());
    sway = 0.86 * sway + 0.30 * garden.chance.normal() * (sprout.layer < 0.5 ? 1.0 : 0.5);
    const double near = std::clamp((garden.limbus_radius + 0.9 - radius) / 0.9, 0.0, 1.0);
    const double off = wrapped(inward - sprout.heading);
    const double along = off > 0.0 ? off - 0.5 * std::numbers::pi : off + 0.5 * std::numbers::pi;
    return 0.5 * sway + 0.05 * (1.0 - near) * off + 0.35 * near * along;
}

void grow(Sprout sprout, Garden& garden) {
    double sway = 0.0;
    Vec2 last_side(-std::sin(sprout.heading), std::cos(sprout.heading));
    last_side *= sprout.half_width;
    while (sprout.length > 0.0 && sprout.half_width > 0.0035) {
        sprout.heading += turn(sprout, sway, garden);
        const Vec2 direction(std::cos(sprout.heading), std::sin(sprout.heading));
        const Vec2 next = sprout.place + step_mm * direction;
        if (next.norm() < garden.limbus_radius - 0.1 || next.norm() > garden.outer_radius + 1.5) {
            return;
        }
        sprout.half_width *= 0.9955;
        const Vec2 side = sprout.half_width * Vec2(-direction.y(), direction.x());
        add_piece(sprout.place, next, last_side, side, sprout, garden);
        last_side = side;
        sprout.place = next;
        sprout.length -= step_mm;
        if (garden.chance.uniform() < (sprout.generation < 3 ? 0.045 : 0.02)) {
            branch(sprout, garden);
        }
    }
}

void plant(int count, double layer, double widest, Garden& garden) {
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + spread(garden, -0.45, 0.45)) / count;
        const double radius = garden.outer_radius * spread(garden, 0.82, 1.05);
        const double size = std::pow(garden.chance.uniform(), 2.0);
        garden.sprouts.push_back({Vec2(radius * std::cos(angle), radius * std::sin(angle)),
                                  angle + std::numbers::pi + spread(garden, -0.7, 0.7), widest * (0.28 + 0.72 * size),
                                  spread(garden, 0.45, 0.95), layer, spread(garden, 2.5, 6.5), 0});
    }
}

/// Short loops that frame the cornea.
void plant_arcades(int count, Garden& garden) {
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + spread(garden, -0.5, 0.5)) / count;
        const double radius = garden.limbus_radius + spread(garden, 0.35, 1.3);
        garden.sprouts.push_back({Vec2(radius * std::cos(angle), radius * std::sin(angle)),
                                  angle + std::numbers::pi + spread(garden, -1.3, 1.3), spread(garden, 0.006, 0.014),
                                  spread(garden, 0.3, 0.6), 0.0, spread(garden, 0.5, 1.4), 2});
    }
}

}  // namespace

std::vector<float> vessel_ribbons(double limbus_radius, double outer_radius, std::uint64_t seed) {
    Garden garden{limbus_radius, outer_radius, Rng(seed, "vessels"), {}, {}, 0};
    plant(26, 1.0, 0.11, garden);
    plant(46, 0.0, 0.050, garden);
    plant_arcades(150, garden);
    while (!garden.sprouts.empty()) {
        const Sprout sprout = garden.sprouts.back();
        garden.sprouts.pop_back();
        grow(sprout, garden);
    }
    return std::move(garden.ribbons);
}

}  // namespace rhexis
