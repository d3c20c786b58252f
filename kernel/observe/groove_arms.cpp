// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/groove_arms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr int directions = 120;          ///< over half a turn: 1.5 degrees apart
constexpr int coarse_step = 4;           ///< directions between those tried first
constexpr int whole_cost = 2;            ///< of a whole column in the rectangle, where a lost one is worth 1
constexpr int rounds = 3;                ///< of extent along, then across
constexpr int most_bands = 6;            ///< looked at, pits and scratches among them
constexpr double margin = 0.2;           ///< beside a band: its ragged edge, no other groove [mm]
constexpr double least_length = 2.0;     ///< [mm]
constexpr double least_slimness = 1.3;   ///< length over width
constexpr double stout = 2.2;            ///< slimness below which one groove may be two that cross
constexpr double least_own_area = 0.6;   ///< outside all bands found before [mm^2]
constexpr double least_spread = 2.0;     ///< of slices that tell a direction: sum of squares [mm^2]
constexpr double steepest = 0.2;         ///< by which their line may leave the band's direction
constexpr double least_own_width = 0.4;  ///< of that area, mean over its extent along the groove [mm]

/// Unit vectors 1.5 degrees apart over half a turn; by products only, so that no library decides their last bit.
std::array<Vec2, directions> make_directions() {
    constexpr double cosine = 0.99965732497555728;
    constexpr double sine = 0.026176948307873153;
    std::array<Vec2, directions> list;
    list[0] = Vec2::UnitY();
    for (int i = 1; i < directions; ++i) {
        list[i] =
            Vec2(cosine * list[i - 1].x() + sine * list[i - 1].y(), cosine * list[i - 1].y() - sine * list[i - 1].x());
    }
    return list;
}

double slimness(const GrooveBand& band) { return (band.high - band.low) / (band.right - band.left); }

/// How much slimness counts.
enum class Slim { little, more, most };

/// By which bands are compared.
double rank(const GrooveBand& band, Slim slim) {
    const double root = std::sqrt(slimness(band));
    return band.worth * (slim == Slim::little ? root : slim == Slim::more ? root * std::sqrt(root) : root * root);
}

bool is_long(const GrooveBand& band) {
    return band.high - band.low >= std::max(least_length, least_slimness * (band.right - band.left));
}

/// The same rectangle, its sides called the other way round.
GrooveBand sideways(const GrooveBand& band) {
    return {Vec2(band.along.y(), -band.along.x()), band.left, band.right, -band.high, -band.low, band.worth};
}

struct Stretch {
    int first = 0;
    int last = -1;
    int sum = 0;
};

/// The stretch of a row of numbers with the greatest sum.
Stretch best_stretch(const std::vector<int>& numbers) {
    Stretch best;
    int sum = 0;
    int first = 0;
    for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
        if (sum <= 0) {
            sum = 0;
            first = i;
        }
        sum += numbers[i];
        if (sum > best.sum) {
            best = {first, i, sum};
        }
    }
    return best;
}

enum class Column : unsigned char { whole, explained, lost };

const std::array<Vec2, directions>& tried_directions() {
    static const std::array<Vec2, directions> tried = make_directions();
    return tried;
}

/// Places on either side of the middle of a square that holds the whole grid however it is turned.
int half_turned(const ColumnGrid& grid) {
    return static_cast<int>(std::ceil(std::numbers::sqrt2 * (0.5 * grid.count + 1.0)));
}

/// The column at each place of that square, its rows along a direction: 1 + its number, 0 beside the grid.
std::vector<int> turned_columns(const ColumnGrid& grid, const Vec2& along) {
    const Vec2 across(along.y(), -along.x());
    const int half = half_turned(grid);
    std::vector<int> columns;
    for (int i = -half; i <= half; ++i) {
        for (int k = -half; k <= half; ++k) {
            columns.push_back(1 + grid.cell_at(grid.cell * (k * across + i * along)));
        }
    }
    return columns;
}

class ArmFinder {
public:
    /// turned: turned_columns of the directions that were looked along before; keeps more of them.
    ArmFinder(const ColumnGrid& grid, const std::vector<int>& lost, std::vector<std::vector<int>>& turned)
        : grid_(grid), columns_(grid.cells(), Column::whole), cells_(lost), turned_(turned) {
        turned_.resize(directions);
        for (const int cell : lost) {
            columns_[cell] = Column::lost;
            reach_ = std::max(reach_, grid.centre(cell).norm());
        }
        side_ = 2 * static_cast<int>(std::ceil(reach_ / grid.cell)) + 1;
    }

