// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/warped_contact.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "math/rotation.hpp"
#include "physics/shell/shell_body.hpp"
#include "physics/shell/shell_pose.hpp"
#include "physics/shell/shell_stepper.hpp"

namespace rhexis::bench {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Sparse>;

constexpr int level = 1;           // of samples, as the kernel takes them for a plane
constexpr int most_sweeps = 500;   // of Gauss-Seidel
constexpr double settled = 1e-10;  // change of an impulse in a sweep, of the largest

Eigen::Index row3(int row) { return 3 * static_cast<Eigen::Index>(row); }

}  // namespace

struct WarpedContact::Parts {
    Parts(const ShellModel& shell, double step, double most_error)
        : model(shell),
          dt(step),
          gate(most_error),
          stepper(std::move(ShellStepper::create(shell)).value()),
          body(shell, *shell_kernel::choose("")),
          samples(shell_samples(shell, level)) {
        free.assign(6 * model.mesh.nodes.size(), 1);
        for (const ShellHold& hold : model.holds) {
            for (std::size_t i = 0; i < 6; ++i) {
                free[6 * at(hold.node) + i] = hold.held[i] ? 0 : 1;
            }
        }
        const ShellState rest = rest_state(model);
        rest_factor.compute(matrix_at(rest, rest_points(rest)));
    }

    [[nodiscard]] static std::vector<Vec3> rest_points(const ShellState& state) {
        std::vector<Vec3> points(2 * state.position.size(), Vec3::Zero());
        for (std::size_t n = 0; n < state.position.size(); ++n) {
            points[2 * n] = state.position[n];
        }
        return points;
    }

