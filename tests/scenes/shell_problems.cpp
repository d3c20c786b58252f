// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/shell_problems.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"

namespace rhexis::scenes {
namespace {

using Held = std::array<bool, 6>;

ShellProblem problem(std::string name, TriMesh mesh, double thickness, double young, double nu) {
    ShellProblem result;
    result.model = uniform_shell(name, std::move(mesh), thickness);
    result.name = std::move(name);
    result.model.material.young_modulus = young;
    result.model.material.poisson_ratio = nu;
    result.load.force.assign(result.model.mesh.nodes.size(), Vec3::Zero());
    result.load.moment.assign(result.model.mesh.nodes.size(), Vec3::Zero());
    return result;
}

/// Holds freedoms where a rule says so, besides those held already.
template <typename Rule>
void hold(ShellProblem& of, const Held& held, const Rule& rule) {
    std::vector<ShellHold>& holds = of.model.holds;
    for (int n = 0; n < static_cast<int>(of.model.mesh.nodes.size()); ++n) {
        if (!rule(of.model.mesh.nodes[at(n)])) {
            continue;
        }
        auto place = std::lower_bound(holds.begin(), holds.end(), n,
                                      [](const ShellHold& hold, int node) { return hold.node < node; });
        if (place == holds.end() || place->node != n) {
            place = holds.insert(place, ShellHold{n, {false, false, false, false, false, false}});
        }
        for (std::size_t i = 0; i < 6; ++i) {
            place->held[i] = place->held[i] || held[i];
        }
    }
}

/// Share of an edge of `count` cells that node i of it bears.
double edge_share(int i, int count) { return (i == 0 || i == count ? 0.5 : 1.0) / count; }

ShellProblem cantilever(const std::string& name, double length, int nx, int ny, GridCut cut) {
    const auto map = [length](double s, double t) { return Vec3(length * s, t - 0.5, 0.0); };
    ShellProblem result = problem(name, grid_mesh(nx, ny, cut, map), 0.1, 1.2e6, 0.0);
    hold(result, {true, true, true, true, true, true}, [](const Vec3& x) { return x.x() < 1e-9; });
    const int tip = nx + (nx + 1) * (ny / 2);
    result.measure = [tip, length](const ShellState& state) {
        const Vec3& x = state.position[at(tip)];
        return std::array<double, 2>{length - x.x(), x.z()};
    };
    return result;
}

}  // namespace

TriMesh grid_mesh(int nx, int ny, GridCut cut, const std::function<Vec3(double, double)>& map) {
    TriMesh mesh;
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            mesh.nodes.push_back(map(static_cast<double>(i) / nx, static_cast<double>(j) / ny));
        }
    }
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int a = i + (nx + 1) * j;
            const std::array<int, 4> corner{a, a + 1, a + nx + 2, a + nx + 1};
            if (cut == GridCut::crossed) {
                const int middle = static_cast<int>(mesh.nodes.size());
                mesh.nodes.push_back(map((i + 0.5) / nx, (j + 0.5) / ny));
                for (std::size_t k = 0; k < 4; ++k) {
                    mesh.triangles.push_back({corner[k], corner[(k + 1) % 4], middle});
                }
            } else if (cut == GridCut::one_way || (i + j) % 2 == 0) {
                mesh.triangles.push_back({corner[0], corner[1], corner[2]});
                mesh.triangles.push_back({corner[0], corner[2], corner[3]});
            } else {
                mesh.triangles.push_back({corner[0], corner[1], corner[3]});
                mesh.triangles.push_back({corner[1], corner[2], corner[3]});
            }
        }
    }
    return mesh;
}

ShellProblem cantilever_shear(int length, int width, GridCut cut) {
    ShellProblem result = cantilever("cantilever, end shear", 10.0, length, width, cut);
    for (int j = 0; j <= width; ++j) {
        result.load.force[at(length + (length + 1) * j)].z() = 4.0 * edge_share(j, width);
    }
    result.reference = {{0.05, {0.0265, 0.6636}},
                        {0.25, {0.5643, 3.0172}},
                        {0.5, {1.6064, 4.9346}},
                        {0.75, {2.5442, 6.0325}},
                        {1.0, {3.2894, 6.6996}}};
    return result;
}

