// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that give way: all of a body's at random, and those along a crack that runs.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/places.hpp"
#include "mesh/shapes.hpp"
#include "physics/physics.hpp"
#include "physics/solid/crack.hpp"
#include "physics/solid/explicit_solid.hpp"
#include "scenes/bodies.hpp"
#include "scenes/piece_trials.hpp"
#include "topology/come_apart.hpp"
#include "topology/remove.hpp"

namespace rhexis::scenes {
namespace {

/// One body that comes apart while it is stepped, as a session does it.
class BreakingBody {
public:
    explicit BreakingBody(SolidModel body) : base_(std::move(body)) {
        settings_.elastic_energy = true;
        state.solids.push_back(rest_state(base_));
        follow();
        state = rest_state(*world);
    }

    void step(double dt) {
        WorldState next;
        ContactSet contacts;
        Profile profile;
        outcome = physics_->advance(state, {}, dt, next, contacts, profile);
        state = std::move(next);
        failures += outcome.failure == StepFailure::none ? 0 : 1;
    }

    void split(const std::vector<BrokenFace>& faces) {
        SolidState& body = state.solids[0];
        const MeshEdit edit = come_apart(world->solids[0], body, 0, faces);
        const int nodes = static_cast<int>(world->solids[0].coarse.nodes.size());
        apply_splits(edit, body);
        std::erase_if(state.memory, [&](const ContactMemory& memory) { return memory.vertex >= nodes; });
        follow();
    }

    [[nodiscard]] const SolidModel& model() const { return world->solids[0]; }
    [[nodiscard]] const SolidState& body() const { return state.solids[0]; }
    /// Elastic and kinetic, after a step [nJ].
    [[nodiscard]] double energy() const { return outcome.solids[0].kinetic_energy + outcome.solids[0].elastic_energy; }

    std::shared_ptr<WorldModel> world;
    WorldState state;
    StepOutcome outcome;
    int failures = 0;

private:
    void follow() {
        world = std::make_shared<WorldModel>();
        world->gravity.setZero();
        world->solids.push_back(split_model(base_, state.solids[0].splits));
        Physics made = std::move(Physics::create(world, settings_, physics_ ? &*physics_ : nullptr)).value();
        physics_.emplace(std::move(made));
    }

    SolidModel base_;
    PhysicsSettings settings_;
    std::optional<Physics> physics_;
};

std::vector<BrokenFace> inner_faces(const TetMesh& mesh) {
    std::vector<BrokenFace> faces;
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(mesh.tets);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
        for (const int other : neighbours[at(t)]) {
            if (other > t) {
                faces.push_back({t, other});
            }
        }
    }
    return faces;
}

std::vector<BrokenFace> take_some(std::vector<BrokenFace>& faces, int count, Rng& rng) {
    std::vector<BrokenFace> taken;
    for (int i = 0; i < count && !faces.empty(); ++i) {
        const auto pick = static_cast<std::ptrdiff_t>(rng.integer(0, std::ssize(faces) - 1));
        taken.push_back(faces[static_cast<std::size_t>(pick)]);
        faces.erase(faces.begin() + pick);
    }
    std::sort(taken.begin(), taken.end());
    return taken;
}

double fastest_of(const SolidState& body) {
    double most = 0.0;
    for (const Vec3& velocity : body.velocity) {
        most = std::max(most, velocity.norm());
    }
    return most;
}

int pieces_in(const SolidModel& model, const SolidState& body) {
    const std::vector<int> names = pieces_of(model, body);
    return static_cast<int>(std::set<int>(names.begin(), names.end()).size());
}

double stable_step_of(const SolidModel& model, const SolidState& body) {
    ExplicitSolid solid = ExplicitSolid::create(model, "").value();
    solid.load(body);
    return solid.stable_step();
}

constexpr double strip_length = 8.0;     // along x [mm]
constexpr double strip_height = 2.0;     // between its clamps, along z [mm]
constexpr double strip_thickness = 0.5;  // [mm]
constexpr double strip_stretch = 0.1;    // of the height

bool above(const TetMesh& mesh, int t) { return centroid(mesh.nodes, mesh.tets[at(t)]).z() > 0.5 * strip_height; }

/// Held by its long edges.
SolidModel tough_strip(double cell, double toughness) {
    const auto cells = [cell](double size) { return std::max(1, static_cast<int>(std::lround(size / cell))); };
    SolidModel strip =
        body("strip", bar(cells(strip_length), cells(strip_thickness), cells(strip_height), cell), 5000.0, 0.3);
    strip.materials[0].toughness = toughness;
    strip.damping_mass = 400.0;
    strip.advance = Advance::explicit_;
    for (int n = 0; n < static_cast<int>(strip.coarse.nodes.size()); ++n) {
        const double z = strip.coarse.nodes[at(n)].z();
        if (z < 1e-9 || z > strip_height - 1e-9) {
            strip.fixed_nodes.push_back(n);
        }
    }
    return strip;
}

/// Half way along the middle.
std::vector<BrokenFace> first_crack(const TetMesh& mesh) {
    std::vector<BrokenFace> faces = inner_faces(mesh);
    std::erase_if(faces, [&](const BrokenFace& face) {
        const auto left = [&](int t) { return centroid(mesh.nodes, mesh.tets[at(t)]).x() < 0.5 * strip_length; };
        return above(mesh, face[0]) == above(mesh, face[1]) || !left(face[0]) || !left(face[1]);
    });
    std::sort(faces.begin(), faces.end());
    return faces;
}

/// Of the middle of a face from the plane half way up.
double off_middle(const TetMesh& mesh, const BrokenFace& face) {
    double sum = 0.0;
    for (const int node : mesh.tets[at(face[0])]) {
        const std::array<int, 4>& other = mesh.tets[at(face[1])];
        sum += std::find(other.begin(), other.end(), node) != other.end() ? mesh.nodes[at(node)].z() / 3.0 : 0.0;
    }
    return std::abs(sum - 0.5 * strip_height);
}

/// Faces that give way now, as while a tool pushes at a corner.
std::vector<BrokenFace> giving_way(const SolidModel& model, const SolidState& body) {
    Contact push;
    push.force = Vec3(0.0, 0.0, 1e4);
    ContactSurface surface(model);
    surface.update(model, body);
    CrackFinder finder(model);
    std::vector<BrokenFace> broken;
    finder.find(model, body, surface, {push}, 0, broken);
    return broken;
}

}  // namespace

