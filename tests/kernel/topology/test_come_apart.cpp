// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "base/rng.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/shapes.hpp"
#include "topology/come_apart.hpp"
#include "topology/crumble.hpp"
#include "topology/remove.hpp"

using namespace rhexis;

namespace {

SolidModel two_level(const TetMesh& mesh) {
    SolidModel model;
    model.name = "body";
    model.coarse = mesh;
    model.fine = subdivide(mesh);
    model.materials = {Material{"tissue"}};
    return model;
}

double middle_x(const SolidModel& model, int tet) {
    double sum = 0.0;
    for (const int node : model.coarse.tets[tet]) {
        sum += 0.25 * model.coarse.nodes[node].x();
    }
    return sum;
}

std::size_t count_pieces(const std::vector<int>& pieces) {
    std::vector<int> names = pieces;
    std::erase(names, -1);
    std::sort(names.begin(), names.end());
    return static_cast<std::size_t>(std::unique(names.begin(), names.end()) - names.begin());
}

/// Faces between tetrahedra on either side of a plane across x.
std::vector<BrokenFace> faces_at(const SolidModel& model, double x) {
    std::vector<BrokenFace> faces;
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(model.coarse.tets);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
        for (const int other : neighbours[t]) {
            if (other > t && (middle_x(model, t) < x) != (middle_x(model, other) < x)) {
                faces.push_back({t, other});
            }
        }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

/// The base and a state that followed all its edits.
struct Body {
    SolidModel base;
    SolidModel model;
    SolidState state;

    explicit Body(const TetMesh& mesh) : base(two_level(mesh)), model(base), state(rest_state(base)) {}

    MeshEdit split(const std::vector<BrokenFace>& broken) {
        MeshEdit edit = come_apart(model, state, 0, broken);
        apply_splits(edit, state);
        model = split_model(base, state.splits);
        return edit;
    }
};

}  // namespace

TEST_SUITE("topology") {
    TEST_CASE("a bar broken across comes apart into two pieces that share no node and lose no volume") {
        Body bar_body(bar(6, 2, 2, 0.5));
        const double volume = mesh_volume(bar_body.model.coarse);
        CHECK(count_pieces(pieces_of(bar_body.model, bar_body.state)) == 1);
        const MeshEdit edit = bar_body.split(faces_at(bar_body.model, 1.5));
        CHECK(edit.splits.size() == 9);  // the nodes of one cross-section
        CHECK(count_pieces(pieces_of(bar_body.model, bar_body.state)) == 2);
        CHECK(mesh_volume(bar_body.model.coarse) == volume);
        CHECK(validate(bar_body.model, bar_body.state).ok());
        const std::vector<int> pieces = pieces_of(bar_body.model, bar_body.state);
        std::vector<int> owner(bar_body.model.coarse.nodes.size(), -1);
        for (std::size_t t = 0; t < pieces.size(); ++t) {
            for (const int node : bar_body.model.coarse.tets[t]) {
                CHECK((owner[node] == -1 || owner[node] == pieces[t]));
                owner[node] = pieces[t];
            }
        }
        // nothing more to do
        CHECK(come_apart(bar_body.model, bar_body.state, 0, {}).empty());
        CHECK(splits_fit(bar_body.base, bar_body.state.splits));
    }

    TEST_CASE("fine tetrahedra keep their places when nodes split") {
        Body body(bar(6, 2, 2, 0.5));
        body.split(faces_at(body.model, 1.5));
        std::vector<Vec3> before;
        std::vector<Vec3> after;
        fine_positions(body.base.fine, body.base.coarse.nodes, before);
        fine_positions(body.model.fine, body.model.coarse.nodes, after);
        REQUIRE(body.base.fine.tets.size() == body.model.fine.tets.size());
        for (std::size_t f = 0; f < body.base.fine.tets.size(); ++f) {
            for (std::size_t k = 0; k < 4; ++k) {
                CHECK(before[body.base.fine.tets[f][k]] == after[body.model.fine.tets[f][k]]);
            }
        }
        std::size_t open_before = 0;
        std::size_t open_after = 0;
        for (std::size_t f = 0; f < body.base.fine.tets.size(); ++f) {
            for (std::size_t k = 0; k < 4; ++k) {
                open_before += body.base.fine.neighbours[f][k] < 0 ? 1 : 0;
                open_after += body.model.fine.neighbours[f][k] < 0 ? 1 : 0;
            }
        }
        CHECK(open_after == open_before + 2 * 4 * 8);  // both sides of 4 x 2 triangles, each cut in 4
    }

    TEST_CASE("a crack that ends inside leaves its tip together") {
        Body body(bar(6, 4, 2, 0.5));
        std::vector<BrokenFace> half = faces_at(body.model, 1.5);
        std::erase_if(half, [&](const BrokenFace& face) {
            double y = 0.0;
            for (const int node : body.model.coarse.tets[face[0]]) {
                y += 0.25 * body.model.coarse.nodes[node].y();
            }
            return y > 1.0;
        });
        const MeshEdit edit = body.split(half);
        CHECK(edit.splits.size() == 2 * 3);  // two rows of nodes open, the third is the tip
        CHECK(count_pieces(pieces_of(body.model, body.state)) == 1);
    }

    TEST_CASE("what is sculpted through comes apart without a broken face") {
        Body body(bar(6, 2, 2, 0.5));
        for (std::size_t f = 0; f < body.model.fine.tets.size(); ++f) {
            const double x = middle_x(body.model, static_cast<int>(f) / 8);
            body.state.fraction[f] = x > 1.0 && x < 1.5 ? 0.0 : 1.0;
        }
        apply(spent_elements(body.model, body.state, 0), body.model, body.state);
        CHECK(count_pieces(pieces_of(body.model, body.state)) == 2);
        CHECK(body.split({}).empty());  // they shared no node any more
        CHECK(validate(body.model, body.state).ok());
    }

    TEST_CASE("pieces that only a hinge of nodes joins are split there") {
        Body body(bar(3, 1, 1, 1.0));
        // Of the middle cell only the child tetrahedra around one corner of a face stay: cut all, then look
        for (std::size_t f = 0; f < body.model.fine.tets.size(); ++f) {
            const double x = middle_x(body.model, static_cast<int>(f) / 8);
            const bool corner = f % 8 == 0;
            body.state.fraction[f] = x > 1.0 && x < 2.0 && !corner ? 0.0 : 1.0;
        }
        apply(spent_elements(body.model, body.state, 0), body.model, body.state);
        const std::size_t pieces = count_pieces(pieces_of(body.model, body.state));
        REQUIRE(pieces > 2);
        body.split({});
        const NodeTets around = node_tets(body.model.coarse.tets, static_cast<int>(body.model.coarse.nodes.size()));
        const std::vector<int> names = pieces_of(body.model, body.state);
        CHECK(count_pieces(names) == pieces);
        for (std::size_t n = 0; n + 1 < around.offset.size(); ++n) {
            int found = -1;
            for (int i = around.offset[n]; i < around.offset[n + 1]; ++i) {
                const int name = names[around.tets[i]];
                CHECK((name < 0 || found < 0 || name == found));
                found = name < 0 ? found : name;
            }
        }
        CHECK(validate(body.model, body.state).ok());
    }

    TEST_CASE("random breaks one after the other always leave a sound mesh") {
        Body body(bar(4, 3, 3, 0.5));
        std::vector<BrokenFace> all;
        const std::vector<std::array<int, 4>> neighbours = face_neighbours(body.base.coarse.tets);
        for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
            for (const int other : neighbours[t]) {
                if (other > t) {
                    all.push_back({t, other});
                }
            }
        }
        Rng rng(5);
        const double volume = mesh_volume(body.base.coarse);
        while (!all.empty()) {
            std::vector<BrokenFace> some;
            for (int i = 0; i < 20 && !all.empty(); ++i) {
                const auto pick = static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(all.size()) - 1));
                some.push_back(all[pick]);
                all.erase(all.begin() + static_cast<std::ptrdiff_t>(pick));
            }
            std::sort(some.begin(), some.end());
            body.split(some);
            REQUIRE(validate(body.model, body.state).ok());
            REQUIRE(mesh_volume(body.model.coarse) == volume);
        }
        // every tetrahedron by itself
        CHECK(body.model.coarse.nodes.size() == 4 * body.model.coarse.tets.size());
        CHECK(count_pieces(pieces_of(body.model, body.state)) == body.model.coarse.tets.size());
    }

    TEST_CASE("crumbs leave the mesh with their mass, place and speed") {
        Body body(bar(3, 1, 1, 1.0));
        for (std::size_t f = 0; f < body.model.fine.tets.size(); ++f) {
            const double x = middle_x(body.model, static_cast<int>(f) / 8);
            body.state.fraction[f] = x > 1.0 && x < 2.0 ? (f % 8 == 0 ? 0.5 : 0.0) : 1.0;
        }
        for (Vec3& velocity : body.state.velocity) {
            velocity = Vec3(1.0, 2.0, 3.0);
        }
        apply(spent_elements(body.model, body.state, 0), body.model, body.state);
        const double before = remaining_mass(body.model, body.state);
        const Crumbs crumbs = crumble(body.model, body.state, 0, pieces_of(body.model, body.state), 0.2);
        REQUIRE(!crumbs.debris.empty());
        apply(crumbs.edit, body.model, body.state);
        double mass = 0.0;
        for (const Debris& crumb : crumbs.debris) {
            mass += crumb.volume * crumb.density;
            CHECK(crumb.position.x() > 1.0);
            CHECK(crumb.position.x() < 2.0);
            CHECK((crumb.velocity - Vec3(1.0, 2.0, 3.0)).norm() < 1e-12);
        }
        CHECK(before == doctest::Approx(mass + remaining_mass(body.model, body.state)).epsilon(1e-12));
        CHECK(validate(body.model, body.state).ok());
        CHECK(crumble(body.model, body.state, 0, pieces_of(body.model, body.state), 0.2).debris.empty());
    }

    TEST_CASE("splits that do not belong to a mesh are refused") {
        const SolidModel model = two_level(bar(2, 1, 1, 1.0));
        const int node = model.coarse.tets[0][0];
        CHECK(splits_fit(model, {{node, {0}}}));
        CHECK_FALSE(splits_fit(model, {{-1, {0}}}));
        CHECK_FALSE(splits_fit(model, {{static_cast<int>(model.coarse.nodes.size()), {0}}}));
        CHECK_FALSE(splits_fit(model, {{node, {-1}}}));
        CHECK_FALSE(splits_fit(model, {{node, {0, 0}}}));
        CHECK_FALSE(splits_fit(model, {{node, {static_cast<int>(model.coarse.tets.size())}}}));
    }
}
