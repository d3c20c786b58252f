// SPDX-License-Identifier: GPL-3.0-or-later
// Backward Euler in the velocities v at the end of the step, x = x0 + dt v, with K0 the warped stiffness at x0:
//
//   r(v) = M (v0 - v) + dt [f(x) + gravity + external + contact(x)] - dt (damping_mass M + damping_stiffness K0 + D) v
//   A = (1 + dt damping_mass) M + dt D + dt^2 (K + contact stiffness) + dt damping_stiffness K0,  A dv = r
//
// and r(v) = 0. D: drag of a fluid at rest. The first iteration is linearised about x0 and starts from v0: alone it is
// the step of [Dequidt2013]. The later ones are Newton's with the projected tangent [Smith2019], near the end with the
// consistent one while conjugate gradients find it positive definite. A step that is predicted begins with them, at x0
// + dt v0. A step along dv is taken if the residual's component along dv has fallen to half or changed its sign less
// than that, and halved else: that asks for no energy, which friction lacks.
#include "physics/solve/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "math/rotation.hpp"
#include "physics/solve/kept_solver.hpp"

namespace rhexis {
namespace {

using elastic_kernel::Mode;

constexpr int max_halvings = 10;
constexpr int max_brackets = 12;
constexpr double most_growth = 4.0;  // of a step that goes farther
constexpr double inner_low = 0.15;   // places looked at next, of what is bracketed
constexpr double inner_high = 0.7;
constexpr double descent_left = 0.5;  // share of the slope that may be left, with the other sign, after a step
constexpr double near = 1e-2;         // relative residual below which the unprojected tangent is tried first
constexpr double ulp = 2.2e-16;

double norm(const std::vector<double>& v) { return std::sqrt(dot(v, v)); }

}  // namespace

// Vectors hold three numbers per row (nodes in the order of elimination), then six per body.
struct ImplicitStep::Parts {
    Parts(std::unique_ptr<ElasticBody> owned, const linear_kernel::Kernel& kernel)
        : body(std::move(owned)), matrix(body->pattern(), kernel), solver(body->pattern(), kernel) {}

    /// What a step is asked to do.
    struct Task {
        std::span<const Vec3> position;
        std::span<const Vec3> velocity;
        const Vec3& gravity;
        std::span<const Vec3> external;
        double dt;
        const ImplicitSettings& settings;
        const CouplingFunction& coupling;
        const std::vector<RigidUnknown>& start;
        std::span<const Vec3> guess;
    };

    void begin(const Task& task);
    void set_velocity(const Task& task, const std::vector<double>& v);
    void evaluate_coupling(const Task& task);
    void add_applied_forces(const Task& task, std::vector<double>& r) const;
    void add_contact_forces(const Task& task, std::vector<double>& r) const;
    void add_inertia(const std::vector<double>& v, double factor, std::vector<double>& r) const;
    void hold(std::vector<double>& r) const;
    void complete_matrix(const Task& task);
    [[nodiscard]] double rounding_of_forces(const Task& task) const;
    void linearised_residual(const Task& task);
    void predicted_residual(const Task& task);
    void full_residual(const Task& task);
    void balance(const Task& task);
    void build_tangent(const Task& task, Mode mode);
    bool solve(const Task& task, Mode mode, ImplicitReport& report);
    [[nodiscard]] double longest_step(const Task& task) const;
    double try_step(const Task& task, const std::vector<double>& start, double step);
    void halve(const Task& task, const std::vector<double>& start, double step, double slope);
    void bracket(const Task& task, const std::vector<double>& start, double longest, double slope);
    void search(const Task& task);
    void judge(const Task& task, ImplicitReport& report) const;
    void iterate(const Task& task, ImplicitReport& report);
    void newton(const Task& task, ImplicitReport& report);
    void finish(NodeMotion& next) const;

    std::unique_ptr<ElasticBody> body;
    CoupledMatrix matrix;
    KeptSolver solver;
    double last_dt = 0.0;