Breaking break_all(int cells, int at_once) {
    SolidModel model = cube(cells, 2.0, 3000.0, 0.45);
    model.advance = Advance::explicit_;
    model.damping_mass = 20.0;
    model.damping_stiffness = 1e-4;
    BreakingBody broken(model);
    Breaking found;
    const double whole = stable_step_of(broken.model(), broken.body());
    const double mass = remaining_mass(broken.model(), broken.body());
    std::vector<BrokenFace> faces = inner_faces(model.coarse);
    Rng rng(3, "breaks");
    found.step = 1.0;
    for (int after = 0; after < 50 && found.fault.empty(); after += faces.empty() ? 1 : 0) {
        if (!faces.empty()) {
            broken.split(take_some(faces, at_once, rng));
            const Status sound = validate(broken.model(), broken.body());
            found.fault = sound.ok() ? "" : sound.error().text();
            found.step = std::min(found.step, stable_step_of(broken.model(), broken.body()) / whole);
        }
        broken.step(0.01);
        found.kinetic = std::max(found.kinetic, broken.outcome.solids[0].kinetic_energy);
        found.fastest = std::max(found.fastest, fastest_of(broken.body()));
    }
    found.pieces = pieces_in(broken.model(), broken.body());
    found.mass_off = std::abs(remaining_mass(broken.model(), broken.body()) / mass - 1.0);
    found.failures = broken.failures;
    return found;
}

Running run_crack(double cell) {
    constexpr double toughness = 40.0;  // less than what the strip frees [uN/mm]
    constexpr int quiet = 20;           // steps in which nothing breaks: it has come to an end
    const SolidModel model = tough_strip(cell, toughness);
    BreakingBody strip(model);
    strip.split(first_crack(model.coarse));
    for (Vec3& place : strip.state.solids[0].position) {
        place.z() = 0.5 * strip_height + (1.0 + strip_stretch) * (place.z() - 0.5 * strip_height);
    }
    Running found;
    double reached = 0.0;
    double start = 0.0;
    double before = HUGE_VAL;
    for (int still = 0; still < quiet;) {
        strip.step(0.005);
        start = start > 0.0 ? start : strip.energy();
        found.rise = std::max(found.rise, (strip.energy() - std::min(before, start)) / start);
        before = strip.energy();
        const std::vector<BrokenFace> broken = giving_way(strip.model(), strip.body());
        for (const BrokenFace& face : broken) {
            found.aside = std::max(found.aside, off_middle(model.coarse, face) / cell);
            reached = std::max(reached, centroid(model.coarse.nodes, model.coarse.tets[at(face[0])]).x());
        }
        found.most_at_once = std::max(found.most_at_once, static_cast<int>(broken.size()));
        still = broken.empty() ? still + 1 : 0;
        if (!broken.empty()) {
            strip.split(broken);
        }
    }
    found.left = (strip_length - reached) / cell;
    found.failures = strip.failures;
    return found;
}

}  // namespace rhexis::scenes