ShellProblem cantilever_moment(int length, int width, GridCut cut) {
    ShellProblem result = cantilever("cantilever, end moment", 12.0, length, width, cut);
    for (int j = 0; j <= width; ++j) {
        result.load.moment[at(length + (length + 1) * j)].y() = -50.0 * M_PI / 3.0 * edge_share(j, width);
    }
    for (const double factor : {0.25, 0.5, 0.75, 1.0}) {
        const double turn = 2.0 * M_PI * factor;
        result.reference.push_back(
            {factor, {12.0 * (1.0 - std::sin(turn) / turn), 12.0 * (1.0 - std::cos(turn)) / turn}});
    }
    return result;
}

ShellProblem slit_ring(int around, int across, GridCut cut) {
    const auto map = [](double s, double t) {
        const double radius = 6.0 + 4.0 * t;
        const double angle = 2.0 * M_PI * s;
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    };
    // node numbers tell the lips apart, which lie in the same place
    ShellProblem result = problem("slit ring", grid_mesh(around, across, cut, map), 0.03, 21e6, 0.0);
    for (int j = 0; j <= across; ++j) {
        result.load.force[at((around + 1) * j)].z() = 3.2 * edge_share(j, across);
        result.model.holds.push_back({around + (around + 1) * j, {true, true, true, true, true, true}});
    }
    const int outer = (around + 1) * across;
    result.measure = [outer](const ShellState& state) {
        return std::array<double, 2>{state.position[0].z(), state.position[at(outer)].z()};
    };
    result.reference = {{0.025, {1.305, 1.789}}, {0.05, {2.455, 3.370}}, {0.1, {4.277, 5.876}},
                        {0.2, {6.725, 9.160}},   {0.4, {9.529, 12.661}}, {0.6, {11.257, 14.674}},
                        {0.8, {12.642, 16.202}}, {1.0, {13.891, 17.528}}};
    return result;
}

ShellProblem open_hemisphere(int around, int up, GridCut cut) {
    const auto map = [](double s, double t) {
        const double turn = 0.5 * M_PI * s;
        const double height = 72.0 / 180.0 * M_PI * t;
        return Vec3(10.0 *
                    Vec3(std::cos(height) * std::cos(turn), std::cos(height) * std::sin(turn), std::sin(height)));
    };
    ShellProblem result = problem("open hemisphere", grid_mesh(around, up, cut, map), 0.04, 6.825e7, 0.3);
    hold(result, {true, false, false, false, true, true}, [](const Vec3& x) { return std::abs(x.x()) < 1e-9; });
    hold(result, {false, true, false, true, false, true}, [](const Vec3& x) { return std::abs(x.y()) < 1e-9; });
    hold(result, {false, false, true, false, false, false},
         [](const Vec3& x) { return (x - Vec3(10.0, 0.0, 0.0)).norm() < 1e-9; });
    const int far = around;
    result.load.force[0].x() = 200.0;
    result.load.force[at(far)].y() = -200.0;
    result.measure = [far](const ShellState& state) {
        return std::array<double, 2>{state.position[0].x() - 10.0, 10.0 - state.position[at(far)].y()};
    };
    result.reference = {{0.05, {0.855, 0.955}}, {0.1, {1.499, 1.840}}, {0.2, {2.321, 3.261}}, {0.4, {3.158, 5.196}},
                        {0.6, {3.598, 6.497}},  {0.8, {3.875, 7.448}}, {1.0, {4.067, 8.178}}};
    return result;
}

ShellProblem pinched_cylinder(int around, int along, GridCut cut) {
    const auto map = [](double s, double t) {
        const double angle = 0.5 * M_PI * s;  // from the force, at +z, to the side, at +x
        return Vec3(100.0 * std::sin(angle), 100.0 * t, 100.0 * std::cos(angle));
    };
    ShellProblem result = problem("pinched cylinder", grid_mesh(around, along, cut, map), 1.0, 30e3, 0.3);
    hold(result, {true, false, false, false, true, true}, [](const Vec3& x) { return std::abs(x.x()) < 1e-9; });
    hold(result, {false, false, true, true, true, false}, [](const Vec3& x) { return std::abs(x.z()) < 1e-9; });
    hold(result, {false, true, false, true, false, true}, [](const Vec3& x) { return x.y() < 1e-9; });
    hold(result, {true, false, true, false, true, false}, [](const Vec3& x) { return x.y() > 100.0 - 1e-9; });
    result.load.force[0].z() = -3000.0;
    const int side = around;
    result.measure = [side](const ShellState& state) {
        return std::array<double, 2>{100.0 - state.position[0].z(), state.position[at(side)].x() - 100.0};
    };
    result.reference = {{0.05, {9.561, -0.233}}, {0.1, {23.164, -2.391}}, {0.2, {56.373, 10.448}},
                        {0.3, {65.498, 17.979}}, {0.5, {73.790, 25.381}}, {0.7, {78.451, 29.772}},
                        {1.0, {83.102, 34.272}}};
    return result;
}

