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
constexpr double fade_mm = 0.9;
constexpr int most_branches = 900;

/// One vessel that still grows.
struct Sprout {
    Vec2 place = Vec2::Zero();
    double heading = 0.0;     ///< now [rad]
    double course = 0.0;      ///< around which it wavers [rad]
    double half_width = 0.0;  ///< [mm]
    double strength = 1.0;    ///< 0 to 1
    double layer = 0.0;       ///< 0 near the surface, 1 deep
    double length = 0.0;      ///< left to grow [mm]
    double grown = 0.0;       ///< since it came up from deeper tissue [mm]
    int generation = 0;
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
    // Vessels come up from deeper tissue, and go down again: no blunt ends.
    const double strength =
        sprout.strength * std::clamp(sprout.grown / fade_mm, 0.0, 1.0) * std::clamp(sprout.length / fade_mm, 0.0, 1.0);
    const std::array<Corner, 4> corners{
        {{from - side_from, -1.0}, {from + side_from, 1.0}, {to + side_to, 1.0}, {to - side_to, -1.0}}};
    for (int i : {0, 1, 2, 0, 2, 3}) {
        const Corner& corner = corners[i];
        for (double value :
             {corner.place.x(), corner.place.y(), corner.across, sprout.length, strength, sprout.layer}) {
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
    twig.course += side * spread(garden, 0.3, 0.8);
    twig.heading = twig.course;
    twig.half_width *= spread(garden, 0.55, 0.8);
    twig.strength *= spread(garden, 0.75, 0.98);
    twig.length *= spread(garden, 0.4, 0.9);
    twig.grown = fade_mm;
    ++twig.generation;
    garden.sprouts.push_back(twig);
}

/// Turns back to its own course, which bends slowly towards the cornea and, close to it, along the limbus.
void set_course(Sprout& sprout, Garden& garden) {
    const double radius = sprout.place.norm();
    const double inward = std::atan2(-sprout.place.y(), -sprout.place.x());
    const double near = std::clamp((garden.limbus_radius + 0.8 - radius) / 0.8, 0.0, 1.0);
    const double off = wrapped(inward - sprout.course);
    const double along = off > 0.0 ? off - 0.5 * std::numbers::pi : off + 0.5 * std::numbers::pi;
    sprout.course += 0.02 * (1.0 - near) * off + 0.30 * near * along + 0.03 * garden.chance.normal();
    const double waver = sprout.layer < 0.5 ? 0.24 : 0.08;
    sprout.heading += 0.22 * wrapped(sprout.course - sprout.heading) + waver * garden.chance.normal();
}

void grow(Sprout sprout, Garden& garden) {
    Vec2 last_side(-std::sin(sprout.heading), std::cos(sprout.heading));
    last_side *= sprout.half_width;
    while (sprout.length > 0.0 && sprout.half_width > 0.0035) {
        set_course(sprout, garden);
        const Vec2 direction(std::cos(sprout.heading), std::sin(sprout.heading));
        const Vec2 next = sprout.place + step_mm * direction;
        if (next.norm() < garden.limbus_radius - 0.1 || next.norm() > garden.outer_radius + 1.5) {
            return;
        }
        sprout.half_width *= 0.993;
        const Vec2 side = sprout.half_width * Vec2(-direction.y(), direction.x());
        add_piece(sprout.place, next, last_side, side, sprout, garden);
        last_side = side;
        sprout.place = next;
        sprout.length -= step_mm;
        sprout.grown += step_mm;
        if (garden.chance.uniform() < (sprout.generation < 3 ? 0.045 : 0.02)) {
            branch(sprout, garden);
        }
    }
}

/// A vessel that starts at an angle around the eye and leaves it by `slant` from straight inward.
void sow(Garden& garden, double angle, double radius, double slant, Sprout sprout) {
    sprout.place = radius * Vec2(std::cos(angle), std::sin(angle));
    sprout.course = angle + std::numbers::pi + slant;
    sprout.heading = sprout.course;
    garden.sprouts.push_back(sprout);
}

void plant(int count, double layer, double widest, Garden& garden) {
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + spread(garden, -0.45, 0.45)) / count;
        const double radius = garden.outer_radius * spread(garden, 0.82, 1.05);
        Sprout sprout;
        sprout.half_width = widest * (0.28 + 0.72 * std::pow(garden.chance.uniform(), 2.0));
        sprout.strength = spread(garden, 0.45, 0.95);
        sprout.layer = layer;
        sprout.length = spread(garden, 2.5, 6.5);
        sow(garden, angle, radius, spread(garden, -0.8, 0.8), sprout);
    }
}

/// Short loops that frame the cornea.
void plant_arcades(int count, Garden& garden) {
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + spread(garden, -0.5, 0.5)) / count;
        const double radius = garden.limbus_radius + spread(garden, 0.35, 1.3);
        Sprout sprout;
        sprout.half_width = spread(garden, 0.006, 0.014);
        sprout.strength = spread(garden, 0.3, 0.6);
        sprout.length = spread(garden, 0.5, 1.4);
        sprout.generation = 2;
        sow(garden, angle, radius, spread(garden, -1.3, 1.3), sprout);
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
