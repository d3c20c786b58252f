// SPDX-License-Identifier: GPL-3.0-or-later
// Backward Euler in the velocities v at the end of the step, x = x0 + dt v, with K0 the warped stiffness at x0:
//
//   r(v) = M (v0 - v) + dt [f(x) + gravity + external + contact(x)] - dt (damping_mass M + damping_stiffness K0) v = 0
//   A = (1 + dt damping_mass) M + dt^2 (K + contact stiffness) + dt damping_stiffness K0,  A dv = r
//
// The first iteration is linearised about x0 and starts from v0: alone it is the step of [Dequidt2013]. The later ones
// are Newton's with the projected tangent [Smith2019], near
// the end with the consistent one while conjugate gradients find it positive definite. A step along dv is taken if the
// residual's component along dv has fallen to half or changed its sign less than that, and halved else: that asks for
// no energy, which friction lacks.
#include "physics/implicit_solid.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "math/pcg.hpp"
#include "physics/elastic_assembly.hpp"
#include "physics/factor_preconditioner.hpp"

namespace rhexis {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr int max_halvings = 10;
constexpr double descent_left = 0.5;      // share of the slope that may be left, with the other sign, after a step
constexpr int stale_iterations = 12;      // a kept factor that needs more than these is made anew
constexpr double near = 1e-2;             // relative residual below which the unprojected tangent is tried first
constexpr double rounding_floor = 1e-13;  // of the momentum that the forces of a step carry

double norm(const std::vector<double>& v) { return std::sqrt(dot(v, v)); }

Quat turned(const Quat& orientation, const Vec3& angle) {
    // Cayley map: no trigonometry, so no libm in the result
    return (Quat(1.0, 0.5 * angle.x(), 0.5 * angle.y(), 0.5 * angle.z()) * orientation).normalized();
}

}  // namespace

struct ImplicitSolid::Parts {
    explicit Parts(const SolidModel& solid)
        : model(&solid), elastic(solid), matrix(elastic.pattern()), preconditioner(elastic.pattern()) {}

    // What a step is asked to do
    struct Task {
        const SolidState& state;
        const Vec3& gravity;
        std::span<const Vec3> external;
        double dt;
        const ImplicitSettings& settings;
        const CouplingFunction& coupling;
        const std::vector<RigidUnknown>& start;
    };

    void begin(const Task& task);
    void set_velocity(const Task& task, const std::vector<double>& v);
    void evaluate_coupling(const Task& task);
    void add_applied_forces(const Task& task, std::vector<double>& r) const;
    void inertia_times(const std::vector<double>& v, double scale, std::vector<double>& r) const;
    void build_matrix(const Task& task, double tangent_scale, double damping_scale);
    void linearised_residual(const Task& task);
    void full_residual(const Task& task);
    bool solve(const Task& task, ImplicitReport& report);
    PcgResult run_pcg(const Task& task, double target);
    void build_tangent(const Task& task, Tangent kind);
    void search(const Task& task);
    void iterate(const Task& task, ImplicitReport& report);
    void finish(const Task& task, SolidState& next) const;

    const SolidModel* model;
    ElasticAssembly elastic;
    CoupledMatrix matrix;
    FactorPreconditioner preconditioner;
    int last_iterations = 0;
    double factored_dt = 0.0;

    // Scratch of a step
    BlockValues start_stiffness, stiffness;
    std::vector<Vec3> position, force;
    std::vector<RigidUnknown> bodies;
    std::vector<ContactTerm> contacts;
    std::vector<RigidTerm> rigid;
    std::vector<double> velocity0, velocity, residual, change, trial, image;
    double scale = 0.0;      // momentum that the forces carry, for what counts as zero
    double reference = 0.0;  // |r| at the start of the step
    PcgWork work;
};

