// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "mesh/shapes.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "scenes/membranes.hpp"
#include "scenes/split_run.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

namespace {

using elastic_kernel::Mode;

/// Some 60 triangles, which do not fill the last group, stretched and crumpled so that all states of a sheet occur.
struct Crumpled {
    explicit Crumpled(const Orthotropic& material)
        : model(membrane("crumpled", square_sheet(2.0, 60), material, Vec3(0.8, 0.6, 0.0))) {
        model.fixed_nodes = {0, 1};
        Rng random(5);
        for (const Vec3& node : model.sheet->mesh.nodes) {
            const Vec3 shift = normal3(random);
            position.push_back(Vec3(1.1 * node.x(), node.y(), 0.2 * node.x()) + 0.05 * shift);
        }
    }

    [[nodiscard]] std::vector<double> rows(const MembraneBody& body) const {
        std::vector<double> x;
        for (const int node : body.node_of()) {
            x.insert(x.end(), position[at(node)].begin(), position[at(node)].end());
        }
        x.push_back(0.0);
        return x;
    }

    MembraneModel model;
    std::vector<Vec3> position;
};

struct Assembled {
    std::vector<double> force;
    BlockValues stiffness;
};

Assembled assembled(const Crumpled& sheet, Mode mode, const char* instruction_set) {
    MembraneBody body(sheet.model, sheet.model.sheet, *membrane_kernel::choose(instruction_set));
    Assembled result{{}, zero_values(body.pattern())};
    body.forces_and_stiffness(sheet.rows(body), mode, 0.7, result.force, result.stiffness);
    return result;
}

/// One triangle after the other, by energy/membrane_triangle.hpp.
Assembled one_by_one(const Crumpled& sheet, Mode mode, std::array<int, 3>& states) {
    const MembraneBody body(sheet.model, sheet.model.sheet);
    const MembraneTangent kind = mode == Mode::consistent ? MembraneTangent::consistent : MembraneTangent::definite;
    Assembled result{std::vector<double>(3 * sheet.position.size() + 1, 0.0), zero_values(body.pattern())};
    const std::vector<MembraneTriangle> triangles = membrane_triangles(sheet.model, *sheet.model.sheet);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const std::array<int, 3>& n = sheet.model.sheet->mesh.triangles[t];
        const TrianglePoints x{sheet.position[at(n[0])], sheet.position[at(n[1])], sheet.position[at(n[2])]};
        ++states[static_cast<std::size_t>(membrane_state(triangles[t], x).state)];
        TrianglePoints force;
        TriangleBlocks blocks;
        membrane_stiffness(triangles[t], x, kind, force, blocks);
        std::size_t pair = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            const int row = body.row_of()[at(n[a])];
            Eigen::Map<Vec3>(result.force.data() + 3 * at(row)) += force[a];
            for (std::size_t b = a; b < 3; ++b, ++pair) {
                const int other = body.row_of()[at(n[b])];
                if (body.moves()[at(row)] != 0 && body.moves()[at(other)] != 0) {
                    const Mat3 block = 0.7 * blocks[pair];
                    add_block(result.stiffness, body.pattern().slot(std::min(row, other), std::max(row, other)),
                              row <= other ? block : Mat3(block.transpose()));
                }
            }
        }
    }
    return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t count) {
    double most = 0.0;
    double scale = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        most = std::max(most, std::abs(a[i] - b[i]));
        scale = std::max(scale, std::abs(b[i]));
    }
    return most / scale;
}

const std::array<Orthotropic, 2> materials{Orthotropic{1.0e6, 2.5e5, 0.45, 0.0}, isotropic(1.0e6, 0.45)};

/// What a body is, whatever its rows.
struct ByNodes {
    struct Entry {
        int node;
        int other;
        Mat3 block;
    };
    std::vector<double> force, mass;
    std::vector<std::uint8_t> moves;
    std::vector<Entry> entries;  ///< ascending
};

