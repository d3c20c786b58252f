// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/groove_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rhexis {
namespace {

/// Largest patch of connected cells (8 neighbours) with at least footprint_loss, cells ascending.
class Footprint {
public:
    Footprint(const ColumnGrid& grid, const ColumnFill& fill) : grid_(grid), open_(grid.cells(), 0) {
        for (int cell = 0; cell < grid.cells(); ++cell) {
            open_[cell] = grid.inside(cell) && fill.removed[cell] >= footprint_loss ? 1 : 0;
        }
    }

    std::vector<int> largest() {
        std::vector<int> best;
        for (int cell = 0; cell < grid_.cells(); ++cell) {
            if (open_[cell] != 0) {
                std::vector<int> patch = flood(cell);
                if (patch.size() > best.size()) {
                    best = std::move(patch);
                }
            }
        }
        std::sort(best.begin(), best.end());
        return best;
    }

private:
    std::vector<int> flood(int start) {
        std::vector<int> patch{start};
        open_[start] = 0;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            const int row = patch[i] / grid_.count;
            const int column = patch[i] % grid_.count;
            for (int r = std::max(0, row - 1); r <= std::min(grid_.count - 1, row + 1); ++r) {
                for (int c = std::max(0, column - 1); c <= std::min(grid_.count - 1, column + 1); ++c) {
                    take(r * grid_.count + c, patch);
                }
            }
        }
        return patch;
    }

    void take(int cell, std::vector<int>& patch) {
        if (open_[cell] != 0) {
            open_[cell] = 0;
            patch.push_back(cell);
        }
    }

    const ColumnGrid& grid_;
    std::vector<unsigned char> open_;
};

Vec2 mean_place(const ColumnGrid& grid, const std::vector<int>& cells) {
    Vec2 sum = Vec2::Zero();
    for (const int cell : cells) {
        sum += grid.centre(cell);
    }
    return sum / static_cast<double>(cells.size());
}

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

Extent extent_along(const ColumnGrid& grid, const std::vector<int>& cells, const Vec2& mean, const Vec2& direction) {
    Extent extent;
    for (const int cell : cells) {
        const double along = (grid.centre(cell) - mean).dot(direction);
        extent.low = std::min(extent.low, along);
        extent.high = std::max(extent.high, along);
    }
    return extent;
}

struct FloorSlice {
    double depth = 0.0;
    double share = 0.0;
};

/// The floor seen along the groove: per slice one cell thick, its greatest depth.
std::vector<FloorSlice> slices_along(const ColumnGrid& grid, const ColumnFill& fill, const std::vector<int>& cells,
                                     const Vec2& mean, const Vec2& direction, const Extent& extent) {
    const int count = 1 + static_cast<int>(std::floor((extent.high - extent.low) / grid.cell + 0.5));
    std::vector<FloorSlice> slices(count);
    for (const int cell : cells) {
        const double along = (grid.centre(cell) - mean).dot(direction) - extent.low;
        const int index = std::clamp(static_cast<int>(std::floor(along / grid.cell + 0.5)), 0, count - 1);
        const double depth = local_depth(grid, fill, cell);
        if (depth > slices[index].depth) {
            slices[index] = {depth, depth / grid.thickness(cell)};
        }
    }
    return slices;
}

void add_depths(const ColumnGrid& grid, const ColumnFill& fill, const std::vector<int>& cells, GrooveShape& shape) {
    for (const int cell : cells) {
        const double depth = local_depth(grid, fill, cell);
        shape.depth_share = std::max(shape.depth_share, depth / grid.thickness(cell));
        if (depth > shape.depth) {
            shape.depth = depth;
            const Vec2 place = grid.centre(cell);
            shape.floor = Vec3(place.x(), place.y(), grid.front[cell] - depth);
        }
    }
}

Vec3 on_front(const ColumnGrid& grid, const Vec2& place, double otherwise) {
    const double z = front_surface(grid, place);
    return {place.x(), place.y(), std::isnan(z) ? otherwise : z};
}

/// Of nine, by the fewest exchanges: rows in order, then the largest of the least, the middle one of the middle ones
/// and the least of the largest hold it between them.
double median(std::array<double, 9>& v) {
    const auto order = [&v](std::size_t a, std::size_t b) {
        const double low = std::min(v[a], v[b]);
        v[b] = std::max(v[a], v[b]);
        v[a] = low;
    };
    const auto order_three = [&order](std::size_t a, std::size_t b, std::size_t c) {
        order(a, b);
        order(b, c);
        order(a, b);
    };
    order_three(0, 1, 2);
    order_three(3, 4, 5);
    order_three(6, 7, 8);
    order_three(0, 3, 6);
    order_three(1, 4, 7);
    order_three(2, 5, 8);
    order_three(2, 4, 6);
    return v[4];
}

}  // namespace

double local_depth(const ColumnGrid& grid, const ColumnFill& fill, int cell) {
    const int row = cell / grid.count;
    const int column = cell % grid.count;
    if (row < 1 || column < 1 || row >= grid.count - 1 || column >= grid.count - 1) {
        return 0.0;
    }
    std::array<double, 9> around{};
    int k = 0;
    for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = column - 1; c <= column + 1; ++c) {
            around[k++] = fill.removed[r * grid.count + c];
        }
    }
    return median(around);
}

/// The half angle is taken by square roots alone, so that no library function decides its last bit.
Vec2 principal_direction(const ColumnGrid& grid, const std::vector<int>& cells) {
    const Vec2 mean = mean_place(grid, cells);
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const int cell : cells) {
        const Vec2 offset = grid.centre(cell) - mean;
        xx += offset.x() * offset.x();
        xy += offset.x() * offset.y();
        yy += offset.y() * offset.y();
    }
    const double difference = yy - xx;
    const double length = std::sqrt(difference * difference + 4.0 * xy * xy);
    if (length <= 1e-12 * (xx + yy)) {
        return Vec2::UnitY();
    }
    const double along_y = std::sqrt(0.5 * (1.0 + difference / length));
    const double along_x = std::sqrt(std::max(0.0, 0.5 * (1.0 - difference / length)));
    return {xy < 0.0 ? -along_x : along_x, along_y};
}

GrooveShape shape_of(const ColumnGrid& grid, const ColumnFill& fill, const std::vector<int>& cells,
                     const std::vector<int>& depth_cells, const Vec2& direction) {
    GrooveShape shape;
    if (cells.empty()) {
        return shape;
    }
    shape.exists = true;
    const Vec2 mean = mean_place(grid, cells);
    shape.direction = direction;
    const Extent extent = extent_along(grid, cells, mean, shape.direction);
    shape.length = extent.high - extent.low + grid.cell;
    shape.width = static_cast<double>(cells.size()) * grid.cell * grid.cell / shape.length;
    add_depths(grid, fill, depth_cells, shape);
    const std::vector<FloorSlice> slices = slices_along(grid, fill, cells, mean, shape.direction, extent);
    for (const FloorSlice& slice : slices) {
        shape.mean_depth += slice.depth / static_cast<double>(slices.size());
        shape.mean_depth_share += slice.share / static_cast<double>(slices.size());
    }
    shape.near_end = on_front(grid, mean + extent.low * shape.direction, shape.floor.z());
    shape.far_end = on_front(grid, mean + extent.high * shape.direction, shape.floor.z());
    return shape;
}

GrooveShape groove_shape(const ColumnGrid& grid, const ColumnFill& fill) {
    const std::vector<int> cells = Footprint(grid, fill).largest();
    return cells.empty() ? GrooveShape{} : shape_of(grid, fill, cells, cells, principal_direction(grid, cells));
}

}  // namespace rhexis
