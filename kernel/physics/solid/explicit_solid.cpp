// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/explicit_solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "base/index.hpp"
#include "energy/nodal_pressure.hpp"
#include "math/aligned.hpp"
#include "physics/solid/explicit_groups.hpp"
#include "physics/solid/explicit_kernel.hpp"
#include "physics/solid/node_stiffness.hpp"
#include "physics/solid/solid_share.hpp"
#include "physics/solid/stable_step.hpp"

namespace rhexis {
namespace {

using explicit_kernel::Group;
using explicit_kernel::Kernel;
using explicit_kernel::lanes;
using explicit_kernel::Nodes;

/// A node keeps at least this share of the mean (or all of its own mass at rest, if that is less) while it has any
/// element: the limit of an isolated fragment would otherwise be a third of the body's.
constexpr double mass_floor = 0.3;

/// Nodes that lanes without an element point at, as an undeformed tetrahedron.
constexpr int spare_nodes = 4;

constexpr std::array<double, 6> spare_gradient{1.0, 0.0, 1.0, 0.0, 0.0, 1.0};

/// Inverse of the rest edges in a frame with the first edge on x and the second in the x-y plane: upper triangle by
/// columns.
struct RestShape {
    std::array<double, 6> gradient{};
    double volume = 0.0;
};

/// Shares told apart by the stable step: between two of them it moves by less than its safety factor.
double level_of(double share) {
    if (!(share > 0.0)) {
        return 0.0;
    }
    return share > 0.7 ? 1.0 : share > 0.3 ? 0.5 : 0.15;
}

/// Zero volume if the tetrahedron is flat or inverted.
RestShape rest_shape(const TetMesh& mesh, const std::array<int, 4>& tet) {
    const Vec3& origin = mesh.nodes[at(tet[0])];
    const Vec3 e1 = mesh.nodes[at(tet[1])] - origin;
    const Vec3 e2 = mesh.nodes[at(tet[2])] - origin;
    const Vec3 e3 = mesh.nodes[at(tet[3])] - origin;
    RestShape shape;
    shape.volume = e1.cross(e2).dot(e3) / 6.0;
    if (!(shape.volume > 0.0)) {
        return RestShape{};
    }
    const Vec3 x = e1.normalized();
    const Vec3 z = e1.cross(e2).normalized();
    const Vec3 y = z.cross(x);
    const double a = e1.dot(x);
    const double b = e2.dot(x);
    const double c = e2.dot(y);
    const double d = e3.dot(x);
    const double e = e3.dot(y);
    const double f = e3.dot(z);
    shape.gradient = {1.0 / a, -b / (a * c), 1.0 / c, (b * e - c * d) / (a * c * f), -e / (c * f), 1.0 / f};
    return shape;
}

struct Named {
    const char* name;
    bool available;
    const Kernel* (*kernel)();
};

constexpr double near = 100.0;  ///< of the world's origin: single precision may count from there [mm]

/// Where single precision counts from. Elements feel differences of places only; far away those would be rounding.
Vec3 origin_for(const Vec3& node) { return node.cwiseAbs().maxCoeff() > near ? node : Vec3::Zero(); }

std::vector<Named> instruction_sets() {
    const bool avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                        __builtin_cpu_supports("avx512vl") != 0;
    return {{"avx512", avx512, explicit_kernel::avx512},
            {"avx2", __builtin_cpu_supports("avx2") != 0, explicit_kernel::avx2},
            {"baseline", true, explicit_kernel::baseline}};
}

Result<const Kernel*> choose_kernel(std::string_view name) {
    for (const Named& set : instruction_sets()) {
        if (name.empty() ? set.available : name == set.name) {
            if (!set.available) {
                return Error{"this machine has no " + std::string(name), "instruction_set", "\"\" for the best it has"};
            }
            return set.kernel();
        }
    }
    return Error{"unknown instruction set \"" + std::string(name) + "\"", "instruction_set",
                 "\"\", \"baseline\", \"avx2\" or \"avx512\""};
}

/// What the kernel needs of the nodes.
struct ByNode {
    AlignedVector<double> inverse_mass, weight_share;
    AlignedVector<float> pressure;  ///< k / V of its patch; empty unless pressure is at nodes
    std::vector<double> mass;
};

}  // namespace

struct ExplicitSolid::Parts {
    const SolidModel* model = nullptr;
    const Kernel* kernel = nullptr;
    std::vector<RestShape> rest;
    std::vector<int> slot;  ///< of each tetrahedron: group * lanes + lane
    std::vector<double> rest_inertia;
    std::optional<NodeStiffness> held;  ///< only if a stable step is sought
    AlignedVector<Group> groups;
    // state
    AlignedVector<double> position, velocity;
    AlignedVector<float> probe, force;
    Vec3 origin = Vec3::Zero();  ///< of `probe` [mm]
    AlignedVector<float> trace;  ///< scratch of nodal pressure
    // what follows from the elements that are left
    SolidState left;               ///< only what tells which elements are there
    std::vector<double> in_lanes;  ///< per tetrahedron: the share that its lane has
    ByNode by_node;
    bool elements_known = false;
    std::vector<TetStiffness> stiffness;
    std::vector<double> level;  ///< per tetrahedron: the share that the limit is computed for
    double limit = 0.0;         ///< [s]; 0: not known

