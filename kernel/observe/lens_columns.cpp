// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/lens_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rhexis {
namespace {

constexpr double no_column = std::numeric_limits<double>::quiet_NaN();

struct Interval {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

/// Part of the vertical line at `place` that lies inside a tetrahedron; low >= high when none does.
Interval chord(const std::array<Vec3, 4>& corners, const Vec2& place) {
    Interval part;
    for (const std::array<int, 3>& face : tet_faces) {
        const Vec3& a = corners[face[0]];
        const Vec3 normal = (corners[face[1]] - a).cross(corners[face[2]] - a);
        const double side = normal.x() * (place.x() - a.x()) + normal.y() * (place.y() - a.y());
        if (normal.z() > 0.0) {
            part.high = std::min(part.high, a.z() - side / normal.z());
        } else if (normal.z() < 0.0) {
            part.low = std::max(part.low, a.z() - side / normal.z());
        } else if (side > 0.0) {
            return {0.0, 0.0};
        }
    }
    return part;
}

struct PlacedSegment {
    int cell = 0;
    ColumnSegment segment;
};

int lowest_cell(const ColumnGrid& grid, double coordinate) {
    return std::max(0, static_cast<int>(std::ceil((coordinate - grid.origin) / grid.cell)));
}

int highest_cell(const ColumnGrid& grid, double coordinate) {
    return std::min(grid.count - 1, static_cast<int>(std::floor((coordinate - grid.origin) / grid.cell)));
}

void place_tet(const ColumnGrid& grid, const std::array<Vec3, 4>& corners, int tet, int material,
               std::vector<PlacedSegment>& placed) {
    Vec3 low = corners[0];
    Vec3 high = corners[0];
    for (const Vec3& corner : corners) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    for (int row = lowest_cell(grid, low.y()); row <= highest_cell(grid, high.y()); ++row) {
        for (int column = lowest_cell(grid, low.x()); column <= highest_cell(grid, high.x()); ++column) {
            const int cell = row * grid.count + column;
            const Interval part = chord(corners, grid.centre(cell));
            if (part.low < part.high) {
                placed.push_back({cell, {tet, material, part.low, part.high}});
            }
        }
    }
}

std::vector<Vec3> fine_rest(const SolidModel& lens) {
    std::vector<Vec3> positions;
    fine_positions(lens.fine, lens.coarse.nodes, positions);
    return positions;
}

std::array<Vec3, 4> corners_of(const std::vector<Vec3>& positions, const std::array<int, 4>& tet) {
    return {positions[tet[0]], positions[tet[1]], positions[tet[2]], positions[tet[3]]};
}

void lay_out_grid(const SolidModel& lens, double cell, ColumnGrid& grid) {
    double reach = 0.0;
    for (const Vec3& node : lens.coarse.nodes) {
        reach = std::max({reach, std::abs(node.x()), std::abs(node.y())});
    }
    const int half = static_cast<int>(std::ceil(reach / cell)) + 1;
    grid.cell = cell;
    grid.count = 2 * half + 1;
    grid.origin = -half * cell;
}

void gather(std::vector<PlacedSegment> placed, ColumnGrid& grid) {
    std::sort(placed.begin(), placed.end(), [](const PlacedSegment& a, const PlacedSegment& b) {
        if (a.cell != b.cell) {
            return a.cell < b.cell;
        }
        return a.segment.high != b.segment.high ? a.segment.high > b.segment.high : a.segment.tet < b.segment.tet;
    });
    grid.first.assign(grid.cells() + 1, 0);
    grid.front.assign(grid.cells(), no_column);
    grid.back.assign(grid.cells(), no_column);
    for (const PlacedSegment& item : placed) {
        ++grid.first[item.cell + 1];
        grid.segments.push_back(item.segment);
        if (std::isnan(grid.front[item.cell])) {
            grid.front[item.cell] = item.segment.high;
            grid.back[item.cell] = item.segment.low;
        }
        grid.back[item.cell] = std::min(grid.back[item.cell], item.segment.low);
    }
    for (int cell = 0; cell < grid.cells(); ++cell) {
        grid.first[cell + 1] += grid.first[cell];
    }
}

double bilinear(const ColumnGrid& grid, const std::vector<double>& values, const Vec2& place) {
    const double x = (place.x() - grid.origin) / grid.cell;
    const double y = (place.y() - grid.origin) / grid.cell;
    if (!(x >= 0.0 && y >= 0.0 && x < grid.count - 1 && y < grid.count - 1)) {
        return no_column;
    }
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const double u = x - column;
    const double v = y - row;
    const int cell = row * grid.count + column;
    const double near = values[cell] * (1.0 - u) + values[cell + 1] * u;
    const double far = values[cell + grid.count] * (1.0 - u) + values[cell + grid.count + 1] * u;
    return near * (1.0 - v) + far * v;
}

/// Along the rim one of the four columns may miss the lens: the column of the place itself decides there.
double surface(const ColumnGrid& grid, const std::vector<double>& values, const Vec2& place) {
    const double smooth = bilinear(grid, values, place);
    const int cell = grid.cell_at(place);
    return std::isnan(smooth) && cell >= 0 ? values[cell] : smooth;
}

void fill_cell(const SolidModel& lens, const ColumnGrid& grid, int cell, ColumnFill& fill) {
    double removed = 0.0;
    double bottom = 0.0;
    Vec3 optical_depth = Vec3::Zero();
    for (int i = grid.first[cell]; i < grid.first[cell + 1]; ++i) {
        const ColumnSegment& segment = grid.segments[i];
        const double length = segment.high - segment.low;
        const double left = fill.fraction[segment.tet];
        removed += (1.0 - left) * length;
        optical_depth += left * length * lens.materials[segment.material].extinction;
        if (left < 0.5) {
            bottom = std::max(bottom, grid.front[cell] - segment.low);
        }
    }
    fill.removed[cell] = removed;
    fill.bottom[cell] = bottom;
    for (int channel = 0; channel < 3; ++channel) {
        fill.transmission[cell][channel] = std::exp(-optical_depth[channel]);
    }
}

void measure_volumes(const SolidModel& lens, ColumnFill& fill) {
    const std::vector<Vec3> rest = fine_rest(lens);
    fill.fine_volumes.reserve(lens.fine.tets.size());
    for (const std::array<int, 4>& tet : lens.fine.tets) {
        fill.fine_volumes.push_back(tet_volume(rest[tet[0]], rest[tet[1]], rest[tet[2]], rest[tet[3]]));
    }
}

}  // namespace

ColumnGrid make_columns(const SolidModel& lens, double cell) {
    ColumnGrid grid;
    lay_out_grid(lens, cell, grid);
    const std::vector<Vec3> rest = fine_rest(lens);
    std::vector<PlacedSegment> placed;
    for (int tet = 0; tet < static_cast<int>(lens.fine.tets.size()); ++tet) {
        place_tet(grid, corners_of(rest, lens.fine.tets[tet]), tet, lens.coarse.region[tet / 8], placed);
    }
    gather(std::move(placed), grid);
    return grid;
}

double front_surface(const ColumnGrid& grid, const Vec2& place) { return surface(grid, grid.front, place); }
double back_surface(const ColumnGrid& grid, const Vec2& place) { return surface(grid, grid.back, place); }

bool update_columns(const SolidModel& lens, const ColumnGrid& grid, const std::vector<double>& fraction,
                    ColumnFill& fill) {
    if (fill.fraction == fraction && !fill.removed.empty()) {
        return false;
    }
    if (fill.fine_volumes.empty()) {
        measure_volumes(lens, fill);
    }
    fill.fraction = fraction;
    fill.removed.resize(grid.cells());
    fill.bottom.resize(grid.cells());
    fill.transmission.resize(grid.cells());
    for (int cell = 0; cell < grid.cells(); ++cell) {
        fill_cell(lens, grid, cell, fill);
    }
    fill.removed_volume = 0.0;
    for (std::size_t tet = 0; tet < fraction.size(); ++tet) {
        fill.removed_volume += (1.0 - fraction[tet]) * fill.fine_volumes[tet];
    }
    return true;
}

}  // namespace rhexis
