// SPDX-License-Identifier: GPL-3.0-or-later
// Symplectic Euler of one corotational solid in float lanes of 16, the same bits for every instruction set.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "flow/solid.hpp"
#include "physics/solid/explicit_groups.hpp"

namespace rhexis {

class ExplicitSolid {
public:
    /// How tetrahedra go into lanes. Splitting nodes leaves it good: those that shared none share none.
    static LaneAssignment assign(const TetMesh& mesh);

    /// The model must outlive the solid. instruction_set: "" for the best of this machine, or "baseline", "avx2",
    /// "avx512"; same bits, other speed. assigned: of the mesh before nodes were split, so that bits do not depend on
    /// when the solid was made; nothing is loaded then. Null: of this mesh, and its state of rest is loaded.
    static Result<ExplicitSolid> create(const SolidModel& model, std::string_view instruction_set,
                                        const LaneAssignment* assigned = nullptr);
    ~ExplicitSolid();
    ExplicitSolid(ExplicitSolid&&) noexcept;

    /// Takes positions, velocities, fractions and masks from a state.
    void load(const SolidState& state);
    /// Writes positions and velocities back.
    void store(SolidState& state) const;

    /// Largest stable step of the loaded state [s] (power iteration, cached until elements change), before any safety
    /// factor.
    double stable_step();

    /// v += dt * M^-1 (internal + damping + gravity + external). external: per coarse node [uN], or empty.
    void predict(double dt, const Vec3& gravity, std::span<const Vec3> external);
    /// x += dt * v, positions accumulated in double.
    void move(double dt);

    /// Between predict and move the contact resolver reads positions and changes velocities. Valid until the next load.
    struct Rows {
        const double* position = nullptr;      ///< 4 per node, the last unused [mm]
        double* velocity = nullptr;            ///< 4 per node, the last 0 [mm/s]
        const double* inverse_mass = nullptr;  ///< per node [1/g]; 0: fixed or without elements, cannot be pushed
        int count = 0;                         ///< of nodes
    };
    [[nodiscard]] Rows rows();
    [[nodiscard]] Vec3 position(int node) const;
    [[nodiscard]] Vec3 velocity(int node) const;
    void set_velocity(int node, const Vec3& velocity);
    [[nodiscard]] double mass(int node) const;  ///< [g]; 0: fixed or without elements

    [[nodiscard]] bool finite() const;
    [[nodiscard]] std::string_view instruction_set() const;

private:
    struct Parts;
    explicit ExplicitSolid(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
