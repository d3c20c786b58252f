// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/world_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace rhexis {

namespace {

Error bad(const std::string& where, const std::string& field, double value, const std::string& allowed) {
    return {field + " is " + short_number(value), where, allowed};
}

constexpr double farthest = 1e7;  ///< from the origin: a tenth of where bodies still were what they are near it [mm]

Status check_places(const std::string& where, const std::vector<Vec3>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const double coordinate : nodes[i]) {
            if (!(std::abs(coordinate) <= farthest)) {
                return bad(where, "a coordinate of node " + std::to_string(i), coordinate, "-1e7 to 1e7 mm");
            }
        }
    }
    return success();
}

Status check_material(const std::string& where, const Material& material) {
    const std::string place = where + ", material " + material.name;
    if (!(material.young_modulus > 0.0 && material.young_modulus <= 1e9)) {
        return bad(place, "young_modulus", material.young_modulus, "above 0, to 1e9 Pa");
    }
    if (!(material.poisson_ratio >= 0.0 && material.poisson_ratio <= 0.499)) {
        return bad(place, "poisson_ratio", material.poisson_ratio, "0 to 0.499");
    }
    if (!(material.density > 0.0 && material.density <= 1.0)) {
        return bad(place, "density", material.density, "above 0 to 1 g/mm^3");
    }
    if (!(material.ablation_energy >= 0.0 && material.ablation_energy <= 1e9)) {
        return bad(place, "ablation_energy", material.ablation_energy, "0 to 1e9 mJ/mm^3");
    }
    return success();
}

Status check_tet(const std::string& where, const SolidModel& solid, std::size_t t) {
    const std::string name = "tetrahedron " + std::to_string(t);
    const int nodes = static_cast<int>(solid.coarse.nodes.size());
    for (int node : solid.coarse.tets[t]) {
        if (node < 0 || node >= nodes) {
            return Error{name + " uses node " + std::to_string(node), where, "0 to " + std::to_string(nodes - 1)};
        }
    }
    const int region = solid.coarse.region[t];
    if (region < 0 || region >= static_cast<int>(solid.materials.size())) {
        return Error{name + " is of region " + std::to_string(region), where,
                     "0 to " + std::to_string(solid.materials.size() - 1)};
    }
    const std::array<int, 4>& tet = solid.coarse.tets[t];
    const std::vector<Vec3>& x = solid.coarse.nodes;
    const double volume = tet_volume(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]);
    if (!(volume > 0.0)) {
        return bad(where, name + ": volume", volume, "above 0 mm^3");
    }
    return success();
}

Status check_solid(const SolidModel& solid) {
    const std::string where = "solid " + solid.name;
    if (solid.coarse.region.size() != solid.coarse.tets.size()) {
        return Error{std::to_string(solid.coarse.region.size()) + " regions for " +
                         std::to_string(solid.coarse.tets.size()) + " tetrahedra",
                     where, "one each"};
    }
    if (!solid.fine.tets.empty() && solid.fine.tets.size() != 8 * solid.coarse.tets.size()) {
        return Error{std::to_string(solid.fine.tets.size()) + " fine tetrahedra", where, "8 per coarse one, or none"};
    }
    if (Status status = check_places(where, solid.coarse.nodes); !status) {
        return status;
    }
    for (const Material& material : solid.materials) {
        if (Status status = check_material(where, material); !status) {
            return status;
        }
    }
    for (std::size_t t = 0; t < solid.coarse.tets.size(); ++t) {
        if (Status status = check_tet(where, solid, t); !status) {
            return status;
        }
    }
    for (int node : solid.fixed_nodes) {
        if (node < 0 || node >= static_cast<int>(solid.coarse.nodes.size())) {
            return bad(where, "fixed node", node, "0 to " + std::to_string(solid.coarse.nodes.size() - 1));
        }
    }
    if (!(solid.damping_mass >= 0.0 && solid.damping_stiffness >= 0.0)) {
        return bad(where, "damping", std::min(solid.damping_mass, solid.damping_stiffness), "0 or more");
    }
    if (!(solid.stiffness_floor > 0.0 && solid.stiffness_floor <= 1.0)) {
        return bad(where, "stiffness_floor", solid.stiffness_floor, "above 0 to 1");
    }
    return success();
}

Status check_tool(const ToolModel& tool) {
    const std::string where = "tool " + tool.name;
    for (const RoundedCone& part : tool.parts) {
        if (!(part.radius_a > 0.0 && part.radius_b > 0.0 && part.a.allFinite() && part.b.allFinite())) {
            return bad(where, "radius of a part", std::min(part.radius_a, part.radius_b), "above 0 mm");
        }
    }
    if (!(tool.friction >= 0.0 && tool.friction <= 10.0)) {
        return bad(where, "friction", tool.friction, "0 to 10");
    }
    if (!(tool.max_power >= 0.0)) {
        return bad(where, "max_power", tool.max_power, "0 mW or more");
    }
    return success();
}

Status check_bag(const BagModel& bag, std::size_t i) {
    const std::string where = "bag " + std::to_string(i);
    if (!(bag.shape.radius > 0.0 && bag.shape.anterior > 0.0 && bag.shape.posterior > 0.0)) {
        return bad(where, "smallest semi-axis", std::min({bag.shape.radius, bag.shape.anterior, bag.shape.posterior}),
                   "above 0 mm");
    }
    if (!(bag.mass > 0.0)) {
        return bad(where, "mass", bag.mass, "above 0 g");
    }
    if (!(bag.damping >= 0.0 && bag.friction >= 0.0)) {
        return bad(where, "damping or friction", std::min(bag.damping, bag.friction), "0 or more");
    }
    return success();
}

}  // namespace

Status check_world(const WorldModel& model, const PhysicsSettings& settings) {
    if (settings.threads < 1 || settings.threads > 64) {
        return bad("physics", "threads", settings.threads, "1 to 64");
    }
    for (const SolidModel& solid : model.solids) {
        if (Status status = check_solid(solid); !status) {
            return status;
        }
    }
    for (const MembraneModel& membrane : model.membranes) {
        if (Status status = check_membrane(membrane); !status) {
            return status;
        }
        if (Status status = check_places("membrane " + membrane.name, membrane.sheet->mesh.nodes); !status) {
            return status;
        }
    }
    for (const ShellModel& shell : model.shells) {
        if (Status status = check_shell(shell); !status) {
            return status;
        }
    }
    for (const ToolModel& tool : model.tools) {
        if (Status status = check_tool(tool); !status) {
            return status;
        }
    }
    for (std::size_t i = 0; i < model.bags.size(); ++i) {
        if (Status status = check_bag(model.bags[i], i); !status) {
            return status;
        }
    }
    if (!model.bags.empty() && model.solids.size() > 1) {
        return Error{std::to_string(model.solids.size()) + " solids beside a bag", "world", "one solid in a bag"};
    }
    for (const PlaneModel& plane : model.planes) {
        if (!(std::abs(plane.normal.norm() - 1.0) < 1e-9)) {
            return bad("plane", "length of the normal", plane.normal.norm(), "1");
        }
    }
    return success();
}

}  // namespace rhexis
