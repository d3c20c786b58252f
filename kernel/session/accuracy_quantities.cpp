// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/accuracy_quantities.hpp"

#include <array>

namespace rhexis {
namespace {

constexpr auto known_quantities = std::to_array<AccuracyQuantity>({
    {"balance", "1", 1e-6, 1.0, "Force that a step leaves out of balance on an implant, share of the largest."},
    {"depth", "1", 1e-6, 10.0, "Depth of the anterior chamber, rms over time, share of it."},
    {"force", "1", 1e-6, 10.0,
     "Force on an instrument: of strokes the rms over time, share of the greatest; of a pull at the capsule its mean."},
    {"overlap", "1", 1e-6, 10.0, "How deep an implant goes into what it touches, share of its thickness."},
    {"path", "mm", 1e-6, 10.0, "Way of a tear's tip in the capsule, rms distance from where it goes."},
    {"pressure", "1", 1e-6, 10.0, "Pressure in the anterior chamber, rms over time, share of the highest."},
    {"tear", "1", 1e-6, 10.0, "Length that the capsule tears by a given pull, share of it."},
    {"time", "s", 0.001, 0.02, "How late a step may tell of what happened in it, which is at its end: the step."},
    {"volume", "1", 1e-6, 10.0, "Volume taken out of the lens by a given stroke, share of it."},
});

}  // namespace

std::span<const AccuracyQuantity> accuracy_quantities() { return known_quantities; }

const std::vector<AccuracyModel>& accuracy_models() {
    static const std::vector<AccuracyModel> models{
        {"anterior_capsule", "", {{"force", 0.15}, {"path", 0.2}, {"tear", 0.05}}},
        {"chamber", "", {{"pressure", 0.01}}},
        {"implant", "bag", {{"balance", 0.005}, {"overlap", 0.05}}},
        {"lens", "", {{"depth", 0.05, "chamber"}, {"force", 0.25}, {"volume", 0.1}}},
    };
    return models;
}

}  // namespace rhexis
