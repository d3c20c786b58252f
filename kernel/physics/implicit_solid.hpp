// SPDX-License-Identifier: GPL-3.0-or-later
// Backward Euler of one corotational solid, together with the rigid bodies that it touches.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "base/threads.hpp"
#include "flow/solid.hpp"
#include "physics/contact_term.hpp"

namespace rhexis {

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// A rigid partner that moves with the solid's solve (the bag).
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

/// Evaluates contact and rigid forces at an iterate of positions (coarse nodes) and rigid poses.
using CouplingFunction = std::function<void(const std::vector<Vec3>& position, std::span<const RigidUnknown> bodies,
                                            std::vector<ContactTerm>& contacts, std::vector<RigidTerm>& rigid)>;

struct ImplicitSettings {
    double tolerance = 1e-6;         ///< relative residual of each linear solve
    int max_newton = 4;              ///< 1: one linearised step, as in the paper
    double newton_tolerance = 1e-4;  ///< relative residual of the step at which Newton stops
    double force_tolerance = 0.0;    ///< residual force at which it stops, whatever the relative residual [uN]
    int max_linear_iterations = 1000;
};

struct ImplicitReport {
    int newton_iterations = 0;
    int linear_iterations = 0;
    double residual = 0.0;         ///< relative, of the last linear solve
    double newton_residual = 0.0;  ///< relative, of the step
    double force = 0.0;            ///< norm of the forces that do not balance at the end of the step [uN]
    bool converged = false;
    bool factored = false;  ///< a new factor was made in this step
};

class ImplicitSolid {
public:
    /// model and pool must outlive this. instruction_set: "" for the best of this machine, or "baseline", "avx2",
    /// "avx512": same bits, other speed. Fails on one that the machine lacks.
    static Result<ImplicitSolid> create(const SolidModel& model, ThreadPool& pool,
                                        std::string_view instruction_set = {});
    ~ImplicitSolid();
    ImplicitSolid(ImplicitSolid&&) noexcept;
    ImplicitSolid& operator=(ImplicitSolid&&) noexcept;

    /// One step of dt [s]. external: force per coarse node without gravity [uN]; gravity [mm/s^2] is applied inside.
    /// bodies: at the start of the step on entry, at its end on return.
    ImplicitReport step(const SolidState& state, const Vec3& gravity, std::span<const Vec3> external, double dt,
                        const ImplicitSettings& settings, const CouplingFunction& coupling,
                        std::vector<RigidUnknown>& bodies, SolidState& next);

    /// Forgets the kept factor.
    void drop_caches();

private:
    struct Parts;
    explicit ImplicitSolid(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