    /// Over the middle of a cross lies a wide band that may hold more than each of its grooves. What is found depends
    /// on how much slimness counts against what a band holds: the bands that together hold most, and are slim, are
    /// taken.
    std::vector<GrooveBand> bands() {
        std::vector<GrooveBand> best = one_by_one(Slim::little);
        if (best.empty() || (best.size() == 1 && slimness(best[0]) > stout)) {
            return best;
        }
        for (const Slim slim : {Slim::more, Slim::most}) {
            std::vector<GrooveBand> found = one_by_one(slim);
            if (together(found) > together(best)) {
                best = std::move(found);
            }
        }
        return best;
    }

private:
    [[nodiscard]] double area(double columns) const { return columns * grid_.cell * grid_.cell; }
    [[nodiscard]] double own_area() const {
        return area(static_cast<double>(std::count(columns_.begin(), columns_.end(), Column::lost)));
    }
    std::vector<GrooveBand> one_by_one(Slim slim);
    [[nodiscard]] double together(const std::vector<GrooveBand>& bands) const;
    [[nodiscard]] GrooveBand best_band(Slim slim);
    [[nodiscard]] GrooveBand best_in_direction(int direction);
    void look_along(int direction);
    [[nodiscard]] bool is_groove(const GrooveBand& band) const;

    const ColumnGrid& grid_;
    std::vector<Column> columns_;
    const std::vector<int>& cells_;  ///< that have lost tissue
    double reach_ = 0.0;             ///< of them from the axis [mm]
    int side_ = 1;                   ///< of the square in which they lie [columns]

    std::vector<std::vector<int>>& turned_;
    std::vector<int> of_column_;  ///< what each column is worth, behind one beside the grid; scratch, as what follows
    std::vector<int> worth_;      ///< of the square turned to a direction, row by row
    std::vector<int> sums_;
    std::vector<int> runs_;
};

/// The best band; then, with what that holds counting no more, the next.
std::vector<GrooveBand> ArmFinder::one_by_one(Slim slim) {
    for (const int cell : cells_) {
        columns_[cell] = Column::lost;
    }
    std::vector<GrooveBand> found;
    for (int i = 0; i < most_bands && found.size() < most_grooves && own_area() >= least_own_area; ++i) {
        const GrooveBand band = best_band(slim);
        if (is_groove(band)) {
            found.push_back(band);
        }
        for (const int cell : cells_) {
            if (band.holds(grid_.centre(cell), margin)) {
                columns_[cell] = Column::explained;
            }
        }
    }
    return found;
}

/// What the first two of some bands hold, less what whole columns in them cost; the stouter of them counts.
double ArmFinder::together(const std::vector<GrooveBand>& bands) const {
    const std::span<const GrooveBand> two(bands.data(), std::min<std::size_t>(2, bands.size()));
    double stoutest = HUGE_VAL;
    for (const GrooveBand& band : two) {
        stoutest = std::min(stoutest, slimness(band));
    }
    double sum = 0.0;
    for (int cell = 0; cell < grid_.cells(); ++cell) {
        const Vec2 place = grid_.centre(cell);
        if (std::any_of(two.begin(), two.end(), [&](const GrooveBand& band) { return band.holds(place, 0.0); })) {
            sum += columns_[cell] == Column::whole ? -whole_cost : 1;
        }
    }
    return two.empty() ? 0.0 : sum * std::sqrt(stoutest);
}

/// Coarsely over all directions, then finely about the best. Long ones go before others: a cross of stout grooves holds
/// a large diamond.
GrooveBand ArmFinder::best_band(Slim slim) {
    of_column_.assign(1, -whole_cost);
    for (const Column column : columns_) {
        of_column_.push_back(column == Column::lost ? 1 : column == Column::explained ? 0 : -whole_cost);
    }
    GrooveBand best;
    int best_at = 0;
    const auto look = [&](int at) {
        const int index = (at + directions) % directions;
        const GrooveBand band = best_in_direction(index);
        const bool longer = is_long(band) && !is_long(best);
        const bool better =
            is_long(band) == is_long(best) && (best.worth <= 0.0 || rank(band, slim) > rank(best, slim));
        if (band.worth > 0.0 && (longer || better)) {
            best = band;
            best_at = index;
        }
    };
    for (int i = 0; i < directions; i += coarse_step) {
        look(i);
    }
    for (const int step : {2, 1, 1}) {
        const int middle = best_at;
        look(middle - step);
        look(middle + step);
    }
    return best;
}