void ImplicitSolid::Parts::begin(const Task& task) {
    if (elastic.load(task.state)) {
        last_iterations = stale_iterations + 1;
    }
    const std::size_t n = at(elastic.nodes());
    bodies = task.start;
    position = task.state.position;
    velocity0.assign(3 * n + 6 * bodies.size(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        if (elastic.moves()[i] != 0) {
            Eigen::Map<Vec3>(velocity0.data() + 3 * i) = task.state.velocity[i];
        }
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        Eigen::Map<Vec6>(velocity0.data() + 3 * n + 6 * b) = bodies[b].velocity;
    }
    velocity = velocity0;
    residual.resize(velocity0.size());
    change.resize(velocity0.size());
    image.resize(velocity0.size());
}

void ImplicitSolid::Parts::set_velocity(const Task& task, const std::vector<double>& v) {
    const std::size_t n = at(elastic.nodes());
    for (std::size_t i = 0; i < n; ++i) {
        position[i] = task.state.position[i] + task.dt * Eigen::Map<const Vec3>(v.data() + 3 * i);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Eigen::Map<const Vec6> own(v.data() + 3 * n + 6 * b);
        bodies[b].velocity = own;
        bodies[b].pose.position = task.start[b].pose.position + task.dt * own.head<3>();
        bodies[b].pose.orientation = turned(task.start[b].pose.orientation, task.dt * own.tail<3>());
    }
}

void ImplicitSolid::Parts::evaluate_coupling(const Task& task) {
    contacts.clear();
    rigid.assign(bodies.size(), RigidTerm{});
    if (task.coupling) {
        task.coupling(position, bodies, contacts, rigid);
    }
    RHEXIS_ASSERT(rigid.size() == bodies.size());
}

/// r += dt (elastic + gravity + external + contact and rigid forces), zero on nodes that do not move.
void ImplicitSolid::Parts::add_applied_forces(const Task& task, std::vector<double>& r) const {
    const std::size_t n = at(elastic.nodes());
    for (std::size_t i = 0; i < n; ++i) {
        Vec3 sum = force[i] + elastic.mass().weight[i] * task.gravity;
        if (!task.external.empty()) {
            sum += task.external[i];
        }
        Eigen::Map<Vec3>(r.data() + 3 * i) += task.dt * sum;
    }
    for (std::size_t b = 0; b < rigid.size(); ++b) {
        Eigen::Map<Vec6>(r.data() + 3 * n + 6 * b) += task.dt * rigid[b].force;
    }
    for (const ContactTerm& contact : contacts) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (contact.nodes[k] >= 0) {
                Eigen::Map<Vec3>(r.data() + 3 * at(contact.nodes[k])) += task.dt * contact.weights[k] * contact.force;
            }
        }
        if (contact.body >= 0) {
            Eigen::Map<Vec6>(r.data() + 3 * n + 6 * at(contact.body)) -=
                task.dt * rigid_jacobian(contact.arm).transpose() * contact.force;
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (elastic.moves()[i] == 0) {
            Eigen::Map<Vec3>(r.data() + 3 * i).setZero();
        }
    }
}

/// r += scale M v.
void ImplicitSolid::Parts::inertia_times(const std::vector<double>& v, double factor, std::vector<double>& r) const {
    const std::size_t n = at(elastic.nodes());
    for (std::size_t i = 0; i < 3 * n; ++i) {
        r[i] += factor * elastic.mass().inertia[i / 3] * v[i];
    }
    for (std::size_t b = 0; b < rigid.size(); ++b) {
        Eigen::Map<Vec6>(r.data() + 3 * n + 6 * b) +=
            factor * rigid[b].mass * Eigen::Map<const Vec6>(v.data() + 3 * n + 6 * b);
    }
}

/// A from `stiffness` and `start_stiffness` at the current contacts.
void ImplicitSolid::Parts::build_matrix(const Task& task, double tangent_scale, double damping_scale) {
    BlockValues& a = matrix.solid();
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = tangent_scale * stiffness[i] + damping_scale * start_stiffness[i];
    }
    const double inertia = 1.0 + task.dt * model->damping_mass;
    for (int i = 0; i < elastic.nodes(); ++i) {
        const double mass = elastic.moves()[at(i)] != 0 ? inertia * elastic.mass().inertia[at(i)] : 1.0;
        add_block(a, elastic.pattern().diagonal[at(i)], mass * Mat3::Identity());
    }
    matrix.clear_coupling(static_cast<int>(bodies.size()));
    for (std::size_t b = 0; b < rigid.size(); ++b) {
        const Eigen::Index row = static_cast<Eigen::Index>(6 * b);
        matrix.rigid().block<6, 6>(row, row) = rigid[b].mass + task.dt * task.dt * rigid[b].stiffness;
    }
    for (const ContactTerm& contact : contacts) {
        matrix.add(contact, task.dt * task.dt, elastic.moves());
    }
}

