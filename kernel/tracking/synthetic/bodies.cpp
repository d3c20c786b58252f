// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/bodies.hpp"

namespace rhexis::tracking::synthetic {
namespace {

/// An instrument whose markers' centre is this far behind its tip.
MarkerBody instrument(const char* name, double behind_mm, std::vector<Vec3> markers) {
    MarkerBody body;
    body.name = name;
    body.markers = std::move(markers);
    body.tip.position = {0.0, 0.0, -behind_mm};
    return body;
}

MarkerBody head() {
    MarkerBody body;
    body.name = "head";
    body.markers = {{40.71, -2.46, -16.90}, {8.10, 37.69, 15.44}, {-46.71, 7.24, -14.59}, {-2.10, -42.46, 16.04}};
    body.tip.position = {0.0, -93.0, -20.0};  // the eye, below and before a plate on the forehead
    return body;
}

}  // namespace

std::vector<MarkerBody> standard_bodies() {
    // found by simulated annealing on the distances: all differ by 2.1 mm or more
    return {head(),
            instrument("phaco", 105.0,
                       {{-4.08, -24.43, -25.63}, {13.42, 1.70, 24.12}, {-21.82, 10.27, -9.33}, {12.49, 12.46, 10.83}}),
            instrument("capsulorhexis_forceps", 95.0,
                       {{14.48, 4.14, -1.20}, {14.61, 6.51, -20.67}, {-9.50, 7.14, 4.40}, {-19.60, -17.80, 17.48}}),
            instrument("chopper", 85.0,
                       {{-0.18, 21.97, 6.14}, {14.76, -4.34, -5.29}, {-13.91, 6.81, 15.66}, {-0.67, -24.44, -16.50}})};
}

}  // namespace rhexis::tracking::synthetic
