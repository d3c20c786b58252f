// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/nearest_place.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

// By the region of its plane in which the point lies.
std::array<double, 3> nearest_to_point(const std::array<Vec3, 3>& t, const Vec3& p) {
    const Vec3 ab = t[1] - t[0];
    const Vec3 ac = t[2] - t[0];
    const Vec3 ap = p - t[0];
    const double d1 = ab.dot(ap);
    const double d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return {1.0, 0.0, 0.0};
    }
    const Vec3 bp = p - t[1];
    const double d3 = ab.dot(bp);
    const double d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) {
        return {0.0, 1.0, 0.0};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double v = d1 / (d1 - d3);
        return {1.0 - v, v, 0.0};
    }
    const Vec3 cp = p - t[2];
    const double d5 = ab.dot(cp);
    const double d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) {
        return {0.0, 0.0, 1.0};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double w = d2 / (d2 - d6);
        return {1.0 - w, 0.0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - w, w};
    }
    const double sum = va + vb + vc;
    if (!(sum > 0.0)) {
        return {1.0, 0.0, 0.0};  // crushed to a line
    }
    return {va / sum, vb / sum, vc / sum};
}

namespace {

using Weights = std::array<double, 3>;

/// Where along the edge from p to q the place is that is nearest to the segment from a to b, 0 to 1 [Ericson2005].
double along_edge(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
    const Vec3 edge = q - p;
    const Vec3 other = b - a;
    const Vec3 way = p - a;
    const double ee = edge.squaredNorm();
    const double oo = other.squaredNorm();
    const double eo = edge.dot(other);
    const double ew = edge.dot(way);
    const double ow = other.dot(way);
    const double square = ee * oo - eo * eo;
    double s = square > 0.0 ? std::clamp((eo * ow - ew * oo) / square, 0.0, 1.0) : 0.0;
    const double t = oo > 0.0 ? (eo * s + ow) / oo : 0.0;
    if (t < 0.0 || t > 1.0) {
        s = ee > 0.0 ? std::clamp((t < 0.0 ? -ew : eo - ew) / ee, 0.0, 1.0) : 0.0;
    }
    return s;
}

/// Where a segment goes through a triangle's plane, if that is in the triangle.
bool crossing(const std::array<Vec3, 3>& x, const Vec3& a, const Vec3& b, Weights& found) {
    const Vec3 u = x[1] - x[0];
    const Vec3 v = x[2] - x[0];
    const Vec3 normal = u.cross(v);
    const double from = normal.dot(a - x[0]);
    const double to = normal.dot(b - x[0]);
    if (from * to >= 0.0) {
        return false;
    }
    const Vec3 way = a + from / (from - to) * (b - a) - x[0];
    const double square = normal.squaredNorm();
    const double second = way.cross(v).dot(normal) / square;
    const double third = u.cross(way).dot(normal) / square;
    found = {1.0 - second - third, second, third};
    return *std::min_element(found.begin(), found.end()) >= 0.0;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double square = along.squaredNorm();
    const double share = square > 0.0 ? std::clamp(along.dot(p - a) / square, 0.0, 1.0) : 0.0;
    return (a + share * along - p).norm();
}

}  // namespace

// What does not cross is nearest at an end of the segment or at an edge of the triangle.
Weights nearest_to_segment(const std::array<Vec3, 3>& triangle, const Vec3& a, const Vec3& b) {
    Weights best{};
    if (crossing(triangle, a, b, best)) {
        return best;
    }
    double least = HUGE_VAL;
    const auto consider = [&](const Weights& weights) {
        const double distance = distance_to_segment(place_in(triangle, weights), a, b);
        if (distance < least) {
            least = distance;
            best = weights;
        }
    };
    consider(nearest_to_point(triangle, a));
    consider(nearest_to_point(triangle, b));
    for (std::size_t from = 0; from < 3; ++from) {
        const std::size_t to = (from + 1) % 3;
        const double share = along_edge(triangle[from], triangle[to], a, b);
        Weights weights{};
        weights[from] = 1.0 - share;
        weights[to] = share;
        consider(weights);
    }
    return best;
}

}  // namespace rhexis
