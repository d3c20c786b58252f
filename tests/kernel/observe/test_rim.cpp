// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/observe/cut.hpp"
#include "math/rotation.hpp"
#include "math/symmetric_eigen.hpp"
#include "observe/opening.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

void check_round(const Cut& cut, const Vec2& centre, double share_of_diameter) {
    const RhexisShape shape = cut.shape();
    CAPTURE(cut.edge());
    CAPTURE(centre.transpose());
    CHECK(cut.parts() == 2);
    CHECK(shape.opened);
    CHECK(shape.closed);
    CHECK_FALSE(shape.run_out);
    CHECK(shape.turned == doctest::Approx(2.0 * pi));
    CHECK(std::abs(shape.circularity - 1.0) < 0.01);
    CHECK(std::abs(shape.mean_diameter / 5.2 - 1.0) < share_of_diameter);
    CHECK((shape.centre - centre).norm() < 0.05);
    CHECK(shape.flap_area == doctest::Approx(pi * 2.6 * 2.6).epsilon(2.0 * share_of_diameter));
    CHECK(shape.loose_area == doctest::Approx(shape.flap_area).epsilon(0.1));  // of a dome, and seen along the axis
    CHECK(shape.largest_radius == doctest::Approx(2.6 + centre.norm()).epsilon(0.1));
    CHECK(shape.smallest_radius == doctest::Approx(2.6 - centre.norm()).epsilon(0.1));
}

/// The same curve as seen at a right angle to the plane that fits it best.
std::vector<Vec3> seen_squarely(std::vector<Vec3> curve) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& x : curve) {
        middle += x / static_cast<double>(curve.size());
    }
    Mat3 spread = Mat3::Zero();
    for (const Vec3& x : curve) {
        spread += (x - middle) * (x - middle).transpose();
    }
    const SymmetricEigen3 axes = symmetric_eigen(spread);
    Eigen::Index least = 0;
    axes.values.minCoeff(&least);
    const Quat turn = turn_of_z(axes.vectors.col(least) * axes.vectors(2, least)).conjugate();
    for (Vec3& x : curve) {
        x = turn * (x - middle);
    }
    return curve;
}

/// Diameter of the circle of the area that a curve encloses as seen along z.
double diameter_of(const std::vector<Vec3>& curve) {
    double area = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec3& next = curve[(i + 1) % curve.size()];
        area += 0.5 * (curve[i].x() * next.y() - curve[i].y() * next.x());
    }
    return 2.0 * std::sqrt(std::abs(area) / pi);
}

}  // namespace