    [[nodiscard]] int node_count() const { return static_cast<int>(model->coarse.nodes.size()); }
    Nodes nodes();
    void allocate();
    void fill_lane(int t, const TetStiffness& own);
    void fill_lanes(const std::vector<TetStiffness>& shares);
    void set_masses(const NodeMass& now, const std::vector<TetStiffness>& shares);
    void set_pressures(const std::vector<TetStiffness>& shares);
    void fill(const std::vector<TetStiffness>& shares);
    void set_elements(const SolidState& state);
    void add_forces(AlignedVector<float>& place, AlignedVector<float>& pull);
    double compute_limit();
    double limit_of_lanes();
};

Nodes ExplicitSolid::Parts::nodes() {
    return {node_count(),
            position.data(),
            velocity.data(),
            probe.data(),
            force.data(),
            by_node.inverse_mass.data(),
            by_node.weight_share.data(),
            {origin.x(), origin.y(), origin.z(), 0.0}};
}

void ExplicitSolid::Parts::allocate() {
    const std::size_t all = at(node_count() + spare_nodes);
    position.assign(4 * all, 0.0);
    velocity.assign(4 * all, 0.0);
    probe.assign(4 * all, 0.0F);
    force.assign(4 * all, 0.0F);
    by_node.inverse_mass.assign(all, 0.0);
    by_node.weight_share.assign(all, 0.0);
    by_node.mass.assign(all, 0.0);
    for (int k = 1; k < spare_nodes; ++k) {
        probe[at(4 * (node_count() + k) + k - 1)] = 1.0F;
    }
}

void ExplicitSolid::Parts::fill_lane(int t, const TetStiffness& own) {
    Group& group = groups[at(slot[at(t)] / lanes)];
    const std::size_t lane = at(slot[at(t)] % lanes);
    const bool gone = !(own.share > 0.0);
    const double volume = own.share * rest[at(t)].volume;
    group.twice_mu[lane] = gone ? 0.0F : static_cast<float>(-2.0 * volume * own.mu);
    const bool nodal = model->formulation == Formulation::nodal_pressure;
    const double lambda = nodal ? -2.0 / 3.0 * own.mu : own.lambda;
    group.lambda[lane] = gone ? 0.0F : static_cast<float>(-volume * lambda);
    group.quarter[lane] = gone ? 0.0F : static_cast<float>(0.25 * volume);
    for (int a = 0; a < 4; ++a) {
        const int node = gone ? node_count() + a : model->coarse.tets[at(t)][at(a)];
        group.offset[a][lane] = static_cast<std::uint32_t>(4 * node);
    }
    for (int k = 0; k < 6; ++k) {
        group.gradient[k][lane] = static_cast<float>(gone ? spare_gradient[at(k)] : rest[at(t)].gradient[at(k)]);
    }
}

void ExplicitSolid::Parts::set_masses(const NodeMass& now, const std::vector<TetStiffness>& shares) {
    double total = 0.0;
    for (const double m : rest_inertia) {
        total += m;
    }
    const double floor = mass_floor * total / node_count();
    for (int i = 0; i < node_count(); ++i) {
        const double inertia = now.inertia[at(i)];
        by_node.mass[at(i)] = inertia > 0.0 ? std::max(inertia, std::min(floor, rest_inertia[at(i)])) : 0.0;
    }
    if (held) {
        const std::vector<double>& traces = held->traces(shares);
        const double factor = 0.5 * model->sought_step * model->sought_step;
        for (int i = 0; i < node_count(); ++i) {
            by_node.mass[at(i)] =
                by_node.mass[at(i)] > 0.0 ? std::max(by_node.mass[at(i)], factor * traces[at(i)]) : 0.0;
        }
    }
    for (const int node : model->fixed_nodes) {
        by_node.mass[at(node)] = 0.0;
    }
    for (int i = 0; i < node_count(); ++i) {
        const double m = by_node.mass[at(i)];
        by_node.inverse_mass[at(i)] = m > 0.0 ? 1.0 / m : 0.0;
        by_node.weight_share[at(i)] = m > 0.0 ? now.weight[at(i)] / m : 0.0;
    }
}

void ExplicitSolid::Parts::set_pressures(const std::vector<TetStiffness>& shares) {
    std::vector<double> volume;
    for (const RestShape& shape : rest) {
        volume.push_back(shape.volume);
    }
    const NodePatches patches = node_patches(model->coarse, volume, shares);
    for (int i = 0; i < node_count(); ++i) {
        const double own = patches.volume[at(i)];
        by_node.pressure[at(i)] = own > 0.0 ? static_cast<float>(patches.bulk[at(i)] / own) : 0.0F;
    }
}

/// Those whose share changed since they were filled.
void ExplicitSolid::Parts::fill_lanes(const std::vector<TetStiffness>& shares) {
    in_lanes.resize(shares.size(), -1.0);
    for (std::size_t t = 0; t < shares.size(); ++t) {
        if (in_lanes[t] != shares[t].share) {
            in_lanes[t] = shares[t].share;
            fill_lane(static_cast<int>(t), shares[t]);
        }
    }
}

/// What the kernel needs of the elements.
void ExplicitSolid::Parts::fill(const std::vector<TetStiffness>& shares) {
    fill_lanes(shares);
    set_masses(node_mass(*model, left, shares), shares);
    if (model->formulation == Formulation::nodal_pressure) {
        set_pressures(shares);
    }
}

void ExplicitSolid::Parts::set_elements(const SolidState& state) {
    if (elements_known && left.present == state.present && left.fraction == state.fraction) {
        return;
    }
    left.present = state.present;
    left.fraction = state.fraction;
    stiffness = tet_stiffness(*model, left);
    fill(stiffness);
    elements_known = true;
    std::vector<double> now;
    for (const TetStiffness& tet : stiffness) {
        now.push_back(level_of(tet.share));
    }
    if (now != level) {
        level = std::move(now);
        limit = 0.0;
    }
}

/// Elastic forces at `place`, added to `pull`, whose fourth values are zero before and anything after.
void ExplicitSolid::Parts::add_forces(AlignedVector<float>& place, AlignedVector<float>& pull) {
    const int count = static_cast<int>(groups.size());
    if (model->formulation == Formulation::linear) {
        kernel->add_forces(groups.data(), count, place.data(), pull.data());
        return;
    }
    kernel->add_nodal_forces(
        {groups.data(), count, node_count(), by_node.pressure.data(), trace.data(), place.data(), pull.data()});
}

/// For the levels of the elements, not for their shares: it would have to be found anew in every step of sculpting, and
/// found rarely but from shares it would depend on when; a resumed run would then differ from one that ran through.
double ExplicitSolid::Parts::compute_limit() {
    std::vector<TetStiffness> leveled = stiffness;
    for (std::size_t t = 0; t < leveled.size(); ++t) {
        leveled[t].share = level[t];
    }
    ByNode kept = by_node;
    fill(leveled);
    const double found = limit_of_lanes();
    fill_lanes(stiffness);
    std::swap(by_node, kept);
    return found;
}

/// By the product K u at rest, where there is no force: the kernel's own at a small displacement.
double ExplicitSolid::Parts::limit_of_lanes() {
    const std::size_t all = at(4 * (node_count() + spare_nodes));
    AlignedVector<float> place = probe;
    AlignedVector<float> pull(all, 0.0F);
    constexpr float shift = 1e-3F;  // [mm]; strains of about 0.2 %: above rounding, below what bends the result
    std::vector<double> scale(at(node_count()));
    for (std::size_t i = 0; i < scale.size(); ++i) {
        scale[i] = std::sqrt(by_node.inverse_mass[i]);
    }
    const Vec3 from = origin_for(model->coarse.nodes.front());
    const auto product = [&](const VecX& x, VecX& y) {
        double largest = 1e-300;
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            largest = std::max(largest, std::abs(x[k]) * scale[static_cast<std::size_t>(k / 3)]);
        }
        const double amplitude = shift / largest;
        std::fill(pull.begin(), pull.end(), 0.0F);
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            const auto i = static_cast<std::size_t>(k / 3);
            const double u = amplitude * scale[i] * x[k];
            place[4 * i + static_cast<std::size_t>(k % 3)] =
                static_cast<float>(model->coarse.nodes[i][k % 3] - from[k % 3] + u);
        }
        add_forces(place, pull);
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            const auto i = static_cast<std::size_t>(k / 3);
            y[k] = -pull[4 * i + static_cast<std::size_t>(k % 3)] * scale[i] / amplitude;
        }
    };
    constexpr int steps = 12;  // within 0.5 % of what 80 find, on lenses that are being cut
    return symplectic_limit(largest_eigenvalue(product, 3 * node_count(), steps), model->damping_stiffness);
}

