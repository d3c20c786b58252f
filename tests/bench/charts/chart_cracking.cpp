// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/rng.hpp"
#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "bench/timing.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/shapes.hpp"
#include "physics/solid/crack.hpp"

namespace rhexis::bench {
namespace {

constexpr double lens_cell = 0.5;    ///< edges as those of a lens of 3,000 tetrahedra [mm]
constexpr double arm_length = 12.0;  ///< of both arms with what holds them together, along x [mm]
constexpr double arm_height = 2.0;   ///< of one, along z [mm]: both are as high as a lens
constexpr std::array<double, 3> crack_lengths{4.0, 5.0, 6.0};  ///< [mm]
constexpr double arm_modulus = 5000.0;                         ///< [Pa]
constexpr double arm_poisson_ratio = 0.47;                     ///< the lens's
constexpr double arm_pull = 1e-3;  ///< on each arm, per width [uN/mm]: so small that everything is linear
constexpr double plane_strain_modulus = arm_modulus / (1.0 - arm_poisson_ratio * arm_poisson_ratio);

/// Energy that a crack of this length frees, for arms pulled apart at their ends [Wiederhorn1968].
double energy_freed(double crack) {
    const double intensity = arm_pull * crack / std::pow(arm_height, 1.5) * (3.467 + 2.315 * arm_height / crack);
    return intensity * intensity / plane_strain_modulus;
}

/// Of a mesh of linear tetrahedra, by coordinate.
using ArmMatrix = Eigen::SparseMatrix<double>;

/// A double cantilever, one cell wide, held so that its sides stay plane; nodes of the crack are there twice.
class DoubleCantilever {
public:
    DoubleCantilever(double cell, double crack, double askew) : cell_(cell), crack_(crack) {
        model_.coarse = bar(static_cast<int>(std::lround(arm_length / cell)), 1,
                            static_cast<int>(std::lround(2.0 * arm_height / cell)), cell);
        find_broken();
        cut_open();
        disarrange(askew);
        model_.fine = subdivide(model_.coarse);
        Material material;
        material.young_modulus = arm_modulus;
        material.poisson_ratio = arm_poisson_ratio;
        material.toughness = 1.0;
        model_.materials = {material};
        model_.formulation = Formulation::nodal_pressure;
        for (const std::array<int, 4>& tet : model_.coarse.tets) {
            TetPoints points;
            for (std::size_t k = 0; k < 4; ++k) {
                points[k] = model_.coarse.nodes[tet[k]];
            }
            rest_.push_back(rest_tet(points));
        }
        state_ = rest_state(model_);
        state_.broken = broken_;
        solve();
        finder_ = std::make_shared<CrackFinder>(model_);
        surface_ = std::make_shared<ContactSurface>(model_);
        surface_->update(model_, state_);
    }

    [[nodiscard]] const SolidModel& model() const { return model_; }
    [[nodiscard]] const SolidState& state() const { return state_; }
    [[nodiscard]] double cell() const { return cell_; }
    [[nodiscard]] Vec3 tip() const { return {crack_, 0.5 * cell_, arm_height}; }

    [[nodiscard]] Vec3 shift(int node) const { return state_.position[node] - model_.coarse.nodes[node]; }

    /// Gradient of displacement.
    [[nodiscard]] Mat3 gradient(std::size_t tet) const {
        Mat3 found = Mat3::Zero();
        for (std::size_t k = 0; k < 4; ++k) {
            found += shift(model_.coarse.tets[tet][k]) * rest_[tet].gradient[k].transpose();
        }
        return found;
    }

    /// Changes of volume, averaged as the lens's elements do.
    [[nodiscard]] std::vector<double> swelling() const {
        const std::vector<std::array<int, 4>>& tets = model_.coarse.tets;
        std::vector<double> sum(model_.coarse.nodes.size(), 0.0);
        std::vector<double> volume(sum.size(), 0.0);
        for (std::size_t t = 0; t < tets.size(); ++t) {
            const double trace = gradient(t).trace();
            for (const int node : tets[t]) {
                sum[node] += rest_[t].volume * trace;
                volume[node] += rest_[t].volume;
            }
        }
        std::vector<double> mean(tets.size(), 0.0);
        for (std::size_t t = 0; t < tets.size(); ++t) {
            for (const int node : tets[t]) {
                mean[t] += 0.25 * sum[node] / volume[node];
            }
        }
        return mean;
    }

    /// Of a tetrahedron whose change of volume is averaged.
    [[nodiscard]] static Mat3 stress(const Mat3& gradient, double swelling) {
        const Lame material = lame(arm_modulus, arm_poisson_ratio);
        const Mat3 strain = 0.5 * (gradient + gradient.transpose());
        const double bulk = material.lambda + 2.0 / 3.0 * material.mu;
        return 2.0 * material.mu * (strain - strain.trace() / 3.0 * Mat3::Identity()) +
               bulk * swelling * Mat3::Identity();
    }

