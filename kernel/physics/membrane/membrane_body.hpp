// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: mass, elastic forces and stiffness of a membrane, by rows: the nodes in the order of elimination.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "energy/membrane_triangle.hpp"
#include "flow/membrane.hpp"
#include "physics/membrane/membrane_kernel.hpp"
#include "physics/solve/elastic_body.hpp"

namespace rhexis {

/// A triangle of a sheet, ready for forces, in its plane frame at rest.
MembraneTriangle membrane_triangle(const MembraneModel& model, const MembraneSheet& sheet, int triangle,
                                   const PlaneFrame& frame);
PlaneFrame frame_of(const TriMesh& mesh, int triangle);
std::vector<MembraneTriangle> membrane_triangles(const MembraneModel& model, const MembraneSheet& sheet);

/// Where its corners are now.
TrianglePoints points_now(const MembraneState& state, int triangle);

/// Elastic energy of a state, springs left out [nJ].
double elastic_energy(const MembraneModel& model, const MembraneState& state);
/// Elastic force of the sheet on some of its nodes, summed: what holds them feels it [uN].
Vec3 elastic_force(const MembraneModel& model, const MembraneState& state, const std::vector<int>& nodes);

class MembraneBody final : public ElasticBody {
public:
    /// The model must outlive this; the sheet is kept alive.
    MembraneBody(const MembraneModel& model, std::shared_ptr<const MembraneSheet> sheet,
                 const membrane_kernel::Kernel& kernel = *membrane_kernel::choose({}));

    /// Takes over another sheet of the model. keep_order: if it came from the one before by tears, the order of
    /// elimination is kept as long as that pays, with the nodes that are new behind such as have their neighbours.
    /// Where the rows before are now, ascending; or nothing, if the order is new.
    std::vector<int> follow(std::shared_ptr<const MembraneSheet> sheet, bool keep_order);

    [[nodiscard]] const std::shared_ptr<const MembraneSheet>& sheet() const { return sheet_; }

    /// Where the support is from now on, along z from where it rests [mm]: springs on it go with it.
    void follow_support(double lift) { lift_ = lift; }
    /// Of those springs, along z; position: by nodes [uN].
    [[nodiscard]] double springs_on_support(const std::vector<Vec3>& position) const;

    void forces(const std::vector<double>& position, std::vector<double>& force) override;
    void forces_and_stiffness(const std::vector<double>& position, elastic_kernel::Mode mode, double scale,
                              std::vector<double>& force, BlockValues& stiffness) override;

private:
    void make();
    [[nodiscard]] std::vector<int> changed_triangles(const MembraneSheet& now) const;
    [[nodiscard]] bool ties_known(const TriMesh& mesh, const std::vector<int>& changed) const;
    std::optional<std::vector<int>> grow(const std::shared_ptr<const MembraneSheet>& sheet);
    void renumber(const std::vector<std::uint8_t>& touched, const std::vector<int>& row_now);
    void find_moving();
    void hang();
    void lay_out_lanes(std::size_t known);
    [[nodiscard]] std::array<std::size_t, 3> by_rows(std::size_t triangle) const;
    void pack(std::size_t t);
    static void pack_numbers(const MembraneTriangle& triangle, const std::array<std::size_t, 3>& order, double* to);
    [[nodiscard]] int slot_right_of_diagonal(int row, int column) const;
    void pack_places(const std::array<int, 3>& rows, int* to) const;
    void weigh();
    membrane_kernel::Task task(const std::vector<double>& position, std::vector<double>& force) const;

    const MembraneModel* model_;
    std::shared_ptr<const MembraneSheet> sheet_;
    const membrane_kernel::Kernel* kernel_;
    std::vector<NodeSpring> springs_;  ///< of rows
    double lift_ = 0.0;                ///< of the support [mm]
    int ordered_rows_ = 0;             ///< when the order of elimination was made
    std::vector<MembraneTriangle> triangles_;
    // as the kernel reads them; corners by ascending row
    int groups_ = 0;
    std::vector<double> data_;
    std::vector<int> index_;
};

}  // namespace rhexis
