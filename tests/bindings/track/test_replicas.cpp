// SPDX-License-Identifier: GPL-3.0-or-later
// Replicas of all instruments that have a body, as they are printed.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "kernel/tracking/stl_support.hpp"
#include "track/replica.hpp"
#include "tracking/bodies/known_bodies.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

std::vector<MarkerBody> printed_bodies() {
    std::vector<MarkerBody> bodies;
    for (const auto& entry : std::filesystem::directory_iterator("assets/tracking/bodies")) {
        bodies.push_back(known_body(entry.path().stem().string()).value());
    }
    return bodies;
}

std::vector<StlShell> shells_of_print(const MarkerBody& body, const Replica& replica) {
    const Result<std::string> stl = marker_body_stl(body, replica);
    REQUIRE_MESSAGE(stl.ok(), (stl ? "" : stl.error().text()));
    std::vector<StlShell> shells = closed_shells_of(read_stl(stl.value()));
    for (const StlShell& shell : shells) {
        CHECK(shell.volume > 0.0);
    }
    return shells;
}

/// The solid angle under which a shell is seen from a place, over that of everything: 1 within it.
double winding(const StlShell& shell, const Vec3& place) {
    double sum = 0.0;
    for (const StlFacet& facet : shell.facets) {
        const Vec3 a = vector_of(facet[1]) - place;
        const Vec3 b = vector_of(facet[2]) - place;
        const Vec3 c = vector_of(facet[3]) - place;
        const double below =
            a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
        sum += 2.0 * std::atan2(a.dot(b.cross(c)), below);
    }
    return sum / (4.0 * std::numbers::pi);
}

double distance_to_facet(const StlFacet& facet, const Vec3& place) {
    const Vec3 a = vector_of(facet[1]);
    const Vec3 u = vector_of(facet[2]) - a;
    const Vec3 v = vector_of(facet[3]) - a;
    double least = std::numeric_limits<double>::max();
    const Mat2 gram{{u.dot(u), u.dot(v)}, {u.dot(v), v.dot(v)}};
    const Vec2 inside = gram.inverse() * Vec2(u.dot(place - a), v.dot(place - a));
    if (inside.allFinite() && inside.minCoeff() >= 0.0 && inside.sum() <= 1.0) {
        least = (a + inside[0] * u + inside[1] * v - place).norm();
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 from = vector_of(facet[1 + i]);
        const Vec3 way = vector_of(facet[1 + (i + 1) % 3]) - from;
        const double share = std::clamp(way.dot(place - from) / way.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (from + share * way - place).norm());
    }
    return least;
}

/// From the body's tip to its shape; 0 within it. Of an open end, cut slant, to the plane of its foremost point.
double tip_off_shape(const MarkerBody& body, const std::vector<StlShell>& shells, std::size_t shape_shells) {
    double least = std::numeric_limits<double>::max();
    double foremost = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < shape_shells; ++i) {
        if (winding(shells[i], body.tip.position) > 0.5) {
            return 0.0;
        }
        for (const StlFacet& facet : shells[i].facets) {
            least = std::min(least, distance_to_facet(facet, body.tip.position));
            for (std::size_t corner = 1; corner < 4; ++corner) {
                foremost = std::min(foremost, body.tip.to_body(vector_of(facet[corner])).z());
            }
        }
    }
    return std::min(least, std::abs(foremost));
}

}  // namespace

TEST_CASE("every body is printed with its instrument's shape and without, in closed shells; the tip is where it says") {
    std::size_t instruments = 0;
    for (const MarkerBody& body : printed_bodies()) {
        CAPTURE(body.name);
        Replica replica;
        if (body.name != head_name) {
            Result<Replica> read = replica_of(body.name);
            REQUIRE_MESSAGE(read.ok(), (read ? "" : read.error().text()));
            replica = std::move(read).value();
            const std::vector<StlShell> shells = shells_of_print(body, replica);
            CHECK(shells.size() == replica.shape.size() + 1 + body.markers.size());
            CHECK(tip_off_shape(body, shells, replica.shape.size()) < 0.05);
            MarkerBody elsewhere = body;
            elsewhere.tip.position += elsewhere.tip.orientation * Vec3(0.0, 0.0, -1.0);
            CHECK(tip_off_shape(elsewhere, shells, replica.shape.size()) > 0.05);
            replica.shape.clear();
            ++instruments;
        }
        CHECK(shells_of_print(body, replica).size() == 1 + body.markers.size());
    }
    CHECK(instruments > 20);
    CHECK(replica_of("scalpel").error().text().find("scalpel") != std::string::npos);
}

TEST_CASE("a sleeve lies about the handle as it is drawn") {
    for (const char* name : {"forceps", "chopper", "spatula", "phaco"}) {
        CAPTURE(name);
        const MarkerBody body = known_body(name).value();
        const Replica replica = replica_of(name).value();
        const Handle handle = moved_to(body.tip, *replica.handle);
        const std::vector<StlShell> shells = shells_of_print(body, Replica{replica.handle, {}});
        double bore = 1e9;
        for (const StlFacet& facet : shells[0].facets) {
            const Vec3 way = vector_of(facet[1]) - handle.foot;
            bore = std::min(bore, (way - way.dot(handle.along) * handle.along).norm());
        }
        // no part of the drawn handle within the sleeve is thicker than the bore
        double from = 1e9;
        double to = -1e9;
        for (const StlFacet& facet : shells[0].facets) {
            const double behind = (vector_of(facet[1]) - handle.foot).dot(handle.along);
            from = std::min(from, behind);
            to = std::max(to, behind);
        }
        CHECK(to - from >= 8.0);
        double thickest = 0.0;
        for (const Solid& shell : replica.shape) {
            for (const Triangle& triangle : shell) {
                for (int i = 0; i < 60; ++i) {  // places along its edges
                    const auto side = static_cast<std::size_t>(i % 3);
                    const double share = (i / 3) / 20.0;
                    const Vec3 place = (1.0 - share) * triangle[side] + share * triangle[(side + 1) % 3];
                    const Vec3 way = body.tip.to_world(place) - handle.foot;
                    const double behind = way.dot(handle.along);
                    if (behind > from && behind < to) {
                        thickest = std::max(thickest, (way - behind * handle.along).norm());
                    }
                }
            }
        }
        CHECK(thickest > 0.5 * bore);
        CHECK(thickest < bore);
    }
}

}  // namespace rhexis::tracking