    [[nodiscard]] const std::vector<RestTet>& rest() const { return rest_; }

    /// The kernel's look: greatest of the faces at the tip; in_plane: only those in the plane of the crack.
    [[nodiscard]] double energy_by_kernel(bool in_plane) const {
        finder_->look(model_, state_, *surface_, {}, 0);
        double most = 0.0;
        for (std::size_t f = 0; f < finder_->faces().size(); ++f) {
            const CrackFace& face = finder_->faces()[f];
            Vec3 centre = Vec3::Zero();
            for (const int node : face.nodes) {
                centre += model_.coarse.nodes[node] / 3.0;
            }
            const bool lies_in_plane = std::abs(face.normal.z()) > 0.99 && std::abs(centre.z() - arm_height) < 1e-9;
            if ((centre - tip()).norm() < 1.6 * cell_ && (lies_in_plane || !in_plane)) {
                most = std::max(most, finder_->ratios()[f]);
            }
        }
        return most;
    }

private:
    [[nodiscard]] Vec3 centre(int tet) const {
        Vec3 sum = Vec3::Zero();
        for (const int node : model_.coarse.tets[tet]) {
            sum += 0.25 * model_.coarse.nodes[node];
        }
        return sum;
    }
    [[nodiscard]] bool above(int tet) const { return centre(tet).z() > arm_height; }

    void find_broken() {
        const std::vector<std::array<int, 4>> neighbours = face_neighbours(model_.coarse.tets);
        for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
            for (const int other : neighbours[t]) {
                if (other > t && above(t) != above(other) && centre(t).x() < crack_) {
                    broken_.push_back({t, other});
                }
            }
        }
        std::sort(broken_.begin(), broken_.end());
    }

    /// Tetrahedra above the crack get nodes of their own.
    void cut_open() {
        TetMesh& mesh = model_.coarse;
        std::vector<int> twin(mesh.nodes.size(), -1);
        for (int node = 0; node < static_cast<int>(twin.size()); ++node) {
            const Vec3 place = mesh.nodes[node];
            if (std::abs(place.z() - arm_height) < 1e-9 && place.x() < crack_ - 1e-9) {
                twin[node] = static_cast<int>(mesh.nodes.size());
                mesh.nodes.push_back(place);
            }
        }
        for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
            if (!above(t)) {
                continue;
            }
            for (int& node : mesh.tets[t]) {
                node = node < static_cast<int>(twin.size()) && twin[node] >= 0 ? twin[node] : node;
            }
        }
    }

    /// Moves nodes inside at random, but none of the crack and its tip, so that no row of faces goes on from it.
    void disarrange(double share) {
        Rng rng(1, "askew cantilever");
        const auto off = [&] { return share * cell_ * (2.0 * rng.uniform() - 1.0); };
        for (Vec3& node : model_.coarse.nodes) {
            const bool inside = node.x() > 1e-9 && node.x() < arm_length - 1e-9 && node.z() > 1e-9 &&
                                node.z() < 2.0 * arm_height - 1e-9;
            const bool of_crack = std::abs(node.z() - arm_height) < 1e-9 && node.x() < crack_ + 1e-9;
            if (inside && !of_crack) {
                const double along = off();
                node += Vec3(along, 0.0, off());
            }
        }
    }

    /// Small strain, elements with pressure at nodes: shape by tetrahedron, volume by patch.
    [[nodiscard]] ArmMatrix stiffness() const {
        const Lame material = lame(arm_modulus, arm_poisson_ratio);
        const double bulk = material.lambda + 2.0 / 3.0 * material.mu;
        const Lame shape{-2.0 / 3.0 * material.mu, material.mu};
        const std::size_t nodes = model_.coarse.nodes.size();
        std::vector<Eigen::Triplet<double>> entries;
        std::vector<Eigen::Triplet<double>> patches;
        std::vector<double> volume(nodes, 0.0);
        for (std::size_t t = 0; t < rest_.size(); ++t) {
            const std::array<int, 4>& tet = model_.coarse.tets[t];
            TetPoints at;
            for (std::size_t k = 0; k < 4; ++k) {
                at[k] = model_.coarse.nodes[tet[k]];
                volume[tet[k]] += 0.25 * rest_[t].volume;
            }
            const Mat12 own = corotational_tet_hessian(rest_[t], shape, at, Tangent::warped);
            for (int i = 0; i < 12; ++i) {
                for (int j = 0; j < 12; ++j) {
                    entries.emplace_back(3 * tet[i / 3] + i % 3, 3 * tet[j / 3] + j % 3, own(i, j));
                }
                for (const int node : tet) {
                    patches.emplace_back(node, 3 * tet[i / 3] + i % 3,
                                         0.25 * rest_[t].volume * rest_[t].gradient[i / 3][i % 3]);
                }
            }
        }
        const int size = static_cast<int>(3 * nodes);
        ArmMatrix matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        ArmMatrix of_patches(static_cast<int>(nodes), size);
        of_patches.setFromTriplets(patches.begin(), patches.end());
        Eigen::VectorXd each(static_cast<int>(nodes));
        for (std::size_t n = 0; n < nodes; ++n) {
            each[static_cast<int>(n)] = bulk / volume[n];
        }
        return matrix + ArmMatrix(of_patches.transpose() * each.asDiagonal() * of_patches);
    }