/// What each place of the square is worth, rows along a direction.
void ArmFinder::look_along(int direction) {
    std::vector<int>& turned = turned_[at(direction)];
    if (turned.empty()) {
        turned = turned_columns(grid_, tried_directions()[at(direction)]);
    }
    const int half = side_ / 2;
    const int whole = half_turned(grid_);
    worth_.resize(at(side_ * side_));
    int* out = worth_.data();
    for (int i = whole - half; i <= whole + half; ++i) {
        const int* in = turned.data() + i * (2 * whole + 1) + whole - half;
        for (int k = 0; k < side_; ++k) {
            *out++ = of_column_[at(in[k])];
        }
    }
}

GrooveBand ArmFinder::best_in_direction(int direction) {
    look_along(direction);
    const Vec2& along = tried_directions()[at(direction)];
    Stretch rows{0, side_ - 1, 0};
    Stretch columns{0, side_ - 1, 0};
    // Begin with the row that is worth most: from the whole square the first sums would see mostly whole columns.
    sums_.assign(side_, 0);
    runs_.assign(side_, 0);
    for (int i = 0; i < side_; ++i) {
        const int* worth = worth_.data() + i * side_;
        for (int k = 0; k < side_; ++k) {
            runs_[k] = std::max(0, runs_[k] + worth[k]);
            sums_[k] = std::max(sums_[k], runs_[k]);
        }
    }
    columns.first = columns.last = static_cast<int>(std::max_element(sums_.begin(), sums_.end()) - sums_.begin());
    for (int round = 0; round < rounds; ++round) {
        sums_.assign(side_, 0);
        for (int i = 0; i < side_; ++i) {
            for (int k = columns.first; k <= columns.last; ++k) {
                sums_[i] += worth_[static_cast<std::size_t>(i) * side_ + k];
            }
        }
        rows = best_stretch(sums_);
        sums_.assign(side_, 0);
        for (int i = rows.first; i <= rows.last; ++i) {
            for (int k = 0; k < side_; ++k) {
                sums_[k] += worth_[static_cast<std::size_t>(i) * side_ + k];
            }
        }
        columns = best_stretch(sums_);
    }
    const int half = side_ / 2;
    const double cell = grid_.cell;
    const GrooveBand band{along,
                          (rows.first - half - 0.5) * cell,
                          (rows.last - half + 0.5) * cell,
                          (columns.first - half - 0.5) * cell,
                          (columns.last - half + 0.5) * cell,
                          static_cast<double>(columns.sum)};
    return band.high - band.low >= band.right - band.left ? band : sideways(band);
}

bool ArmFinder::is_groove(const GrooveBand& band) const {
    if (!is_long(band)) {
        return false;
    }
    int own = 0;
    std::vector<int> covered;  // cells along it
    for (const int cell : cells_) {
        if (columns_[cell] == Column::lost && band.holds(grid_.centre(cell), 0.0)) {
            ++own;
            covered.push_back(static_cast<int>((band.along_of(grid_.centre(cell)) - band.low) / grid_.cell));
        }
    }
    std::sort(covered.begin(), covered.end());
    covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
    return area(own) >= std::max(least_own_area, least_own_width * grid_.cell * static_cast<double>(covered.size()));
}

double strength(const GrooveShape& shape) { return shape.length * shape.depth_share; }

std::vector<int> lost_cells(const ColumnGrid& grid, const ColumnFill& fill) {
    std::vector<int> lost;
    for (int cell = 0; cell < grid.cells(); ++cell) {
        if (grid.inside(cell) && fill.removed[cell] > 0.0 && local_depth(grid, fill, cell) >= footprint_loss) {
            lost.push_back(cell);
        }
    }
    return lost;
}

