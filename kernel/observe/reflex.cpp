// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/reflex.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

/// Weights of linear red, green and blue in luminance [BT709].
const Vec3 luminance_weights(0.2126, 0.7152, 0.0722);
const Vec3 fundus(1.0, 0.26, 0.10);

double brightness(const Vec3& pupil_mean, const Vec3& transmission) {
    const Vec3 light = luminance_weights.cwiseProduct(fundus);
    return light.dot(pupil_mean.cwiseProduct(transmission)) / light.sum();
}

Vec2 across(const Vec3& place) { return {place.x(), place.y()}; }

}  // namespace

const Vec3& fundus_colour() { return fundus; }

Reflex reflex_of(const ColumnGrid& grid, const ColumnFill& fill, const LensMotion& motion, double pupil_radius) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    const int reach = static_cast<int>(std::ceil(pupil_radius / grid.cell));
    for (int row = -reach; row <= reach; ++row) {
        for (int column = -reach; column <= reach; ++column) {
            const Vec2 place(column * grid.cell, row * grid.cell);
            if (place.squaredNorm() > pupil_radius * pupil_radius) {
                continue;
            }
            const int cell = grid.cell_at(across(motion.to_rest(Vec3(place.x(), place.y(), 0.0))));
            sum += cell >= 0 ? fill.transmission[cell] : Vec3(Vec3::Ones());
            ++count;
        }
    }
    Reflex reflex;
    if (count > 0) {
        reflex.pupil_mean = sum / count;
        reflex.mean_brightness = brightness(reflex.pupil_mean, reflex.pupil_mean);
    }
    return reflex;
}

double reflex_around(const Reflex& reflex, const ColumnGrid& grid, const ColumnFill& fill, const LensMotion& motion,
                     double pupil_radius, const Vec3& place, double radius) {
    double sum = 0.0;
    int count = 0;
    const int reach = static_cast<int>(std::ceil(radius / grid.cell));
    for (int row = -reach; row <= reach; ++row) {
        for (int column = -reach; column <= reach; ++column) {
            const Vec2 offset(column * grid.cell, row * grid.cell);
            const Vec2 here = across(place) + offset;
            if (offset.squaredNorm() > radius * radius || here.squaredNorm() > pupil_radius * pupil_radius) {
                continue;
            }
            const int cell = grid.cell_at(across(motion.to_rest(Vec3(here.x(), here.y(), 0.0))));
            sum += brightness(reflex.pupil_mean, cell >= 0 ? fill.transmission[cell] : Vec3(Vec3::Ones()));
            ++count;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

}  // namespace rhexis
