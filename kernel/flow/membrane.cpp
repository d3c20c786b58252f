// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/membrane.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/index.hpp"
#include "base/numbers.hpp"
#include "base/ranges.hpp"

namespace rhexis {
namespace {

Status check_sheet(const MembraneModel& model, UnusedNodes unused) {
    const MembraneSheet& sheet = *model.sheet;
    if (Status status = validate_tri_mesh(sheet.mesh, model.name, unused); !status) {
        return status;
    }
    const std::size_t count = sheet.mesh.triangles.size();
    if (sheet.fibre.size() != count || sheet.thickness.size() != count || sheet.stiffness.size() != count) {
        return Error{"fibre, thickness and stiffness must have one entry per triangle", model.name,
                     std::to_string(count)};
    }
    const int nodes = static_cast<int>(sheet.mesh.nodes.size());
    if (sheet.origin.size() != at(nodes) ||
        std::any_of(sheet.origin.begin(), sheet.origin.end(), [&](int node) { return node < -1 || node >= nodes; })) {
        return Error{"origin must name a node per node, or -1", model.name, "-1 to " + std::to_string(nodes - 1)};
    }
    for (std::size_t t = 0; t < count; ++t) {
        const std::string of = " of triangle " + std::to_string(t);
        const Vec3& fibre = sheet.fibre[t];
        if (!(std::abs(fibre.norm() - 1.0) < 1e-6) ||
            !(std::abs(fibre.dot(front_of(sheet.mesh, static_cast<int>(t)))) < 1e-6)) {
            return Error{"fibre" + of + " is no unit vector in its plane", model.name,
                         "a direction that is not zero and not at a right angle to the sheet"};
        }
        if (Status s = check_range("thickness" + of, sheet.thickness[t], 1e-5, 10.0, model.name, " mm"); !s) {
            return s;
        }
        if (Status s = check_range("stiffness" + of, sheet.stiffness[t], 1e-6, 1e6, model.name); !s) {
            return s;
        }
    }
    return success();
}

Status check_numbers(const MembraneModel& model) {
    return check_ranges({{"density", model.density, 1e-7, 1.0, " g/mm^3"},
                         {"toughness along the fibres", model.toughness.along, 1e-3, 1e12, " uN/mm"},
                         {"toughness across the fibres", model.toughness.across, 1e-3, 1e12, " uN/mm"},
                         {"tear_radius", model.tear_radius, 1e-4, 100.0, " mm"},
                         {"piercing", model.piercing, 1e-3, 1e15, " uN/mm"},
                         {"turn_cosine", model.turn_cosine, -1.0, 1.0, ""},
                         {"damping_mass", model.damping_mass, 0.0, 1e8, " 1/s"},
                         {"damping_stiffness", model.damping_stiffness, 0.0, 10.0, " s"},
                         {"slack_share", model.slack_share, 1e-9, 1.0, ""},
                         // only on a support is it known which layer lies on which
                         {"layer_distance", model.layer_distance, 0.0, model.support ? 0.1 : 0.0, " mm"},
                         {"shell_friction", model.shell_friction, 0.0, 10.0, ""},
                         {"rupture_stretch", model.rupture_stretch > 0.0 ? model.rupture_stretch : 1.01, 1.01, 100.0,
                          ", or 0 for none"}},
                        model.name);
}

Status check_holds(const MembraneModel& model) {
    const int nodes = static_cast<int>(model.sheet->mesh.nodes.size());
    const auto known = [&](int node, const char* what) -> Status {
        if (node < 0 || node >= nodes) {
            return Error{std::string(what) + " names node " + std::to_string(node), model.name,
                         "0 to " + std::to_string(nodes - 1)};
        }
        return success();
    };
    for (const int node : model.fixed_nodes) {
        if (Status s = known(node, "fixed_nodes"); !s) {
            return s;
        }
    }
    if (!std::is_sorted(model.fixed_nodes.begin(), model.fixed_nodes.end())) {
        return Error{"fixed_nodes are out of order", model.name, "ascending numbers"};
    }
    for (const NodeSpring& spring : model.springs) {
        if (Status s = known(spring.node, "a spring"); !s) {
            return s;
        }
        if (Status s = check_range("stiffness of a spring", spring.stiffness, 0.0, 1e9, model.name, " uN/mm"); !s) {
            return s;
        }
        if (!spring.anchor.allFinite() || !(spring.slack >= 0.0)) {
            return Error{"a spring's anchor or slack is no number", model.name, "finite numbers, slack >= 0"};
        }
        if (spring.on_support && !model.support) {
            return Error{"a spring hangs on a support that there is not", model.name, "on_support where one is"};
        }
    }
    return success();
}

Status check_support(const MembraneModel& model) {
    if (!model.support) {
        return success();
    }
    const SupportModel& support = *model.support;
    if (Status s = check_range("friction of the support", support.friction, 0.0, 2.0, model.name); !s) {
        return s;
    }
    if (Status s = check_range("stiffness of the support", support.stiffness, 0.0, 1e9, model.name, " uN/mm"); !s) {
        return s;
    }
    const double least = support.stiffness > 0.0 ? 1e-6 : 0.0;
    return check_range("damping of the support", support.damping, least, 1e9, model.name, " uN s/mm");
}

}  // namespace

Vec3 front_of(const TriMesh& mesh, int triangle) {
    const std::array<int, 3>& n = mesh.triangles[at(triangle)];
    const Vec3& a = mesh.nodes[at(n[0])];
    return (mesh.nodes[at(n[1])] - a).cross(mesh.nodes[at(n[2])] - a).normalized();
}

bool folded(const MembraneState& state, int triangle) {
    const std::array<int, 3>& n = state.sheet->mesh.triangles[at(triangle)];
    const Vec3& a = state.position[at(n[0])];
    const Vec3 now = (state.position[at(n[1])] - a).cross(state.position[at(n[2])] - a);
    return now.dot(front_of(state.sheet->mesh, triangle)) < 0.0;
}

MembraneSheet uniform_sheet(TriMesh mesh, const Vec3& fibre, double thickness) {
    MembraneSheet sheet;
    sheet.mesh = std::move(mesh);
    sheet.neighbours = tri_neighbours(sheet.mesh);
    sheet.origin.resize(sheet.mesh.nodes.size());
    std::iota(sheet.origin.begin(), sheet.origin.end(), 0);
    for (std::size_t t = 0; t < sheet.mesh.triangles.size(); ++t) {
        const Vec3 front = front_of(sheet.mesh, static_cast<int>(t));
        sheet.fibre.push_back((fibre - fibre.dot(front) * front).normalized());
    }
    sheet.thickness.assign(sheet.mesh.triangles.size(), thickness);
    sheet.stiffness.assign(sheet.mesh.triangles.size(), 1.0);
    return sheet;
}

Status check_membrane(const MembraneModel& model, UnusedNodes unused) {
    if (!model.sheet) {
        return Error{"has no sheet", model.name, "a triangle mesh"};
    }
    if (Status s = check_orthotropic(model.material, model.name); !s) {
        return s;
    }
    if (Status s = check_sheet(model, unused); !s) {
        return s;
    }
    for (const auto& check : {check_numbers, check_holds, check_support}) {
        if (Status s = check(model); !s) {
            return s;
        }
    }
    return success();
}

MembraneState rest_state(const MembraneModel& model) {
    MembraneState state;
    state.sheet = model.sheet;
    state.position = model.sheet->mesh.nodes;
    state.velocity.assign(state.position.size(), Vec3::Zero());
    return state;
}

double stretch_stiffness(const MembraneModel& model, const MembraneSheet& sheet, double times) {
    double sum = 0.0;
    for (const double h : sheet.thickness) {
        sum += h;
    }
    const double mean = sum / static_cast<double>(sheet.thickness.size());
    return times * std::max(model.material.along, model.material.across) * mean;
}

bool is_out(const MembraneSheet& sheet, int node) {
    return sheet.neighbours.offset[at(node)] == sheet.neighbours.offset[at(node) + 1];
}

bool is_fixed(const MembraneModel& model, const MembraneSheet& sheet, int node) {
    return is_out(sheet, node) ||
           std::binary_search(model.fixed_nodes.begin(), model.fixed_nodes.end(), sheet.origin[at(node)]);
}

double toughness_along(const Toughness& toughness, const Vec3& fibre, const Vec3& direction) {
    const double cosine = fibre.dot(direction);
    return toughness.along + (toughness.across - toughness.along) * (1.0 - cosine * cosine);
}

}  // namespace rhexis