    void solve() {
        const std::vector<Vec3>& nodes = model_.coarse.nodes;
        const int size = static_cast<int>(3 * nodes.size());
        Eigen::VectorXd load = Eigen::VectorXd::Zero(size);
        Eigen::VectorXd is_free = Eigen::VectorXd::Ones(size);
        for (int node = 0; node < static_cast<int>(nodes.size()); ++node) {
            const Vec3& place = nodes[node];
            is_free[3 * node + 1] = 0.0;
            if (place.x() > arm_length - 1e-9) {
                is_free[3 * node] = is_free[3 * node + 2] = 0.0;
            }
            const double off = place.z() - arm_height;
            if (place.x() < 1e-9 && std::abs(std::abs(off) - 0.5 * arm_height) < 1e-9) {
                load[3 * node + 2] = std::copysign(0.5 * cell_ * arm_pull, off);
            }
        }
        ArmMatrix matrix = is_free.asDiagonal() * stiffness() * is_free.asDiagonal();
        for (int i = 0; i < size; ++i) {
            matrix.coeffRef(i, i) += 1.0 - is_free[i];
        }
        const Eigen::SimplicialLDLT<ArmMatrix> factor(matrix);
        const Eigen::VectorXd found = factor.solve(load);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            state_.position[n] += found.segment<3>(static_cast<int>(3 * n));
        }
    }

    double cell_;
    double crack_;
    SolidModel model_;
    SolidState state_;
    std::vector<BrokenFace> broken_;
    std::vector<RestTet> rest_;
    std::shared_ptr<CrackFinder> finder_;
    std::shared_ptr<ContactSurface> surface_;
};

/// Nodes of the crack's plane at a distance behind its tip [mm].
std::vector<int> nodes_behind(const DoubleCantilever& arms, double behind) {
    std::vector<int> found;
    const std::vector<Vec3>& nodes = arms.model().coarse.nodes;
    for (int node = 0; node < static_cast<int>(nodes.size()); ++node) {
        if (std::abs(nodes[node].z() - arm_height) < 1e-9 &&
            std::abs(arms.tip().x() - behind - nodes[node].x()) < 1e-9) {
            found.push_back(node);
        }
    }
    return found;
}

/// How far the faces of the crack are apart there [mm].
double opening_behind(const DoubleCantilever& arms, double behind) {
    double low = 0.0;
    double high = 0.0;
    for (const int node : nodes_behind(arms, behind)) {
        low = std::min(low, arms.shift(node).z());
        high = std::max(high, arms.shift(node).z());
    }
    return high - low;
}

/// From how the faces stand open one cell behind the tip.
double energy_by_opening(const DoubleCantilever& arms) {
    const double intensity = plane_strain_modulus / 8.0 * std::sqrt(2.0 * std::numbers::pi / arms.cell()) *
                             opening_behind(arms, arms.cell());
    return intensity * intensity / plane_strain_modulus;
}

/// Virtual crack closure [Rybicki1977]: what the tip's nodes bear, times how far the faces stand open behind.
double energy_by_closure(const DoubleCantilever& arms) {
    const std::vector<int> tip = nodes_behind(arms, 0.0);
    const std::vector<double> swelling = arms.swelling();
    double force = 0.0;
    for (std::size_t t = 0; t < arms.rest().size(); ++t) {
        const std::array<int, 4>& tet = arms.model().coarse.tets[t];
        for (std::size_t k = 0; k < 4; ++k) {
            double height = 0.0;
            for (const int node : tet) {
                height += 0.25 * arms.model().coarse.nodes[node].z();
            }
            if (height > arm_height && std::find(tip.begin(), tip.end(), tet[k]) != tip.end()) {
                const Mat3 stress = DoubleCantilever::stress(arms.gradient(t), swelling[t]);
                force += arms.rest()[t].volume * (stress * arms.rest()[t].gradient[k]).z();
            }
        }
    }
    return 0.5 * std::abs(force) * opening_behind(arms, arms.cell()) / (arms.cell() * arms.cell());
}