ExplicitSolid::ExplicitSolid(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ExplicitSolid::~ExplicitSolid() = default;
ExplicitSolid::ExplicitSolid(ExplicitSolid&&) noexcept = default;

LaneAssignment ExplicitSolid::assign(const TetMesh& mesh) {
    return assign_lanes(mesh.tets, static_cast<int>(mesh.nodes.size()), lanes);
}

Result<ExplicitSolid> ExplicitSolid::create(const SolidModel& model, std::string_view instruction_set,
                                            const LaneAssignment* assigned) {
    if (model.formulation == Formulation::edge_smoothed) {
        return Error{"edge-smoothed elements cannot be stepped explicitly", model.name,
                     "formulation linear or nodal pressure"};
    }
    const Result<const Kernel*> kernel = choose_kernel(instruction_set);
    if (!kernel.ok()) {
        return kernel.error();
    }
    auto parts = std::make_unique<Parts>();
    parts->model = &model;
    parts->kernel = kernel.value();
    const TetMesh& mesh = model.coarse;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        parts->rest.push_back(rest_shape(mesh, mesh.tets[t]));
        if (!(parts->rest.back().volume > 0.0)) {
            return Error{"tetrahedron " + std::to_string(t) + " is flat or inverted at rest", model.name,
                         "positive volume"};
        }
    }
    const LaneAssignment assignment = assigned != nullptr ? *assigned : assign(mesh);
    parts->slot = assignment.slot;
    parts->allocate();
    Group empty{};
    for (int lane = 0; lane < lanes; ++lane) {
        for (int k = 0; k < 6; ++k) {
            empty.gradient[k][lane] = static_cast<float>(spare_gradient[at(k)]);
        }
        for (int a = 0; a < 4; ++a) {
            empty.offset[a][lane] = static_cast<std::uint32_t>(4 * (parts->node_count() + a));
        }
    }
    parts->groups.assign(at(assignment.groups), empty);
    if (model.formulation == Formulation::nodal_pressure) {
        parts->trace.assign(at(assignment.groups * lanes), 0.0F);
        parts->by_node.pressure.assign(at(parts->node_count()), 0.0F);
    }
    const SolidState rest = rest_state(model);
    if (model.sought_step > 0.0) {
        parts->held.emplace(mesh, model.formulation);
    }
    parts->rest_inertia = node_mass(model, rest, tet_stiffness(model, rest)).inertia;
    ExplicitSolid solid(std::move(parts));
    if (assigned == nullptr) {
        solid.load(rest);
    }
    return solid;
}