    /// A at points, turns since the state's rotations.
    Sparse matrix_at(const ShellState& state, const std::vector<Vec3>& points) {
        body.set_reference(state.rotation);
        std::vector<double> x(3 * points.size() + 1, 0.0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            Eigen::Map<Vec3>(x.data() + 3 * at(body.row_of()[i])) = points[i];
        }
        std::vector<double> force;
        BlockValues values = zero_values(body.pattern());
        body.forces_and_stiffness(x, elastic_kernel::Mode::projected, dt * dt, force, values);
        std::vector<Eigen::Triplet<double>> entries;
        const BlockPattern& pattern = body.pattern();
        for (int i = 0; i < pattern.rows(); ++i) {
            for (int slot = pattern.diagonal[at(i)]; slot < pattern.first[at(i) + 1]; ++slot) {
                const Mat3 block = block_of(values, slot);
                for (int c = 0; c < 3; ++c) {
                    for (int r = 0; r < 3; ++r) {
                        const Eigen::Index row = row3(i) + r;
                        const Eigen::Index column = row3(pattern.column[at(slot)]) + c;
                        if (column > row) {
                            entries.emplace_back(column, row, block(r, c));
                        } else if (column == row) {
                            entries.emplace_back(row, row, block(r, c) + diagonal(i, r));
                        }
                    }
                }
            }
        }
        Sparse matrix(3 * pattern.rows(), 3 * pattern.rows());
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    /// Of a held freedom anything but zero.
    [[nodiscard]] double diagonal(int row, int number) const {
        const double mass = body.mass().inertia[at(row)];
        return body.free()[3 * at(row) + at(number)] == 0 ? 1.0 : (1.0 + dt * model.damping_mass) * mass;
    }

    /// Samples below the plane in a state, and how their gaps follow the rows.
    void find(const PlaneModel& plane, const ShellState& state, const std::vector<Vec3>& points) {
        pose.set(state.rotation, points);
        gaps.clear();
        std::vector<Eigen::Triplet<double>> entries;
        for (const ShellSamples::Sample& sample : samples.samples) {
            const double gap = plane.normal.dot(pose.at(sample.place) - plane.point) - 0.5 * sample.place.thickness;
            if (gap >= 0.0) {
                continue;
            }
            std::vector<ContactShare> shares;
            pose.add_shares(sample.place, -0.5 * sample.place.thickness * plane.normal, false, 1.0, free, shares);
            for (const ContactShare& share : shares) {
                const Vec3 own = share.share.transpose() * plane.normal;
                for (int k = 0; k < 3; ++k) {
                    entries.emplace_back(row3(body.row_of()[at(share.node)]) + k,
                                         static_cast<Eigen::Index>(gaps.size()), own[k]);
                }
            }
            gaps.push_back(gap);
        }
        normals.resize(3 * body.rows(), static_cast<Eigen::Index>(gaps.size()));
        normals.setFromTriplets(entries.begin(), entries.end());
    }

    /// Turned with the nodes, or back.
    [[nodiscard]] MatX turned_rows(const MatX& rows, bool back) const {
        MatX result = rows;
        for (int i = 0; i < body.rows(); ++i) {
            const Mat3& turn = turns[at(body.node_of()[at(i)]) / 2];
            result.middleRows<3>(row3(i)) = (back ? Mat3(turn.transpose()) : turn) * rows.middleRows<3>(row3(i));
        }
        return result;
    }

    /// Impulses that undo what sank in; velocities change by `change`. columns: C H'.
    void impulses(const MatX& columns) {
        const Eigen::Index count = normals.cols();
        const MatX delassus = normals.transpose() * columns;
        impulse = VecX::Zero(count);
        VecX rate = Eigen::Map<const VecX>(gaps.data(), count) / dt;
        for (int sweep = 0; sweep < most_sweeps; ++sweep) {
            double moved = 0.0;
            for (Eigen::Index i = 0; i < count; ++i) {
                const double now = std::max(0.0, impulse[i] - rate[i] / delassus(i, i));
                rate += (now - impulse[i]) * delassus.col(i);
                moved = std::max(moved, std::abs(now - impulse[i]));
                impulse[i] = now;
            }
            if (moved <= settled * impulse.maxCoeff()) {
                break;
            }
        }
        change = columns * impulse;
    }

    const ShellModel& model;
    double dt;
    double gate;
    ShellStepper stepper;
    ShellBody body;
    ShellSamples samples;
    ShellPose pose;
    std::vector<std::uint8_t> free;  ///< by nodes
    Factor rest_factor;
    std::vector<Mat3> turns;   ///< of nodes since rest, after the step without contact
    std::vector<double> gaps;  ///< [mm]
    Sparse normals;            ///< H', a column per contact
    VecX impulse;              ///< [uN s]
    VecX change;
    double error = 0.0;
    double deepest = 0.0;
    int factors = 0;
};

WarpedContact::WarpedContact(const ShellModel& model, double dt, double gate)
    : parts_(std::make_unique<Parts>(model, dt, gate)) {}
WarpedContact::~WarpedContact() = default;

void WarpedContact::step(const PlaneModel& plane, const ImplicitSettings& settings, ShellState& state) {
    Parts& p = *parts_;
    ShellState free;
    p.stepper.step(state, {}, Vec3::Zero(), p.dt, settings, free);
    std::vector<Vec3> points(2 * state.position.size());
    p.turns.resize(state.position.size());
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        points[2 * n] = free.position[n];
        points[2 * n + 1] = p.dt * free.spin[n];
        p.turns[n] = free.rotation[n].toRotationMatrix();
    }
    p.find(plane, state, points);
    p.error = 0.0;
    if (p.gaps.empty()) {
        p.impulse.resize(0);
        state = std::move(free);
        return;
    }
    const MatX pull = p.normals;
    const Sparse matrix = p.matrix_at(state, points);
    p.impulses(p.turned_rows(p.rest_factor.solve(p.turned_rows(pull, true)), false));
    const VecX wanted = pull * p.impulse;
    p.error = (matrix.selfadjointView<Eigen::Lower>() * p.change - wanted).norm() / wanted.norm();
    if (p.error > p.gate) {
        const Factor factor(matrix);
        ++p.factors;
        p.impulses(factor.solve(pull));
        p.error = 0.0;
    }
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        const Vec3 moved = p.change.segment<3>(row3(p.body.row_of()[2 * n]));
        const Vec3 spun = p.change.segment<3>(row3(p.body.row_of()[2 * n + 1]));
        points[2 * n] += p.dt * moved;
        points[2 * n + 1] += p.dt * spun;
        free.position[n] = points[2 * n];
        free.velocity[n] += moved;
        free.spin[n] += spun;
        free.rotation[n] = turned(state.rotation[n], points[2 * n + 1]);
    }
    p.pose.set(state.rotation, points);
    p.deepest = 0.0;
    for (const ShellSamples::Sample& sample : p.samples.samples) {
        const double gap = plane.normal.dot(p.pose.at(sample.place) - plane.point) - 0.5 * sample.place.thickness;
        p.deepest = std::max(p.deepest, -gap / sample.place.thickness);
    }
    state = std::move(free);
}

double WarpedContact::force() const { return parts_->impulse.sum() / parts_->dt; }
double WarpedContact::error() const { return parts_->error; }
double WarpedContact::deepest() const { return parts_->deepest; }
int WarpedContact::contacts() const { return static_cast<int>(parts_->gaps.size()); }
int WarpedContact::touching() const { return static_cast<int>((parts_->impulse.array() > 0.0).count()); }
int WarpedContact::factors() const { return parts_->factors; }

}  // namespace rhexis::bench