void ImplicitSolid::Parts::build_tangent(const Task& task, Tangent kind) {
    stiffness.resize(start_stiffness.size());
    elastic.forces_and_stiffness(position, kind, force, stiffness);
    build_matrix(task, task.dt * task.dt, task.dt * model->damping_stiffness);
}

/// r of the system linearised about the start of the step, at v0: dt f + M v0 - A v0 (mass damping is in A).
void ImplicitSolid::Parts::linearised_residual(const Task& task) {
    start_stiffness.resize(zero_values(elastic.pattern()).size());
    elastic.forces_and_stiffness(position, Tangent::warped, force, start_stiffness);
    stiffness = start_stiffness;
    evaluate_coupling(task);
    build_matrix(task, task.dt * task.dt, task.dt * model->damping_stiffness);
    std::fill(residual.begin(), residual.end(), 0.0);
    inertia_times(velocity0, 1.0, residual);
    scale = norm(residual);
    matrix.multiply(velocity0, image);
    scale += norm(image);
    for (std::size_t i = 0; i < residual.size(); ++i) {
        residual[i] -= image[i];
    }
    std::fill(image.begin(), image.end(), 0.0);
    add_applied_forces(task, image);
    for (std::size_t i = 0; i < residual.size(); ++i) {
        residual[i] += image[i];
    }
    for (std::size_t i = 0; i < force.size(); ++i) {
        const Vec3 weight = elastic.mass().weight[i] * task.gravity;
        image[3 * i] = task.dt * (force[i].norm() + weight.norm());
        image[3 * i + 1] = image[3 * i + 2] = 0.0;
    }
    scale += norm(image);
    reference = std::max(norm(residual), rounding_floor * scale);
}

/// r at the current position and velocity, with the coupling of there.
void ImplicitSolid::Parts::full_residual(const Task& task) {
    elastic.forces(position, force);
    evaluate_coupling(task);
    std::fill(residual.begin(), residual.end(), 0.0);
    add_applied_forces(task, residual);
    inertia_times(velocity0, 1.0, residual);
    const std::size_t solid = matrix.solid_size();
    for (std::size_t i = 0; i < solid; ++i) {
        residual[i] -= (1.0 + task.dt * model->damping_mass) * elastic.mass().inertia[i / 3] * trial[i];
    }
    for (std::size_t b = 0; b < rigid.size(); ++b) {
        Eigen::Map<Vec6>(residual.data() + solid + 6 * b) -=
            rigid[b].mass * Eigen::Map<const Vec6>(trial.data() + solid + 6 * b);
    }
    if (model->damping_stiffness > 0.0) {
        multiply(elastic.pattern(), start_stiffness, trial, image);
        for (std::size_t i = 0; i < solid; ++i) {
            residual[i] -= task.dt * model->damping_stiffness * image[i];
        }
    }
    for (std::size_t i = 0; i < solid; ++i) {
        if (elastic.moves()[i / 3] == 0) {
            residual[i] = 0.0;
        }
    }
}

PcgResult ImplicitSolid::Parts::run_pcg(const Task& task, double target) {
    const auto multiply = [this](std::span<const double> x, std::span<double> y) { matrix.multiply(x, y); };
    const auto precondition = [this](std::span<const double> r, std::span<double> z) { preconditioner.apply(r, z); };
    return pcg(residual, target, task.settings.max_linear_iterations, multiply, precondition, change, work);
}