ShellProblem hinged_roof(int each_way, double thickness, GridCut cut) {
    const auto map = [](double s, double t) {
        const double angle = 0.1 * s;
        return Vec3(2540.0 * std::sin(angle), 254.0 * t, 2540.0 * std::cos(angle));
    };
    ShellProblem result = problem("hinged roof", grid_mesh(each_way, each_way, cut, map), thickness, 3102.75, 0.3);
    const double side = 2540.0 * std::sin(0.1);
    hold(result, {true, false, false, false, true, true}, [](const Vec3& x) { return std::abs(x.x()) < 1e-9; });
    hold(result, {false, true, false, true, false, true}, [](const Vec3& x) { return x.y() < 1e-9; });
    hold(result, {true, true, true, false, false, false}, [=](const Vec3& x) { return x.x() > side - 1e-9; });
    result.load.force[0].z() = -750.0;
    result.measure = [](const ShellState& state) {
        const double w = 2540.0 - state.position[0].z();
        return std::array<double, 2>{w, w};
    };
    return result;
}

ShellProblem pulled_cylinder(int around, int along, GridCut cut) {
    const double radius = 4.953;
    const auto map = [radius](double s, double t) {
        const double angle = 0.5 * M_PI * s;  // from the force, at +z, to the side, at +x
        return Vec3(radius * std::sin(angle), 5.175 * t, radius * std::cos(angle));
    };
    ShellProblem result = problem("pulled cylinder", grid_mesh(around, along, cut, map), 0.094, 10.5e6, 0.3125);
    hold(result, {true, false, false, false, true, true}, [](const Vec3& x) { return std::abs(x.x()) < 1e-9; });
    hold(result, {false, false, true, true, true, false}, [](const Vec3& x) { return std::abs(x.z()) < 1e-9; });
    hold(result, {false, true, false, true, false, true}, [](const Vec3& x) { return x.y() < 1e-9; });
    result.load.force[0].z() = 10000.0;
    const int side = around;
    result.measure = [side, radius](const ShellState& state) {
        return std::array<double, 2>{state.position[0].z() - radius, radius - state.position[at(side)].x()};
    };
    return result;
}

ShellProblem clamped_plate(int each_way, GridCut cut) {
    const double young = 1.092e6;
    const double nu = 0.3;
    const double thickness = 0.01;
    const double bending = young * thickness * thickness * thickness / (12.0 * (1.0 - nu * nu));
    const auto map = [](double s, double t) { return Vec3(s, t, 0.0); };
    ShellProblem result = problem("clamped plate", grid_mesh(each_way, each_way, cut, map), thickness, young, nu);
    hold(result, {true, true, true, true, true, true},
         [](const Vec3& x) { return std::min(std::min(x.x(), 1.0 - x.x()), std::min(x.y(), 1.0 - x.y())) < 1e-9; });
    const int middle = each_way / 2 * (each_way + 2);
    const double deflection = 1e-4 * thickness;
    result.load.force[at(middle)].z() = deflection * bending / 5.612e-3;
    result.measure = [middle](const ShellState& state) {
        return std::array<double, 2>{state.position[at(middle)].z(), state.position[at(middle)].z()};
    };
    result.reference = {{1.0, {deflection, deflection}}};
    return result;
}

ShellProblem euler_column(int length, int width) {
    ShellProblem result = cantilever("Euler column", 10.0, length, width, GridCut::alternate);
    for (int j = 0; j <= width; ++j) {
        result.load.force[at(length + (length + 1) * j)].x() = -M_PI * M_PI * 100.0 / 400.0 * edge_share(j, width);
    }
    return result;
}

}  // namespace rhexis::scenes