std::vector<int> cells_in(const GrooveBand& band, double more, const ColumnGrid& grid, const std::vector<int>& lost) {
    std::vector<int> inside;
    for (const int cell : lost) {
        if (band.holds(grid.centre(cell), more)) {
            inside.push_back(cell);
        }
    }
    return inside;
}

/// Without those that other bands hold as well, ragged edges and all.
std::vector<int> alone(std::vector<int> cells, std::size_t own, const std::vector<GrooveBand>& bands,
                       const ColumnGrid& grid) {
    for (std::size_t i = 0; i < bands.size(); ++i) {
        if (i != own) {
            std::erase_if(cells, [&](int cell) { return bands[i].holds(grid.centre(cell), margin); });
        }
    }
    return cells;
}

}  // namespace

/// Middle of the columns of a band in one slice across it.
struct Slice {
    double left = HUGE_VAL;
    double right = -HUGE_VAL;
    bool shared = false;  ///< another band reaches it

    [[nodiscard]] bool counts() const { return !shared && right >= left; }
    [[nodiscard]] double middle() const { return 0.5 * (left + right); }
};

std::vector<Slice> slices_of(std::size_t own, const std::vector<GrooveBand>& bands, const ColumnGrid& grid,
                             const std::vector<int>& lost) {
    const GrooveBand& band = bands[own];
    std::vector<Slice> slices(1 + static_cast<std::size_t>((band.high - band.low) / grid.cell));
    for (const int cell : cells_in(band, margin, grid, lost)) {
        const Vec2 place = grid.centre(cell);
        const auto at = static_cast<int>(std::floor((band.along_of(place) - band.low) / grid.cell));
        if (at < 0 || at >= static_cast<int>(slices.size())) {
            continue;
        }
        slices[at].left = std::min(slices[at].left, band.across_of(place));
        slices[at].right = std::max(slices[at].right, band.across_of(place));
        for (std::size_t i = 0; i < bands.size(); ++i) {
            slices[at].shared = slices[at].shared || (i != own && bands[i].holds(place, 0.0));
        }
    }
    return slices;
}

/// A line through the middles of the slices: finer than the directions that are tried. Pointing to +y, as the direction
/// of the largest patch does.
Vec2 direction_of(const GrooveBand& band, const std::vector<Slice>& slices, double cell) {
    double count = 0.0;
    Vec2 sum = Vec2::Zero();
    double squares = 0.0;
    double products = 0.0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
        if (slices[i].counts()) {
            const Vec2 point(static_cast<double>(i) * cell, slices[i].middle());
            count += 1.0;
            sum += point;
            squares += point.x() * point.x();
            products += point.x() * point.y();
        }
    }
    double slope = 0.0;
    const double spread = count > 0.0 ? squares - sum.x() * sum.x() / count : 0.0;
    if (spread > least_spread) {
        slope = std::clamp((products - sum.x() * sum.y() / count) / spread, -steepest, steepest);
    }
    const Vec2 direction = (band.along + slope * Vec2(band.along.y(), -band.along.x())).normalized();
    return direction.y() < 0.0 ? Vec2(-direction) : direction;
}

std::vector<GrooveShape> GrooveFinder::find(const ColumnGrid& grid, const ColumnFill& fill) {
    std::vector<int> lost = lost_cells(grid, fill);
    if (lost != lost_) {
        lost_ = std::move(lost);
        bands_ = ArmFinder(grid, lost_, turned_).bands();
    }
    std::vector<GrooveShape> arms;
    for (std::size_t i = 0; i < bands_.size(); ++i) {
        const std::vector<int> cells = cells_in(bands_[i], 0.0, grid, lost_);
        const std::vector<int> own = alone(cells, i, bands_, grid);
        const Vec2 direction = direction_of(bands_[i], slices_of(i, bands_, grid, lost_), grid.cell);
        arms.push_back(shape_of(grid, fill, cells, own, direction));
    }
    std::stable_sort(arms.begin(), arms.end(),
                     [](const GrooveShape& a, const GrooveShape& b) { return strength(a) > strength(b); });
    return arms;
}

double angle_between(const GrooveShape& a, const GrooveShape& b) {
    const double cosine = std::abs(a.direction.dot(b.direction));
    const double sine = std::abs(a.direction.x() * b.direction.y() - a.direction.y() * b.direction.x());
    return std::atan2(sine, cosine);
}

}  // namespace rhexis