/// change = A^-1 residual. False if that was not reached.
bool ImplicitSolid::Parts::solve(const Task& task, ImplicitReport& report) {
    const double target = std::max(task.settings.tolerance * norm(residual), 0.1 * rounding_floor * scale);
    if (!preconditioner.kept() || preconditioner.bodies() != static_cast<int>(bodies.size()) ||
        factored_dt != task.dt || last_iterations > stale_iterations) {
        report.factored = true;
        factored_dt = task.dt;
        if (!preconditioner.factor(matrix)) {
            std::fill(change.begin(), change.end(), 0.0);
            report.residual = HUGE_VAL;
            return false;
        }
    }
    const PcgResult result = run_pcg(task, target);
    last_iterations = result.iterations;
    report.linear_iterations += result.iterations;
    report.residual = result.residual / std::max(norm(residual), rounding_floor * scale);
    if (!result.converged) {
        preconditioner.drop();
    }
    return result.converged;
}

/// Goes along `change` from `velocity` until the residual's component along it has fallen; leaves `residual` there.
void ImplicitSolid::Parts::search(const Task& task) {
    const double slope = dot(residual, change);
    double step = 1.0;
    for (int halving = 0;; ++halving) {
        trial = velocity;
        for (std::size_t i = 0; i < trial.size(); ++i) {
            trial[i] += step * change[i];
        }
        set_velocity(task, trial);
        full_residual(task);
        const double left = dot(residual, change);
        if ((std::isfinite(left) && left >= -descent_left * slope) || halving == max_halvings) {
            break;
        }
        step *= 0.5;
    }
    velocity = trial;
}

void ImplicitSolid::Parts::iterate(const Task& task, ImplicitReport& report) {
    linearised_residual(task);
    const bool newton = task.settings.max_newton > 1;
    report.converged = reference == 0.0;
    report.residual = reference == 0.0 || !std::isfinite(reference) ? reference : 1.0;
    report.newton_residual = report.residual;
    if (report.converged || !std::isfinite(reference)) {
        set_velocity(task, velocity);
        return;
    }
    for (int iteration = 0; iteration < std::max(1, task.settings.max_newton); ++iteration) {
        bool solved = false;
        if (iteration > 0 && report.newton_residual < near) {
            build_tangent(task, Tangent::consistent);
            solved = solve(task, report);
        }
        if (!solved) {
            if (iteration > 0) {
                build_tangent(task, Tangent::projected);
            }
            solved = solve(task, report);
        }
        ++report.newton_iterations;
        if (!newton) {
            for (std::size_t i = 0; i < velocity.size(); ++i) {
                velocity[i] += change[i];
            }
            set_velocity(task, velocity);
            report.newton_residual = report.residual;
            report.converged = solved && std::isfinite(norm(velocity));
            return;
        }
        search(task);
        report.newton_residual = norm(residual) / reference;
        report.converged = report.newton_residual <= task.settings.newton_tolerance;
        if (report.converged || !std::isfinite(report.newton_residual)) {
            return;
        }
    }
}

void ImplicitSolid::Parts::finish(const Task& task, SolidState& next) const {
    next.present = task.state.present;
    next.fraction = task.state.fraction;
    next.position = position;
    next.velocity.resize(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
        next.velocity[i] = Eigen::Map<const Vec3>(velocity.data() + 3 * i);
    }
}

Result<ImplicitSolid> ImplicitSolid::create(const SolidModel& model, ThreadPool&) {
    return ImplicitSolid(std::make_unique<Parts>(model));
}

ImplicitSolid::ImplicitSolid(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ImplicitSolid::~ImplicitSolid() = default;
ImplicitSolid::ImplicitSolid(ImplicitSolid&&) noexcept = default;

ImplicitReport ImplicitSolid::step(const SolidState& state, const Vec3& gravity, std::span<const Vec3> external,
                                   double dt, const ImplicitSettings& settings, const CouplingFunction& coupling,
                                   std::vector<RigidUnknown>& bodies, SolidState& next) {
    RHEXIS_ASSERT(dt > 0.0 && (external.empty() || external.size() == state.position.size()));
    ImplicitReport report;
    const Parts::Task task{state, gravity, external, dt, settings, coupling, bodies};
    parts_->begin(task);
    parts_->iterate(task, report);
    parts_->finish(task, next);
    bodies = parts_->bodies;
    return report;
}

void ImplicitSolid::drop_caches() { parts_->preconditioner.drop(); }

}  // namespace rhexis