void ExplicitSolid::load(const SolidState& state) {
    Parts& p = *parts_;
    p.set_elements(state);
    for (int i = 0; i < p.node_count(); ++i) {
        for (int k = 0; k < 3; ++k) {
            p.position[at(4 * i + k)] = state.position[at(i)][k];
            p.velocity[at(4 * i + k)] = p.by_node.mass[at(i)] > 0.0 ? state.velocity[at(i)][k] : 0.0;
        }
    }
    p.origin = state.position.empty() ? Vec3::Zero() : origin_for(state.position.front());
    std::fill(p.force.begin(), p.force.end(), 0.0F);
    p.kernel->move(p.nodes(), 0.0, p.model->damping_stiffness);
}

void ExplicitSolid::store(SolidState& state) const {
    const int count = parts_->node_count();
    state.position.resize(at(count));
    state.velocity.resize(at(count));
    for (int i = 0; i < count; ++i) {
        state.position[at(i)] = position(i);
        state.velocity[at(i)] = velocity(i);
    }
}

double ExplicitSolid::stable_step() {
    if (!(parts_->limit > 0.0)) {
        parts_->limit = parts_->compute_limit();
    }
    return parts_->limit;
}

void ExplicitSolid::predict(double dt, const Vec3& gravity, std::span<const Vec3> external) {
    Parts& p = *parts_;
    p.add_forces(p.probe, p.force);
    for (std::size_t i = 0; i < external.size(); ++i) {
        const double rate = dt * p.by_node.inverse_mass[i];
        for (std::size_t k = 0; k < 3; ++k) {
            p.velocity[4 * i + k] += rate * external[i][static_cast<Eigen::Index>(k)];
        }
    }
    const double pull[4] = {gravity.x(), gravity.y(), gravity.z(), 0.0};
    p.kernel->accelerate(p.nodes(), dt, pull, 1.0 / (1.0 + dt * p.model->damping_mass));
}