    // scratch of a step
    BlockValues damping;  ///< dt * damping_stiffness * K0; only if Newton's method needs it
    std::vector<double> x, force;
    std::vector<Vec3> position;  ///< by nodes
    std::vector<RigidUnknown> bodies;
    std::vector<ContactTerm> contacts;
    std::vector<RigidTerm> rigid;
    std::vector<double> velocity0, velocity, residual, change, image;
    double rounding = 0.0;   ///< what |r| cannot fall below
    double reference = 0.0;  ///< |r| at the start of the step
};

void ImplicitStep::Parts::begin(const Task& task) {
    body->forget_prediction();
    if (last_dt != task.dt) {
        solver.expect_change();
        last_dt = task.dt;
    }
    const std::size_t n = at(body->rows());
    bodies = task.start;
    position.assign(task.position.begin(), task.position.end());
    velocity0.assign(3 * n + 6 * bodies.size(), 0.0);
    x.assign(3 * n + 1, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t node = at(body->node_of()[i]);
        Eigen::Map<Vec3>(x.data() + 3 * i) = task.position[node];
        if (body->moves()[i] != 0) {
            Eigen::Map<Vec3>(velocity0.data() + 3 * i) = task.velocity[node];
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

/// Positions and poses at the end of a step of velocities v.
void ImplicitStep::Parts::set_velocity(const Task& task, const std::vector<double>& v) {
    const std::size_t n = at(body->rows());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t node = at(body->node_of()[i]);
        position[node] = task.position[node] + task.dt * Eigen::Map<const Vec3>(v.data() + 3 * i);
        Eigen::Map<Vec3>(x.data() + 3 * i) = position[node];
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Eigen::Map<const Vec6> own(v.data() + 3 * n + 6 * b);
        bodies[b].velocity = own;
        bodies[b].pose.position = task.start[b].pose.position + task.dt * own.head<3>();
        bodies[b].pose.orientation = turned(task.start[b].pose.orientation, task.dt * own.tail<3>());
    }
}

void ImplicitStep::Parts::evaluate_coupling(const Task& task) {
    contacts.clear();
    rigid.assign(bodies.size(), RigidTerm{});
    if (task.coupling) {
        task.coupling(position, bodies, contacts, rigid);
    }
    RHEXIS_ASSERT(rigid.size() == bodies.size());
    for (ContactTerm& contact : contacts) {
        for (int& node : contact.nodes) {
            node = node >= 0 ? body->row_of()[at(node)] : node;
        }
        for (ContactShare& share : contact.more) {
            share.node = body->row_of()[at(share.node)];
        }
    }
}

void ImplicitStep::Parts::add_contact_forces(const Task& task, std::vector<double>& r) const {
    const std::size_t solid = matrix.solid_size();
    for (const ContactTerm& contact : contacts) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (contact.nodes[k] >= 0) {
                Eigen::Map<Vec3>(r.data() + 3 * at(contact.nodes[k])) += task.dt * contact.weights[k] * contact.force;
            }
        }
        for (const ContactShare& share : contact.more) {
            Eigen::Map<Vec3>(r.data() + 3 * at(share.node)) += task.dt * share.share.transpose() * contact.force;
        }
        if (contact.body >= 0) {
            Eigen::Map<Vec6>(r.data() + solid + 6 * at(contact.body)) -=
                task.dt * rigid_jacobian(contact.arm).transpose() * contact.force;
        }
    }
}

/// r += dt (elastic + gravity + external + contact and rigid forces).
void ImplicitStep::Parts::add_applied_forces(const Task& task, std::vector<double>& r) const {
    const std::size_t n = at(body->rows());
    for (std::size_t i = 0; i < n; ++i) {
        Vec3 sum = Eigen::Map<const Vec3>(force.data() + 3 * i) + body->mass().weight[i] * task.gravity;
        if (!task.external.empty()) {
            sum += task.external[at(body->node_of()[i])];
        }
        Eigen::Map<Vec3>(r.data() + 3 * i) += task.dt * sum;
    }
    for (std::size_t b = 0; b < rigid.size(); ++b) {
        Eigen::Map<Vec6>(r.data() + 3 * n + 6 * b) += task.dt * rigid[b].force;
    }
    add_contact_forces(task, r);
}

/// r += factor M v.
void ImplicitStep::Parts::add_inertia(const std::vector<double>& v, double factor, std::vector<double>& r) const {
    const std::size_t n = at(body->rows());
    for (std::size_t i = 0; i < n; ++i) {
        Eigen::Map<Vec3>(r.data() + 3 * i) +=
            factor * body->mass().inertia[i] * Eigen::Map<const Vec3>(v.data() + 3 * i);
    }
    for (std::size_t b = 0; b < rigid.size(); ++b) {
        Eigen::Map<Vec6>(r.data() + 3 * n + 6 * b) +=
            factor * rigid[b].mass * Eigen::Map<const Vec6>(v.data() + 3 * n + 6 * b);
    }
}

/// Nothing pulls at nodes that do not move.
void ImplicitStep::Parts::hold(std::vector<double>& r) const {
    for (std::size_t i = 0; i < body->moves().size(); ++i) {
        if (body->moves()[i] == 0) {
            Eigen::Map<Vec3>(r.data() + 3 * i).setZero();
        }
    }
}

/// Adds inertia, contacts and bodies to the stiffness in the upper triangle of the matrix.
void ImplicitStep::Parts::complete_matrix(const Task& task) {
    const double inertia = 1.0 + task.dt * body->damping_mass();
    for (int i = 0; i < body->rows(); ++i) {
        double mass = body->moves()[at(i)] != 0 ? inertia * body->mass().inertia[at(i)] : 1.0;
        if (!body->row_drag().empty() && body->moves()[at(i)] != 0) {
            mass += task.dt * body->row_drag()[at(i)];
        }
        add_block(matrix.solid(), body->pattern().diagonal[at(i)], mass * Mat3::Identity());
    }
    mirror_upper(body->pattern(), matrix.solid());
    matrix.clear_coupling(static_cast<int>(bodies.size()));
    for (std::size_t b = 0; b < rigid.size(); ++b) {
        const Eigen::Index row = static_cast<Eigen::Index>(6 * b);
        matrix.rigid().block<6, 6>(row, row) = rigid[b].mass + task.dt * task.dt * rigid[b].stiffness;
    }
    for (const ContactTerm& contact : contacts) {
        matrix.add(contact, task.dt * task.dt, body->moves());
    }
}

/// Positions are known to an ulp, so forces to stiffness times that.
double ImplicitStep::Parts::rounding_of_forces(const Task& task) const {
    double sum = 0.0;
    for (int i = 0; i < body->rows(); ++i) {
        if (body->moves()[at(i)] != 0) {
            const Mat3 own = block_of(matrix.solid(), body->pattern().diagonal[at(i)]);
            sum += own.squaredNorm() * Eigen::Map<const Vec3>(x.data() + 3 * i).squaredNorm();
        }
    }
    return ulp * std::sqrt(sum) / task.dt;
}

/// r of the system linearised about the start of the step, at v0: dt f + M v0 - A v0 (mass damping is in A).
void ImplicitStep::Parts::linearised_residual(const Task& task) {
    const double damped = task.dt * body->damping_stiffness();
    const double weight = task.dt * task.dt + damped;
    body->forces_and_stiffness(x, Mode::warped, weight, force, matrix.solid());
    if (task.settings.max_newton > 1 && damped > 0.0) {
        damping = matrix.solid();
        for (double& value : damping) {
            value *= damped / weight;
        }
        mirror_upper(body->pattern(), damping);
    }
    evaluate_coupling(task);
    complete_matrix(task);
    std::fill(residual.begin(), residual.end(), 0.0);
    add_applied_forces(task, residual);
    hold(residual);
    rounding = rounding_of_forces(task) + 10.0 * ulp * norm(residual);
    add_inertia(velocity0, 1.0, residual);
    matrix.multiply(velocity0, image);
    rounding += 10.0 * ulp * norm(image);
    for (std::size_t i = 0; i < residual.size(); ++i) {
        residual[i] -= image[i];
    }
    reference = std::max(norm(residual), rounding);
}

/// r and A at where the velocities at the start lead, or those guessed. Reference 0: that is where the step ends.
void ImplicitStep::Parts::predicted_residual(const Task& task) {
    for (std::size_t i = 0; i < at(body->rows()) && !task.guess.empty(); ++i) {
        if (body->moves()[i] != 0) {
            Eigen::Map<Vec3>(velocity.data() + 3 * i) = task.guess[at(body->node_of()[i])];
        }
    }
    set_velocity(task, velocity);
    full_residual(task);
    if (norm(residual) <= task.dt * task.settings.rest_tolerance) {
        rounding = 0.0;
        reference = 0.0;
        return;
    }
    build_tangent(task, Mode::projected);
    rounding = rounding_of_forces(task) + 10.0 * ulp * norm(residual);
    reference = std::max(norm(residual), rounding);
}

/// r at x and the bodies' poses, which belong to `velocity`, with the coupling of there.
void ImplicitStep::Parts::full_residual(const Task& task) {
    body->forces(x, force);
    evaluate_coupling(task);
    balance(task);
}

/// r of forces and coupling that are known.
void ImplicitStep::Parts::balance(const Task& task) {
    std::fill(residual.begin(), residual.end(), 0.0);
    add_applied_forces(task, residual);
    add_inertia(velocity0, 1.0, residual);
    add_inertia(velocity, -1.0, residual);
    for (std::size_t i = 0; i < matrix.solid_size(); ++i) {
        residual[i] -= task.dt * body->damping_mass() * body->mass().inertia[i / 3] * velocity[i];
    }
    for (std::size_t i = 0; i < 3 * body->row_drag().size(); ++i) {
        residual[i] -= task.dt * body->row_drag()[i / 3] * velocity[i];
    }
    if (body->damping_stiffness() > 0.0) {
        multiply(body->pattern(), damping, velocity, image);
        for (std::size_t i = 0; i < matrix.solid_size(); ++i) {
            residual[i] -= image[i];
        }
    }
    hold(residual);
}

void ImplicitStep::Parts::build_tangent(const Task& task, Mode mode) {
    body->forces_and_stiffness(x, mode, task.dt * task.dt, force, matrix.solid());
    if (body->damping_stiffness() > 0.0) {
        for (std::size_t i = 0; i < damping.size(); ++i) {
            matrix.solid()[i] += damping[i];
        }
    }
    complete_matrix(task);
}

/// change = A^-1 residual. False if that was not reached.
bool ImplicitStep::Parts::solve(const Task& task, Mode mode, ImplicitReport& report) {
    const double size = norm(residual);
    const double target = std::max(task.settings.tolerance * size, 0.1 * rounding);
    solver.try_seldom(task.settings.seldom_again);
    solver.foretell(task.settings.foretell);
    if (task.settings.new_factors) {
        solver.expect_change();
    }
    const KeptSolver::Outcome outcome =
        solver.solve(matrix, residual, target, task.settings.max_linear_iterations, change,
                     mode == Mode::consistent && task.settings.quick_to_project);
    report.linear_iterations += outcome.iterations;
    report.factored = report.factored || outcome.factored;
    report.residual = outcome.residual / std::max(size, rounding);
    return outcome.converged;
}

/// Share of `change` that takes the node that goes farthest as far as the settings' most_travel allows.
double ImplicitStep::Parts::longest_step(const Task& task) const {
    if (!(task.settings.most_travel > 0.0)) {
        return HUGE_VAL;
    }
    double most = 0.0;
    for (std::size_t i = 0; i < matrix.solid_size(); i += 3) {
        most = std::max(most, Eigen::Map<const Vec3>(change.data() + i).squaredNorm());
    }
    return task.settings.most_travel / (task.dt * std::sqrt(most));
}

/// Goes that share of `change`; the residual's component along it there.
double ImplicitStep::Parts::try_step(const Task& task, const std::vector<double>& start, double step) {
    for (std::size_t i = 0; i < velocity.size(); ++i) {
        velocity[i] = start[i] + step * change[i];
    }
    set_velocity(task, velocity);
    full_residual(task);
    return dot(residual, change);
}

void ImplicitStep::Parts::halve(const Task& task, const std::vector<double>& start, double step, double slope) {
    for (int halving = 0;; ++halving) {
        const double left = try_step(task, start, step);
        if ((std::isfinite(left) && (left >= -descent_left * slope || task.settings.predict_stress)) ||
            halving == max_halvings) {
            return;
        }
        step *= 0.5;
    }
}

/// By false position, kept away from the ends of what is bracketed; farther than the tangent says where it was too
/// stiff.
void ImplicitStep::Parts::bracket(const Task& task, const std::vector<double>& start, double longest, double slope) {
    struct End {
        double step;
        double left;
    };
    End low{0.0, slope};
    End high{HUGE_VAL, 0.0};
    double step = std::min(1.0, longest);
    for (int tries = 0;; ++tries) {
        const double left = try_step(task, start, step);
        const bool beyond = !(left > 0.0);
        if (std::abs(left) <= task.settings.search_to * slope || tries == max_brackets ||
            (!beyond && step >= longest)) {
            return;
        }
        (beyond ? high : low) = {step, left};
        if (high.step == HUGE_VAL) {
            const double grown = left < slope ? std::min(most_growth, slope / (slope - left)) : most_growth;
            step = std::min(longest, grown * step);
            continue;
        }
        const double width = high.step - low.step;
        const double root = std::isfinite(high.left) ? low.left / (low.left - high.left) : 0.5;
        step = low.step + width * std::clamp(root, inner_low, inner_high);
    }
}

/// Goes along `change` until the residual's component along it has fallen; leaves `velocity` and `residual` there.
void ImplicitStep::Parts::search(const Task& task) {
    const std::vector<double> start = velocity;
    const double slope = dot(residual, change);
    const double longest = longest_step(task);
    if (task.settings.predict_stress) {
        for (std::size_t i = 0; i < image.size(); ++i) {
            image[i] = std::min(1.0, longest) * task.dt * change[i];
        }
        body->predict(x, image);
    }
    if (task.settings.search_to > 0.0 && slope > 0.0) {
        bracket(task, start, longest, slope);
    } else {
        halve(task, start, std::min(1.0, longest), slope);
    }
}

/// How far from balance the step is.
void ImplicitStep::Parts::judge(const Task& task, ImplicitReport& report) const {
    const double left = norm(residual);
    report.newton_residual = left / reference;
    report.force = left / task.dt;
    report.converged = left <= std::max(task.settings.newton_tolerance * reference, 4.0 * rounding) ||
                       report.force <= task.settings.force_tolerance;
    if (task.settings.contact_tolerance > 0.0 && !contacts.empty()) {
        double square = 0.0;
        for (const ContactTerm& contact : contacts) {
            square += contact.force.squaredNorm();
        }
        report.over_contact = report.force / std::sqrt(square);
        report.converged = report.converged || report.over_contact <= task.settings.contact_tolerance;
    }
}

void ImplicitStep::Parts::newton(const Task& task, ImplicitReport& report) {
    for (int iteration = 0; iteration < task.settings.max_newton; ++iteration) {
        bool solved = false;
        if (iteration > 0 &&
            (std::min(report.newton_residual, report.over_contact) < near || task.settings.predict_stress)) {
            build_tangent(task, Mode::consistent);
            solved = solve(task, Mode::consistent, report);
        }
        if (!solved) {
            if (iteration > 0) {
                build_tangent(task, Mode::projected);
            }
            solve(task, Mode::projected, report);
        }
        ++report.newton_iterations;
        search(task);
        judge(task, report);
        if (report.converged || !std::isfinite(report.newton_residual)) {
            return;
        }
    }
}

void ImplicitStep::Parts::iterate(const Task& task, ImplicitReport& report) {
    if (task.settings.predict && body->damping_stiffness() == 0.0) {
        predicted_residual(task);
    } else {
        linearised_residual(task);
    }
    report.converged = reference == 0.0;
    report.residual = reference == 0.0 || !std::isfinite(reference) ? reference : 1.0;
    report.newton_residual = report.residual;
    if (report.converged || !std::isfinite(reference)) {
        set_velocity(task, velocity);
        return;
    }
    if (task.settings.max_newton > 1) {
        newton(task, report);
        return;
    }
    const bool solved = solve(task, Mode::warped, report);
    for (std::size_t i = 0; i < velocity.size(); ++i) {
        velocity[i] += change[i];
    }
    set_velocity(task, velocity);
    report.newton_iterations = 1;
    report.newton_residual = report.residual;
    report.converged = solved && std::isfinite(norm(velocity));
}

void ImplicitStep::Parts::finish(NodeMotion& next) const {
    next.position = position;
    next.velocity.resize(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
        next.velocity[at(body->node_of()[i])] = Eigen::Map<const Vec3>(velocity.data() + 3 * i);
    }
}

ImplicitStep::ImplicitStep(std::unique_ptr<ElasticBody> body, const linear_kernel::Kernel& kernel)
    : parts_(std::make_unique<Parts>(std::move(body), kernel)) {}
ImplicitStep::~ImplicitStep() = default;
ImplicitStep::ImplicitStep(ImplicitStep&&) noexcept = default;
ImplicitStep& ImplicitStep::operator=(ImplicitStep&&) noexcept = default;

ElasticBody& ImplicitStep::body() { return *parts_->body; }

ImplicitReport ImplicitStep::step(std::span<const Vec3> position, std::span<const Vec3> velocity, const Vec3& gravity,
                                  std::span<const Vec3> external, double dt, const ImplicitSettings& settings,
                                  const CouplingFunction& coupling, std::vector<RigidUnknown>& bodies, NodeMotion& next,
                                  std::span<const Vec3> guess) {
    RHEXIS_ASSERT(dt > 0.0 && (external.empty() || external.size() == position.size()) &&
                  (guess.empty() || guess.size() == position.size()));
    ImplicitReport report;
    const Parts::Task task{position, velocity, gravity, external, dt, settings, coupling, bodies, guess};
    parts_->begin(task);
    parts_->iterate(task, report);
    parts_->finish(next);
    bodies = parts_->bodies;
    return report;
}

void ImplicitStep::follow(std::span<const int> row_now) {
    parts_->matrix.follow(parts_->body->pattern());
    parts_->solver.follow(parts_->body->pattern(), row_now);
    parts_->last_dt = 0.0;
}

void ImplicitStep::drop_caches() { parts_->solver.drop(); }

}  // namespace rhexis