TEST_SUITE("rim") {
    TEST_CASE("nothing is torn: there is no opening and no number") {
        const RhexisShape shape = Cut(centred_square(600)).shape();
        CHECK_FALSE(shape.opened);
        CHECK_FALSE(shape.closed);
        CHECK_FALSE(shape.run_out);
        CHECK(shape.length == 0.0);
        CHECK(shape.loose_area == 0.0);
        CHECK(shape.turned == 0.0);
        CHECK(shape.flap_area == 0.0);
        for (const double number : {shape.tip_radius, shape.tip_heading, shape.largest_radius, shape.smallest_radius,
                                    shape.mean_diameter, shape.circularity, shape.centre.x(), shape.centre.y()}) {
            CHECK(std::isnan(number));
        }
    }

    TEST_CASE("a slit is an opening that is not closed; across the axis it has not turned about it") {
        Cut cut(centred_square(1500));
        cut.puncture_at(Vec2(2.0, 0.0), Vec2::UnitY());
        const RhexisShape shape = cut.shape();
        CHECK(shape.opened);
        CHECK_FALSE(shape.closed);
        CHECK(shape.length == doctest::Approx((cut.place(cut.state.tips[0]) - cut.place(cut.state.tips[1])).norm()));
        CHECK(shape.length == doctest::Approx(cut.state.torn_area / 0.01));
        CHECK(shape.turned == doctest::Approx(shape.length / 2.0).epsilon(0.1));
        CHECK(shape.flap_area == doctest::Approx(0.0).epsilon(0.01));
        CHECK(std::isnan(shape.mean_diameter));
        Cut middle(centred_square(1500));
        middle.puncture_at(Vec2::Zero(), Vec2::UnitY());
        CHECK(middle.shape().turned == 0.0);
    }

    TEST_CASE("a circle scores 1 within 0.01, on axis and off it, whatever the mesh") {
        // a path lies within half an edge of its line, which is 0.2 mm with 1,500 triangles: the diameter may be more
        // off
        for (const auto& [triangles, share] : {std::pair(1500, 0.015), std::pair(2400, 0.01), std::pair(9600, 0.01)}) {
            for (const TriMesh& mesh : {centred_square(triangles), jittered_round(triangles)}) {
                for (const Vec2& centre : {Vec2(0.0, 0.0), Vec2(0.4, 0.0), Vec2(-0.2, 0.3464)}) {
                    Cut cut(mesh);
                    cut.cut_along(circle(2.6, centre));
                    check_round(cut, centre, share);
                }
            }
            Cut cut(round_sheet(5.0, triangles));  // rings of edges about the axis would lead a tear about the axis
            cut.cut_along(circle(2.6, Vec2(0.4, 0.0)));
            check_round(cut, Vec2(0.4, 0.0), share);
        }
    }

    TEST_CASE("an ellipse scores what its closed form says") {
        const double perimeter = 4.0 * 3.0 * std::comp_ellint_2(std::sqrt(1.0 - 4.0 / 9.0));
        const double expected = 4.0 * pi * pi * 3.0 * 2.0 / (perimeter * perimeter);
        for (const int triangles : {2400, 9600}) {
            Cut cut(jittered_round(triangles));
            cut.cut_along(ellipse(3.0, 2.0));
            const RhexisShape shape = cut.shape();
            CHECK(shape.closed);
            CHECK(std::abs(shape.circularity - expected) < 0.01);
            CHECK(shape.mean_diameter == doctest::Approx(2.0 * std::sqrt(6.0)).epsilon(0.01));
            CHECK(std::abs(shape.smallest_radius - 2.0) < 0.5 * cut.edge());
            CHECK(std::abs(shape.largest_radius - 3.0) < 0.5 * cut.edge());
        }
    }

    TEST_CASE("the piece that has come off is taken out: what is left is measured as before") {
        Cut cut(domed(jittered_round(3000), 10.0));
        cut.cut_along(circle(2.6));
        REQUIRE(cut.parts() == 2);
        const RhexisShape before = cut.shape();
        const int outer = cut.nearest_to(Vec2(4.0, 0.0));
        CHECK(take_out(cut.model, cut.state, {outer}).out.empty());  // the rest of the capsule stays
        const int inner = cut.nearest_to(Vec2::Zero());
        cut.state.tips.push_back({inner});
        cut.state.grips.push_back({0, inner, Vec3::Zero(), false, 0.0});
        cut.state = applied(cut.state, take_out(cut.model, cut.state, {inner}));
        CHECK(cut.parts() == 1);
        CHECK(is_out(*cut.state.sheet, inner));
        CHECK(cut.state.grips.empty());
        CHECK(cut.state.tips.empty());
        MembraneModel rest = cut.model;
        rest.sheet = cut.state.sheet;
        CHECK(check_membrane(rest, UnusedNodes::allowed).ok());
        const RhexisShape after = cut.shape();
        CHECK(after.closed);
        CHECK(after.mean_diameter == doctest::Approx(before.mean_diameter));
        CHECK(after.circularity == doctest::Approx(before.circularity));
        CHECK(after.loose_area == doctest::Approx(before.loose_area));
        CHECK(after.length == doctest::Approx(before.length));
        CHECK(take_out(cut.model, cut.state, {inner}).out.empty());
    }

    TEST_CASE("half way round: the angle, the tip and the flap are those of half a circle") {
        Cut cut(jittered_round(2400));
        cut.cut_along(circle(2.6), pi);
        RhexisShape shape = cut.shape();
        const Vec2 tip = cut.place(cut.state.tips.back());
        const Vec2 end = cut.place(cut.state.tips.front());
        const double between =
            std::remainder(std::atan2(tip.y(), tip.x()) - std::atan2(end.y(), end.x()) - pi, 2.0 * pi) + pi;
        CHECK_FALSE(shape.closed);
        CHECK(cut.parts() == 1);
        CHECK(shape.turned == doctest::Approx(between));
        CHECK(std::abs(shape.turned / degree - 180.0) < 10.0);
        CHECK(shape.tip_radius == doctest::Approx(tip.norm()));
        CHECK(std::abs(shape.tip_radius - 2.6) < 0.5 * cut.edge());
        CHECK(std::abs(shape.tip_heading / degree) < 10.0);
        CHECK(shape.length == doctest::Approx(2.6 * shape.turned).epsilon(0.05));
        CHECK(shape.flap_area ==
              doctest::Approx(0.5 * 2.6 * 2.6 * (shape.turned - std::sin(shape.turned))).epsilon(0.03));
        CHECK(std::isnan(shape.circularity));
        const Vec2 outward = tip.normalized();
        const Vec2 on(-outward.y(), outward.x());
        cut.go_to(tip + 5.0 * (outward + on));
        CHECK(cut.shape().tip_heading / degree == doctest::Approx(45.0).epsilon(0.2));
        cut.go_to(cut.place(cut.state.tips.back()) - 5.0 * outward + 5.0 * on);
        CHECK(cut.shape().tip_heading / degree == doctest::Approx(-45.0).epsilon(0.2));
    }

    TEST_CASE("the two edges of a tear: the flap's lies inside, the margin outside, and both begin at the tip") {
        for (const double sweep : {0.5 * pi, pi}) {
            Cut cut(round_sheet(5.0, 1500));
            cut.cut_along(circle(2.5), sweep);
            const RhexisShape shape = cut.shape();
            REQUIRE(shape.lip.size() > 3);
            REQUIRE(shape.margin.size() > 3);
            CHECK(shape.lip[0] == cut.state.tips.back().node);
            CHECK(shape.margin[0] == shape.lip[0]);
            const TriNeighbours& around = cut.state.sheet->neighbours;
            for (std::size_t i = 1; i < 3; ++i) {
                CHECK(shape.lip[i] != shape.margin[i]);
                CHECK(cut.node(shape.lip[i]) == cut.node(shape.margin[i]));
                const auto middle = [&](int node) {
                    double sum = 0.0;
                    for (int k = around.offset[at(node)]; k < around.offset[at(node) + 1]; ++k) {
                        sum += triangle_middle(cut.state.sheet->mesh, around.triangles[at(k)]).head<2>().norm();
                    }
                    return sum / (around.offset[at(node) + 1] - around.offset[at(node)]);
                };
                CHECK(middle(shape.lip[i]) < middle(shape.margin[i]));
            }
        }
    }

    TEST_CASE("a tear that goes radially out to the edge has run out") {
        Cut cut(jittered_round(1500));
        cut.puncture_at(Vec2(2.6, 0.0), Vec2::UnitX());
        cut.go_out(Vec2::UnitX(), 4.0);
        CHECK_FALSE(cut.shape().run_out);
        CHECK(cut.shape().largest_radius >= 4.0);
        CHECK(cut.shape().tip_heading / degree == doctest::Approx(90.0).epsilon(0.1));
        cut.go_out(Vec2::UnitX(), 6.0);
        const RhexisShape shape = cut.shape();
        CHECK(shape.run_out);
        CHECK(shape.opened);
        CHECK_FALSE(shape.closed);
        CHECK(shape.largest_radius == doctest::Approx(5.0).epsilon(0.01));
        CHECK(shape.tip_radius == doctest::Approx(cut.place(cut.state.tips[0]).norm()));  // the other one is left
        CHECK(shape.length == doctest::Approx(5.0 - shape.tip_radius).epsilon(0.05));
    }

    TEST_CASE("a tear that has passed where the zonules insert has run out; springs without a slack are no zonules") {
        Cut cut(jittered_round(1500));
        for (int node = 0; node < static_cast<int>(cut.model.sheet->mesh.nodes.size()); ++node) {
            const double across = cut.node(node).head<2>().norm();
            if (across > 3.3) {
                const double slack = across < 3.8 ? 1.0 : 0.0;
                cut.model.springs.push_back({node, 1.5 * cut.node(node), 100.0, slack});
            }
        }
        const double end = zonules_end(cut.model);
        CHECK(end > 3.7);
        CHECK(end < 3.8);
        RhexisGauge gauge;
        cut.puncture_at(Vec2(2.6, 0.0), Vec2::UnitX());
        cut.go_out(Vec2::UnitX(), 3.4);
        gauge.measure(cut.model, cut.state);
        CHECK_FALSE(gauge.shape().run_out);
        cut.go_out(Vec2::UnitX(), 4.0);
        gauge.measure(cut.model, cut.state);
        CHECK(gauge.shape().run_out);
        CHECK_FALSE(cut.shape().run_out);  // not at the sheet's edge
    }

    TEST_CASE("begun in the middle, out and round: the slit in the flap does not count for the rim") {
        Cut cut(jittered_round(2400));
        cut.puncture_at(Vec2::Zero(), Vec2::UnitX());
        cut.go_out(Vec2::UnitX(), 2.5);
        CHECK(cut.shape().turned < 5.0 * degree);
        cut.go_along(circle(2.6), 0.0, 1.5 * pi);
        CHECK(cut.shape().turned / degree == doctest::Approx(270.0).epsilon(0.05));
        cut.go_along(circle(2.6), 1.5 * pi, 3.0 * pi);
        const RhexisShape shape = cut.shape();
        CHECK(shape.closed);
        CHECK(cut.parts() == 2);
        CHECK(shape.circularity > 0.98);
        CHECK(shape.mean_diameter == doctest::Approx(5.2).epsilon(0.015));
        CHECK(std::isnan(shape.tip_radius));  // the tip that is left is the flap's
        CHECK(shape.length == doctest::Approx(cut.state.torn_area / 0.01));
    }

    TEST_CASE("a tag in the rim counts for how far the tear went, not for the rim; it may run out") {
        Cut cut(jittered_round(2400));
        cut.cut_along(circle(2.6));
        const RhexisShape before = cut.shape();
        CHECK(std::isnan(before.tip_radius));
        cut.notch_at(Vec2(2.6, 0.0), Vec2::UnitX());
        cut.go_out(Vec2::UnitX(), 3.5);
        const RhexisShape tag = cut.shape();
        CHECK(tag.closed);
        CHECK(tag.tip_radius >= 3.5);
        CHECK(tag.largest_radius == doctest::Approx(tag.tip_radius));
        CHECK(tag.mean_diameter == doctest::Approx(before.mean_diameter).epsilon(1e-3));
        CHECK(tag.circularity == doctest::Approx(before.circularity).epsilon(2e-3));
        cut.go_out(Vec2::UnitX(), 6.0);
        const RhexisShape out = cut.shape();
        CHECK(out.run_out);
        CHECK(out.closed);
        CHECK(out.mean_diameter == doctest::Approx(before.mean_diameter).epsilon(1e-3));
    }

    TEST_CASE("of two openings the longer one is measured, and the tip that went on last leads") {
        Cut cut(centred_square(1500));
        cut.puncture_at(Vec2(2.6, 0.0), Vec2::UnitY());
        cut.go_along(circle(2.6), 0.0, 0.5 * pi);
        const RhexisShape one = cut.shape();
        cut.puncture_at(Vec2(-2.0, -2.0), Vec2::UnitY());
        const RhexisShape two = cut.shape();
        CHECK(two.turned == one.turned);
        CHECK(two.tip_radius == one.tip_radius);
        CHECK(two.length > one.length);
        std::rotate(cut.state.tips.begin(), cut.state.tips.begin() + 1, cut.state.tips.end());
        const Vec2 other = cut.place(cut.state.tips.back());
        cut.go_to(circle(2.6)(-0.4));
        CHECK((cut.place(cut.state.tips.back()) - other).norm() > 0.0);
        CHECK(cut.shape().tip_radius == doctest::Approx(cut.place(cut.state.tips.back()).norm()));
        CHECK(cut.shape().turned > one.turned);
    }

    TEST_CASE("a tear from edge to edge has run out and closes nothing") {
        Cut cut(centred_square(1500));
        cut.puncture_at(Vec2(2.6, 0.0), Vec2::UnitY());
        while (!cut.state.tips.empty()) {
            const bool up = cut.state.tips.back().direction.y() > 0.0;
            cut.go_to(cut.place(cut.state.tips.back()) + Vec2(0.0, up ? 5.0 : -5.0));
        }
        const RhexisShape shape = cut.shape();
        CHECK(cut.parts() == 2);
        CHECK(shape.run_out);
        CHECK_FALSE(shape.closed);
        CHECK(shape.length == doctest::Approx(10.0).epsilon(0.03));
        CHECK(std::isnan(shape.mean_diameter));
    }

    TEST_CASE("on the front of a lens the rim's own plane would say the same") {
        const Vec2 centre(0.4, 0.3);
        Cut cut(domed(jittered_round(2400), 10.0));
        cut.dome = 10.0;
        cut.cut_along(circle(2.6, centre));
        const RhexisShape shape = cut.shape();
        REQUIRE(shape.closed);
        CHECK(std::abs(shape.circularity - 1.0) < 0.01);
        CHECK((shape.centre - centre).norm() < 0.05);
        const std::vector<Vec3> rim = find_opening(*cut.model.sheet, cut.state).curve;
        const double along_axis = diameter_of(rim);
        CHECK(shape.mean_diameter == doctest::Approx(along_axis).epsilon(0.005));
        CHECK(diameter_of(seen_squarely(rim)) == doctest::Approx(along_axis).epsilon(0.002));
    }

    TEST_CASE("the gauge measures anew when the sheet is another one, and holds what it measured") {
        Cut cut(centred_square(600));
        RhexisGauge gauge;
        gauge.measure(cut.model, cut.state);
        CHECK_FALSE(gauge.shape().opened);
        cut.puncture_at(Vec2(2.0, 0.0), Vec2::UnitY());
        gauge.measure(cut.model, cut.state);
        CHECK(gauge.shape().opened);
        cut.state.position[0] += Vec3(1.0, 0.0, 0.0);
        gauge.measure(cut.model, cut.state);
        CHECK(gauge.shape().length == cut.shape().length);
    }
}
