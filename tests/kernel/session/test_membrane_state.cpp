// SPDX-License-Identifier: GPL-3.0-or-later
// A torn sheet survives being written and read, and broken ones are refused.
#include <doctest/doctest.h>

#include "mesh/shapes.hpp"
#include "scenes/membranes.hpp"
#include "session/codec.hpp"
#include "session/state_hash.hpp"
#include "topology/tear.hpp"

using namespace rhexis;

namespace {

Snapshot torn_sheet() {
    const MembraneModel model =
        scenes::membrane("sheet", square_sheet(4.0, 200), Orthotropic{1e6, 3e5, 0.3, 0.0}, Vec3(1.0, 1.0, 0.0));
    WorldModel world;
    world.membranes.push_back(model);
    Snapshot snapshot;
    snapshot.world = rest_state(world);
    MembraneState& sheet = snapshot.world.membranes[0];
    for (std::size_t t = 0; t < sheet.sheet->mesh.triangles.size(); ++t) {
        const Result<MembraneEdit> edit = puncture(
            model, sheet, static_cast<int>(t),
            sheet.sheet->mesh.nodes[static_cast<std::size_t>(sheet.sheet->mesh.triangles[t][0])], Vec3(1.0, 0.3, 0.0));
        if (edit.ok() && edit.value().tips.size() == 2) {
            sheet = applied(sheet, edit.value());
            break;
        }
    }
    sheet.loads.push_back({{0, 1, 2}, Vec3(1.0, 2.0, 3.0)});
    sheet.grips.push_back({0, 5, Vec3(0.1, 0.2, 0.3)});
    sheet.support = {0.25, 1000.0};
    return snapshot;
}

std::uint64_t hash_of(const Snapshot& snapshot) {
    return hash_state(snapshot.world, snapshot.tools, snapshot.settings, snapshot.observer_memory, snapshot.step, 1);
}

}  // namespace

TEST_SUITE("membrane state") {
    TEST_CASE("written and read it is the same, neighbours included") {
        const Snapshot snapshot = torn_sheet();
        REQUIRE(snapshot.world.membranes[0].tips.size() == 2);
        const std::optional<Snapshot> back = decode_snapshot(encode(snapshot));
        REQUIRE(back);
        CHECK(hash_of(*back) == hash_of(snapshot));
        CHECK(back->world.membranes[0].sheet->neighbours.across ==
              snapshot.world.membranes[0].sheet->neighbours.across);
    }

    TEST_CASE("a sheet of which a part was taken out, whose nodes belong to no triangle any more, is read too") {
        Snapshot snapshot = torn_sheet();
        MembraneState& state = snapshot.world.membranes[0];
        MembraneEdit edit;
        const TriNeighbours& near = state.sheet->neighbours;
        for (std::size_t n = 0; n + 1 < near.offset.size() && edit.out.empty(); ++n) {
            if (near.offset[n + 1] <= near.offset[n] + 2) {  // a corner of the sheet: what is left is sound
                edit.out.assign(near.triangles.begin() + near.offset[n], near.triangles.begin() + near.offset[n + 1]);
            }
        }
        state = applied(state, edit);
        REQUIRE_FALSE(validate_tri_mesh(state.sheet->mesh).ok());
        const std::optional<Snapshot> back = decode_snapshot(encode(snapshot));
        REQUIRE(back);
        CHECK(hash_of(*back) == hash_of(snapshot));
    }

    TEST_CASE("every part of it counts in the state hash") {
        const Snapshot whole = torn_sheet();
        Snapshot other = torn_sheet();
        CHECK(hash_of(other) == hash_of(whole));
        other.world.membranes[0].tips[0].owed.x() += 1e-9;
        CHECK(hash_of(other) != hash_of(whole));
        other = torn_sheet();
        other.world.membranes[0].torn_area += 1e-9;
        CHECK(hash_of(other) != hash_of(whole));
        other = torn_sheet();
        other.world.membranes[0].grips[0].place.z() += 1e-9;
        CHECK(hash_of(other) != hash_of(whole));
        other = torn_sheet();
        other.world.membranes[0].support.lift += 1e-9;
        CHECK(hash_of(other) != hash_of(whole));
        other = torn_sheet();
        std::shared_ptr<MembraneSheet> sheet = std::make_shared<MembraneSheet>(*other.world.membranes[0].sheet);
        sheet->fibre[3].x() += 1e-9;
        other.world.membranes[0].sheet = sheet;
        CHECK(hash_of(other) != hash_of(whole));
    }

    TEST_CASE("a sheet that is not sound is not read") {
        Snapshot snapshot = torn_sheet();
        std::shared_ptr<MembraneSheet> sheet = std::make_shared<MembraneSheet>(*snapshot.world.membranes[0].sheet);
        std::swap(sheet->mesh.triangles[5][0], sheet->mesh.triangles[5][1]);
        snapshot.world.membranes[0].sheet = sheet;
        CHECK_FALSE(decode_snapshot(encode(snapshot)));
        const std::string bytes = encode(torn_sheet());
        for (std::size_t cut = 0; cut + 1 < bytes.size(); cut += 997) {
            CHECK_FALSE(decode_snapshot(std::string_view(bytes).substr(0, cut)));
        }
    }
}
