// SPDX-License-Identifier: GPL-3.0-or-later
// Needle and forceps on the capsule of an eye.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "scenes/capsule_scene.hpp"
#include "tools/probe.hpp"
#include "tools/rhexis_tools.hpp"

using namespace rhexis;
using scenes::CapsuleScene;

namespace {

Vec3 above(const CapsuleScene& scene, double x, double y, double height) {
    return scene.front(x, y) + height * Vec3::UnitZ();
}

int folded_triangles(const CapsuleScene& scene, const MembraneState& sheet) {
    int count = 0;
    for (int t = 0; t < static_cast<int>(sheet.sheet->mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = sheet.sheet->mesh.triangles[at(t)];
        const Vec3& a = sheet.position[at(n[0])];
        const Vec3 now = (sheet.position[at(n[1])] - a).cross(sheet.position[at(n[2])] - a);
        count += now.dot(front_of(scene.model().sheet->mesh, 0)) < 0.0 ? 1 : 0;
    }
    return count;
}

}  // namespace

TEST_SUITE("sheet grip") {
    TEST_CASE("a needle goes through at 15 to 35 mN, wherever it is pressed; a blunt rod does not") {
        for (const double x : {0.0, 1.5, 2.5}) {
            CapsuleScene scene(68.0, {}, {cystotome()});
            scene.put(0, above(scene, x, 0.2, 0.3));
            CHECK(scene.lead(0, above(scene, x, 0.2, -0.6), 1.0));
            CHECK(scene.punctures >= 1);
            CHECK(scene.force_of_puncture > 15000.0);
            CHECK(scene.force_of_puncture < 35000.0);
            CHECK(scene.sheet().tips.size() >= 2);  // a slit begins at a node: on a slope it may take another
            CHECK(scene.force().norm() < 5000.0);   // it is through
        }
        CapsuleScene scene(68.0, {}, {probe(0.25, 30.0)});
        scene.put(0, above(scene, 0.0, 0.0, 0.5));
        CHECK(scene.lead(0, above(scene, 0.0, 0.0, -0.6), 1.0));
        CHECK(scene.greatest_force > 20000.0);
        CHECK(scene.punctures == 0);
        CHECK(scene.sheet().tips.empty());
    }

    TEST_CASE("a needle that is through hooks the lip, drags it, and lets go when it is drawn out") {
        CapsuleScene scene(68.0, {}, {cystotome()});
        scene.put(0, above(scene, 0.9, -0.5, 0.3));
        CHECK(scene.lead(0, above(scene, 0.9, -0.5, -0.5), 1.0));
        CHECK(scene.lead(0, above(scene, 0.9, -0.35, -0.5), 1.0));
        CHECK_FALSE(scene.sheet().grips.empty());
        const double first = scene.force().y();
        CHECK(first > 500.0);
        CHECK(scene.lead(0, above(scene, 0.9, -0.25, -0.5), 1.0));
        CHECK(scene.force().y() > 1.3 * first);
        CHECK(scene.lead(0, above(scene, 0.9, -0.25, 1.0), 5.0));
        CHECK(scene.sheet().grips.empty());
        CHECK(scene.force().isZero());
    }

    TEST_CASE("led along its edge a needle cuts on") {
        CapsuleScene scene(68.0, {}, {cystotome()});
        scene.put(0, above(scene, 0.3, -0.2, 0.3));
        CHECK(scene.lead(0, above(scene, 0.3, -0.2, -0.5), 1.0));
        const double torn = scene.sheet().torn_area;
        scene.greatest_force = 0.0;
        CHECK(scene.lead(0, above(scene, 2.0, -0.2, -0.5), 1.0));
        CHECK(scene.sheet().torn_area > torn + 0.8 * 0.0139);  // 0.8 mm at least
        CHECK(scene.greatest_force < 6000.0);
    }

    TEST_CASE("jaws that close on nothing hold nothing; closed ones take up nothing; opened ones let go") {
        CapsuleScene scene(68.0, {}, {capsulorhexis_forceps()});
        scene.put(0, above(scene, 1.0, 0.0, 2.0), 1.0);
        CHECK(scene.lead(0, above(scene, 1.0, 0.0, 2.0), 1.0, 0.0));
        CHECK(scene.sheet().grips.empty());
        CHECK(scene.lead(0, above(scene, 1.0, 0.0, 0.05), 5.0, 0.0));
        CHECK(scene.sheet().grips.empty());
        CHECK(scene.lead(0, above(scene, 1.0, 0.0, 0.06), 1.0, 1.0));
        CHECK(scene.lead(0, above(scene, 1.0, 0.0, 0.05), 1.0, 0.0));
        CHECK(scene.sheet().grips.size() >= 3);
        CHECK(scene.lead(0, above(scene, 1.0, 0.0, 0.06), 1.0, 1.0));
        CHECK(scene.sheet().grips.empty());
    }

    TEST_CASE("jaws that are closed when they come to a flap push it and hold nothing") {
        CapsuleScene scene(68.0, {}, {capsulorhexis_forceps()});
        scene.open_flap(1.0, 2.6, 0.9);
        scene.put(0, above(scene, 2.2, 0.4, 0.5), 0.0);
        CHECK(scene.lead(0, above(scene, 2.2, 0.4, -0.05), 2.0, 0.0));
        CHECK(scene.force().norm() > 100.0);
        CHECK(scene.lead(0, above(scene, 1.6, 0.8, -0.05), 2.0, 0.0));
        CHECK(scene.sheet().grips.empty());
    }

    TEST_CASE("a needle beside the sheet touches, pierces and hooks nothing") {
        CapsuleScene scene(68.0, {}, {cystotome()});
        double rim = 0.0;
        for (const Vec3& node : scene.model().sheet->mesh.nodes) {
            rim = std::max(rim, node.head<2>().norm());
        }
        scene.put(0, Vec3(rim + 0.4, 0.0, 2.0));
        CHECK(scene.lead(0, Vec3(rim + 0.4, 0.0, -1.0), 5.0));
        CHECK(scene.lead(0, Vec3(rim + 0.4, 1.0, -1.0), 5.0));
        CHECK(scene.greatest_force == 0.0);
        CHECK(scene.punctures == 0);
        CHECK(scene.sheet().grips.empty());
        CHECK(scene.sheet().tips.empty());
    }

    TEST_CASE("an instrument that appears behind the sheet bulges it; only a needle may go through") {
        for (const ToolModel& tool : {probe(0.25, 30.0), capsulorhexis_forceps(), cystotome()}) {
            for (const double depth : {0.05, 0.3, 0.8}) {
                CapsuleScene scene(68.0, {.triangles = 600}, {tool});
                const std::vector<Vec3> rest = scene.model().sheet->mesh.nodes;
                scene.put(0, above(scene, 1.0, 0.3, -depth));
                double farthest = 0.0;
                double fastest = 0.0;
                for (int i = 0; i < 20; ++i) {
                    CHECK(scene.step());
                    for (std::size_t n = 0; n < rest.size(); ++n) {
                        REQUIRE(scene.sheet().position[n].allFinite());
                        farthest = std::max(farthest, (scene.sheet().position[n] - rest[n]).norm());
                        fastest = std::max(fastest, scene.sheet().velocity[n].norm());
                    }
                }
                CHECK(farthest < 1.0);
                CHECK(fastest < 100.0);
                CHECK((scene.punctures > 0 || scene.sheet().grips.empty()));  // through, it pushes the lip
                CHECK((tool.kind == ToolKind::cystotome || scene.sheet().tips.empty()));
                CHECK(scene.punctures <= 1);
            }
        }
    }

    TEST_CASE("what is pulled harder than the jaws hold slips out of them") {
        ToolModel weak = capsulorhexis_forceps();
        weak.hold = 3000.0;
        CapsuleScene scene(68.0, {}, {weak});
        scene.put(0, above(scene, 1.0, 0.0, 0.05), 1.0);
        CHECK(scene.lead(0, above(scene, 1.0, 0.0, 0.05), 1.0, 0.0));
        const std::size_t held = scene.sheet().grips.size();
        REQUIRE(held >= 3);
        scene.greatest_force = 0.0;
        CHECK(scene.lead(0, above(scene, 1.0, 0.0, 2.5), 2.0, 0.0));
        CHECK(scene.greatest_force < 1.05 * weak.hold);
        CHECK(scene.sheet().grips.empty());
    }

    TEST_CASE("a flap is grasped, folds over on the capsule and tears round, at published forces") {
        CapsuleScene scene(68.0, {}, {capsulorhexis_forceps()});
        scene.open_flap(1.0, 2.6, 0.9);
        const double torn = scene.sheet().torn_area;
        scene.put(0, above(scene, 2.2, 0.4, 0.05), 1.0);
        CHECK(scene.lead(0, above(scene, 2.2, 0.4, 0.06), 1.0, 0.0));
        REQUIRE(scene.sheet().grips.size() >= 3);
        scene.greatest_force = 0.0;
        for (int i = 0; i <= 28; ++i) {
            const double angle = 0.2 + 0.08 * i;
            CHECK(scene.lead(0, above(scene, 1.7 * std::cos(angle), 1.7 * std::sin(angle), 0.2), 1.5, 0.0));
        }
        CHECK(folded_triangles(scene, scene.sheet()) > 20);
        CHECK(scene.sheet().torn_area > torn + 0.5 * 0.014);  // half a millimetre, at least
        CHECK(scene.greatest_force > 5000.0);
        CHECK(scene.greatest_force < 20000.0);
    }

    TEST_CASE("the same operation gives the same bits") {
        std::vector<Vec3> first;
        for (int run = 0; run < 2; ++run) {
            CapsuleScene scene(68.0, {}, {capsulorhexis_forceps()});
            scene.open_flap(1.0, 2.6, 0.9);
            scene.put(0, above(scene, 2.2, 0.4, 0.05), 1.0);
            scene.lead(0, above(scene, 2.2, 0.4, 0.06), 1.0, 0.0);
            scene.lead(0, above(scene, 1.4, 1.0, 0.2), 3.0, 0.0);
            CHECK((run == 0 || scene.sheet().position == first));
            first = scene.sheet().position;
        }
    }
}