ByNodes by_nodes(MembraneBody& body, const MembraneState& state) {
    std::vector<double> x;
    for (const int node : body.node_of()) {
        x.insert(x.end(), state.position[at(node)].begin(), state.position[at(node)].end());
    }
    x.push_back(0.0);
    std::vector<double> force;
    BlockValues stiffness = zero_values(body.pattern());
    body.forces_and_stiffness(x, Mode::projected, 0.7, force, stiffness);
    mirror_upper(body.pattern(), stiffness);
    ByNodes result;
    for (const int row : body.row_of()) {
        result.force.insert(result.force.end(), force.begin() + 3 * row, force.begin() + 3 * row + 3);
        result.mass.push_back(body.mass().inertia[at(row)]);
        result.moves.push_back(body.moves()[at(row)]);
        for (int slot = body.pattern().first[at(row)]; slot < body.pattern().first[at(row) + 1]; ++slot) {
            result.entries.push_back({body.node_of()[at(row)], body.node_of()[at(body.pattern().column[at(slot)])],
                                      block_of(stiffness, slot)});
        }
    }
    std::sort(result.entries.begin(), result.entries.end(), [](const ByNodes::Entry& a, const ByNodes::Entry& b) {
        return std::pair(a.node, a.other) < std::pair(b.node, b.other);
    });
    return result;
}

}  // namespace

TEST_SUITE("membrane kernel") {
    TEST_CASE("forces and stiffness are those of the triangles one by one, taut, wrinkled and slack") {
        for (const Orthotropic& material : materials) {
            const Crumpled sheet(material);
            for (const Mode mode : {Mode::consistent, Mode::projected}) {
                std::array<int, 3> states{};
                const Assembled expected = one_by_one(sheet, mode, states);
                CHECK(*std::min_element(states.begin(), states.end()) > 0);
                const Assembled found = assembled(sheet, mode, "");
                // the direction of wrinkles is known to 1e-12
                CHECK(largest_difference(found.force, expected.force, expected.force.size()) < 1e-9);
                // without the block to be dropped
                CHECK(largest_difference(found.stiffness, expected.stiffness, expected.stiffness.size() - 10) < 1e-9);
            }
        }
    }

    TEST_CASE("every instruction set gives the same forces and stiffness to the last bit") {
        for (const Orthotropic& material : materials) {
            const Crumpled sheet(material);
            for (const Mode mode : {Mode::consistent, Mode::projected}) {
                const Assembled first = assembled(sheet, mode, "baseline");
                for (const char* name : {"avx2", "avx512"}) {
                    if (membrane_kernel::choose(name) != nullptr) {
                        const Assembled other = assembled(sheet, mode, name);
                        CHECK(other.force == first.force);
                        CHECK(other.stiffness == first.stiffness);
                    }
                }
            }
        }
    }

    TEST_CASE("a sheet that tears on is followed to what it is when made anew") {
        SplitRun run(400);
        const MembraneModel& model = run.model();
        MembraneBody followed(model, model.sheet);
        int kept = 0;
        for (int i = 0; i < 60; ++i) {
            run.split();
            const MembraneSheet& sheet = *run.state().sheet;
            const TriNeighbours neighbours = tri_neighbours(sheet.mesh);
            CHECK(sheet.neighbours.across == neighbours.across);
            CHECK(sheet.neighbours.offset == neighbours.offset);
            CHECK(sheet.neighbours.triangles == neighbours.triangles);
            kept += followed.follow(run.state().sheet, true).empty() ? 0 : 1;
            MembraneBody anew(model, run.state().sheet);
            const ByNodes found = by_nodes(followed, run.state());
            const ByNodes expected = by_nodes(anew, run.state());
            double largest_block = 0.0;
            for (const ByNodes::Entry& entry : expected.entries) {
                largest_block = std::max(largest_block, entry.block.norm());
            }
            // but for rounding: the corners of a triangle are taken by ascending rows
            REQUIRE(found.force.size() == expected.force.size());
            CHECK(largest_difference(found.force, expected.force, expected.force.size()) < 1e-12);
            CHECK(found.mass == expected.mass);
            CHECK(found.moves == expected.moves);
            REQUIRE(found.entries.size() == expected.entries.size());
            double off = 0.0;
            for (std::size_t k = 0; k < found.entries.size(); ++k) {
                CHECK(found.entries[k].node == expected.entries[k].node);
                CHECK(found.entries[k].other == expected.entries[k].other);
                off = std::max(off, (found.entries[k].block - expected.entries[k].block).norm());
            }
            CHECK(off < 1e-12 * largest_block);
        }
        CHECK(kept > 45);  // the others are new orders
    }
}
