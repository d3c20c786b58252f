// SPDX-License-Identifier: GPL-3.0-or-later
// Backward Euler of one elastic body, together with the rigid bodies that it touches.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "math/linear_kernel.hpp"
#include "physics/solve/contact_term.hpp"
#include "physics/solve/elastic_body.hpp"

namespace rhexis {

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// A rigid partner that moves with the body's solve (the bag).
struct RigidUnknown {
    Pose pose;
    Vec6 velocity = Vec6::Zero();
};

/// Forces on the rigid bodies that do not come from contact, at an iterate: springs and damping.
struct RigidTerm {
    Vec6 force = Vec6::Zero();      ///< [uN], [uN mm]
    Mat6 stiffness = Mat6::Zero();  ///< -d force / d displacement, symmetric positive semidefinite
    Mat6 mass = Mat6::Identity();   ///< [g], [g mm^2]
};

/// Evaluates contact and rigid forces at an iterate of positions (nodes) and rigid poses.
using CouplingFunction = std::function<void(const std::vector<Vec3>& position, std::span<const RigidUnknown> bodies,
                                            std::vector<ContactTerm>& contacts, std::vector<RigidTerm>& rigid)>;

struct ImplicitSettings {
    double tolerance = 1e-6;         ///< relative residual of each linear solve
    int max_newton = 4;              ///< 1: one linearised step, as in the paper
    double newton_tolerance = 1e-4;  ///< relative residual of the step at which Newton stops
    double force_tolerance = 0.0;    ///< residual force at which it stops, whatever the relative residual [uN]
    /// Residual force at which it stops as a share of those of contact: root of the sums of squares over nodes and over
    /// contacts. Of what goes on as it did, what did not balance at the start is little, and says less.
    double contact_tolerance = 0.0;
    double rest_tolerance = 0.0;  ///< residual force at which what was predicted is taken as it is [uN]
    int max_linear_iterations = 1000;
    bool predict =
        false;  ///< linearised first where the velocities lead; more than one iteration; not of bodies with K0 damping
    bool new_factors = false;   ///< one per linear solve: pays where the matrix changes much from each to the next
    bool seldom_again = false;  ///< a kept factor that did not serve is tried ever more seldom: likewise
    bool foretell = false;      ///< solves begin from what earlier solutions span: pays where it changes little
    /// Tangents with the stress that the last iteration predicted, whole iterations whatever the residual does between:
    /// for shells, which turn far while they strain little.
    bool predict_stress = false;
    /// A consistent tangent that has no factor in single precision is taken as indefinite, without trying double: where
    /// many are, as of a shell that buckles.
    bool quick_to_project = false;
    /// Share of the residual's component along an iteration's way that may be left at its end, of either sign; the
    /// place where it vanishes is bracketed. For what meets a spring at every turn, where the tangent says little of
    /// how far to go. 0: half its way, and again, until it has turned by less than half.
    double search_to = 0.0;
    double most_travel = 0.0;  ///< of any node in one iteration, so that nothing is jumped over [mm]; 0: no limit
};

struct ImplicitReport {
    int newton_iterations = 0;
    int linear_iterations = 0;
    double residual = 0.0;           ///< relative, of the last linear solve
    double newton_residual = 0.0;    ///< relative, of the step
    double force = 0.0;              ///< norm of the forces that do not balance at the end of the step [uN]
    double over_contact = HUGE_VAL;  ///< that over the norm of the forces of contact, if those decide
    bool converged = false;
    bool factored = false;  ///< a new factor was made in this step
};

/// What moves, per node.
struct NodeMotion {
    std::vector<Vec3> position;  ///< [mm]
    std::vector<Vec3> velocity;  ///< [mm/s]
};

class ImplicitStep {
public:
    /// The kernel's tables are static.
    ImplicitStep(std::unique_ptr<ElasticBody> body, const linear_kernel::Kernel& kernel);
    ~ImplicitStep();
    ImplicitStep(ImplicitStep&&) noexcept;
    ImplicitStep& operator=(ImplicitStep&&) noexcept;

    [[nodiscard]] ElasticBody& body();
    /// As a new one, in the memory that is there, for the body whose rows are no more those that they were. row_now: as
    /// of PackedFactor.
    void follow(std::span<const int> row_now);

    /// One step of dt [s]. external: force per node without gravity [uN], or empty; gravity [mm/s^2] is applied inside.
    /// bodies: at the start of the step on entry, at its end on return. next may not be `position`, `velocity`.
    /// guess: per node, the velocity with which the search of a step that is predicted begins instead of `velocity`; or
    /// empty.
    ImplicitReport step(std::span<const Vec3> position, std::span<const Vec3> velocity, const Vec3& gravity,
                        std::span<const Vec3> external, double dt, const ImplicitSettings& settings,
                        const CouplingFunction& coupling, std::vector<RigidUnknown>& bodies, NodeMotion& next,
                        std::span<const Vec3> guess = {});

    /// Forgets the kept factor.
    void drop_caches();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