/// What the tip's nodes would yield if they went on through the material [LiShihNeedleman1985]: over those within
/// reach.
double energy_by_pull(const DoubleCantilever& arms, double reach) {
    const std::vector<double> swelling = arms.swelling();
    double sum = 0.0;
    for (std::size_t t = 0; t < arms.rest().size(); ++t) {
        const Mat3 gradient = arms.gradient(t);
        const Mat3 stress = DoubleCantilever::stress(gradient, swelling[t]);
        const Mat3 even = (swelling[t] - gradient.trace()) / 3.0 * Mat3::Identity();
        const double density = 0.5 * stress.cwiseProduct(gradient + even).sum();
        const Vec3 flux = stress * gradient.col(0) - density * Vec3::UnitX();
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 off = arms.model().coarse.nodes[arms.model().coarse.tets[t][k]] - arms.tip();
            if (off.x() * off.x() + off.z() * off.z() < reach * reach) {
                sum += arms.rest()[t].volume * flux.dot(arms.rest()[t].gradient[k]);
            }
        }
    }
    return std::abs(sum) / arms.cell();
}

/// A way to tell the energy at the tip.
struct TipEnergy {
    std::string name;
    std::function<double(const DoubleCantilever&)> of;  ///< [uN/mm]
    bool is_default = false;
    bool on_any_mesh = false;
};

/// What a look at the cracks costs and finds.
TipEnergy by_kernel(const std::string& name, bool in_plane, bool is_default) {
    return {name, [in_plane](const DoubleCantilever& arms) { return arms.energy_by_kernel(in_plane); }, is_default,
            !in_plane};
}

std::vector<TipEnergy> tip_energies() {
    return {by_kernel("kernel: the first face that breaks at the tip", false, true),
            by_kernel("kernel: faces in the crack's plane", true, false),
            {"virtual crack closure", energy_by_closure},
            {"pull of the tip's nodes on the material",
             [](const DoubleCantilever& arms) { return energy_by_pull(arms, 1.1 * arms.cell()); }, false, true},
            {"opening behind the tip", energy_by_opening}};
}

void measure_cells(double cell, double askew, const ChartOptions& options, std::vector<ChartPoint>& points) {
    std::vector<DoubleCantilever> all;
    for (const double crack : crack_lengths) {
        all.emplace_back(cell, crack, askew);
    }
    char setting[24];
    std::snprintf(setting, sizeof setting, askew > 0.0 ? "%g mm askew" : "%g mm", cell);
    for (const TipEnergy& way : tip_energies()) {
        const bool is_default = way.is_default && cell == lens_cell && askew == 0.0;
        if ((options.only_default && !is_default) || (askew > 0.0 && !way.on_any_mesh)) {
            continue;
        }
        Curves forces(1);  // at which the crack goes on, as a share of that at which it should
        for (const DoubleCantilever& arms : all) {
            forces[0].push_back(std::sqrt(energy_freed(arms.tip().x()) / way.of(arms)));
        }
        points.push_back(point_of(way.name, setting, is_default,
                                  rms_share(forces[0], std::vector<double>(forces[0].size(), 1.0)),
                                  time_interleaved({[&] { way.of(all[0]); }}, options.repeats)[0].seconds));
    }
}

std::vector<ChartPoint> measure_cracking(const ChartOptions& options) {
    std::vector<ChartPoint> points;
    const std::vector<TipEnergy> ways = tip_energies();
    for (const double askew : {0.0, 0.2}) {
        for (const double cell : {1.0, 0.5, 0.25, 0.125}) {
            if (!options.only_default || (cell == lens_cell && askew == 0.0)) {
                measure_cells(cell, askew, options, points);
            }
        }
    }
    std::stable_sort(points.begin(), points.end(), [&](const ChartPoint& a, const ChartPoint& b) {
        const auto place = [&](const ChartPoint& point) {
            return std::find_if(ways.begin(), ways.end(), [&](const TipEnergy& way) { return way.name == point.way; });
        };
        return place(a) < place(b);
    });
    return points;
}

}  // namespace

Chart chart_cracking() {
    return {"cracking",
            "Force at which a crack in a double cantilever goes on, by the size of the cells",
            "CPU seconds for one look at the cracks",
            "force, rms over three lengths of crack",
            "a formula for its stress intensity, in plane strain [Wiederhorn1968]",
            true,
            measure_cracking};
}

}  // namespace rhexis::bench