void ExplicitSolid::move(double dt) { parts_->kernel->move(parts_->nodes(), dt, parts_->model->damping_stiffness); }

Vec3 ExplicitSolid::position(int node) const { return Eigen::Map<const Vec3>(&parts_->position[at(4 * node)]); }

Vec3 ExplicitSolid::velocity(int node) const { return Eigen::Map<const Vec3>(&parts_->velocity[at(4 * node)]); }

void ExplicitSolid::set_velocity(int node, const Vec3& velocity) {
    if (parts_->by_node.mass[at(node)] > 0.0) {
        Eigen::Map<Vec3>(&parts_->velocity[at(4 * node)]) = velocity;
    }
}

ExplicitSolid::Rows ExplicitSolid::rows() {
    return {parts_->position.data(), parts_->velocity.data(), parts_->by_node.inverse_mass.data(),
            parts_->node_count()};
}

double ExplicitSolid::mass(int node) const { return parts_->by_node.mass[at(node)]; }

bool ExplicitSolid::finite() const {
    const auto good = [](double value) { return std::isfinite(value); };
    return std::all_of(parts_->position.begin(), parts_->position.end(), good) &&
           std::all_of(parts_->velocity.begin(), parts_->velocity.end(), good);
}

std::string_view ExplicitSolid::instruction_set() const { return parts_->kernel->name; }

}  // namespace rhexis
