// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/index.hpp"
#include "mesh/shapes.hpp"
#include "observe/opening.hpp"
#include "observe/rim.hpp"
#include "scenes/membranes.hpp"
#include "topology/tear.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

/// Where a tear is to go: a place by an angle [rad], as seen from above.
using Line = std::function<Vec2(double)>;

Line ellipse(double a, double b, const Vec2& centre = Vec2::Zero()) {
    return [=](double angle) { return Vec2(centre.x() + a * std::cos(angle), centre.y() + b * std::sin(angle)); };
}
Line circle(double radius, const Vec2& centre = Vec2::Zero()) { return ellipse(radius, radius, centre); }

TriMesh centred_square(int triangles) {
    TriMesh mesh = square_sheet(10.0, triangles);
    for (Vec3& x : mesh.nodes) {
        x -= Vec3(5.0, 5.0, 0.0);
    }
    return mesh;
}
TriMesh jittered_round(int triangles) { return jittered(round_sheet(5.0, triangles), 0.2, 3); }

/// The front of a lens: how much lower it is than at the axis [mm].
double height(const Vec2& place, double radius) { return std::sqrt(radius * radius - place.squaredNorm()) - radius; }

/// A flat sheet laid on the front of a lens.
TriMesh domed(TriMesh mesh, double radius) {
    for (Vec3& x : mesh.nodes) {
        x.z() = height(x.head<2>(), radius);
    }
    return mesh;
}

/// A sheet and a knife whose tip is the leading one.
struct Cut {
    MembraneModel model;
    MembraneState state;
    double dome = HUGE_VAL;  ///< radius of the front that it lies on [mm]

    explicit Cut(const TriMesh& mesh)
        : model(membrane("anterior_capsule", mesh, {1.0e6, 1.0e6, 0.45, 0.0})), state(rest_state(model)) {}

    [[nodiscard]] RhexisShape shape() const { return rhexis_shape(*model.sheet, state); }
    [[nodiscard]] double edge() const { return mean_edge(model.sheet->mesh); }
    [[nodiscard]] const Vec3& node(int n) const { return state.sheet->mesh.nodes[at(n)]; }
    [[nodiscard]] Vec2 place(const TearTip& tip) const { return node(tip.node).head<2>(); }
    [[nodiscard]] int parts() const {
        const std::vector<int> parts = sheet_parts(state.sheet->neighbours);
        return 1 + *std::max_element(parts.begin(), parts.end());
    }

    void carry(const Result<MembraneEdit>& edit) {
        REQUIRE(edit.ok());
        state = applied(state, edit.value());
    }

    [[nodiscard]] int nearest_node(const Vec2& to, const std::vector<int>& among) const {
        return *std::min_element(among.begin(), among.end(), [&](int a, int b) {
            return (node(a).head<2>() - to).norm() < (node(b).head<2>() - to).norm();
        });
    }

    /// Opens the capsule at the node nearest to a place; the leading tip is the one ahead.
    void puncture_at(const Vec2& where, const Vec2& ahead) {
        const TriNeighbours& around = state.sheet->neighbours;
        std::vector<int> all;
        for (int n = 0; n < static_cast<int>(state.sheet->mesh.nodes.size()); ++n) {
            all.push_back(n);
        }
        const int n = nearest_node(where, all);
        const int triangle = around.triangles[at(around.offset[at(n)])];
        carry(puncture(model, state, triangle, node(n), Vec3(-ahead.x(), -ahead.y(), 0.0)));
    }

    /// One edge on, to a place. What the tip is owed is what the tear adds by itself.
    void go_to(const Vec2& to) {
        const Vec3 here = node(state.tips.back().node) + state.tips.back().owed;
        const Vec3 there(to.x(), to.y(), std::isfinite(dome) ? height(to, dome) : 0.0);
        carry(tear(model, state, static_cast<int>(state.tips.size()) - 1, there - here));
    }

    /// Counter-clockwise along a line from one angle to another, or until the tear has met its beginning.
    void go_along(const Line& line, double from, double to) {
        const std::size_t tips = state.tips.size();
        double angle = from;
        while (state.tips.size() == tips && angle < to) {
            const Vec2 here = state.tips.back().owed.head<2>() + place(state.tips.back());
            while ((line(angle + 0.01) - here).norm() < std::max(edge(), (line(angle) - here).norm())) {
                angle += 0.01;
            }
            const Vec2 beginning = place(state.tips.front());
            const bool home = angle > from + pi && (beginning - here).norm() < 1.5 * edge();
            go_to(home ? beginning : line(angle));
        }
    }

    /// The angle at which a node lies closest to a line.
    [[nodiscard]] double best_start(const Line& line) const {
        double best = 0.0;
        double least = HUGE_VAL;
        for (double angle = 0.0; angle < 2.0 * pi; angle += 0.01) {
            for (const Vec3& x : model.sheet->mesh.nodes) {
                const double distance = (x.head<2>() - line(angle)).norm();
                best = distance < least ? angle : best;
                least = std::min(least, distance);
            }
        }
        return best;
    }

    /// Along a line, by an angle; all the way round without one.
    void cut_along(const Line& line, double sweep = 3.0 * pi) {
        const double start = best_start(line);
        puncture_at(line(start), line(start + 0.01) - line(start - 0.01));
        go_along(line, start, start + sweep);
    }

    /// Begins a tear at an edge of the sheet. Where two pieces lie on each other only one of them lies ahead.
    void notch_at(const Vec2& where, const Vec2& ahead) {
        std::vector<int> edges;
        for (const std::vector<int>& loop : boundary_loops(state.sheet->mesh, state.sheet->neighbours)) {
            edges.insert(edges.end(), loop.begin(), loop.end());
        }
        const Vec3 nearest = node(nearest_node(where, edges));
        for (const int n : edges) {
            const Result<MembraneEdit> edit = notch(model, state, n, Vec3(ahead.x(), ahead.y(), 0.0));
            if (node(n) == nearest && edit.ok()) {
                state = applied(state, edit.value());
                return;
            }
        }
        FAIL("nothing to tear there");
    }

    /// Straight on, while the tip is nearer than that to the axis and has not run out.
    void go_out(const Vec2& ahead, double radius) {
        const std::size_t tips = state.tips.size();
        while (state.tips.size() == tips && place(state.tips.back()).norm() < radius) {
            go_to(place(state.tips.back()) + 5.0 * ahead);
        }
    }
};

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
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
    const Quat turn = Quat::FromTwoVectors(axes.eigenvectors().col(0) * axes.eigenvectors()(2, 0), Vec3::UnitZ());
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
