// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of the lens and its crumbs.
#include <algorithm>
#include <numeric>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class FragmentMeasures : public MeasureGroup {
public:
    explicit FragmentMeasures(bool bag) : bag_(bag) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"fragments.count", "1", "Pieces that the lens is in; 1: it is whole."});
        schema.push_back({"fragments.largest_mm3", "mm^3", "Volume of the largest."});
        schema.push_back({"fragments.left_mm3", "mm^3", "Volume of all, with the crumbs."});
        schema.push_back({"fragments.left_share", "1", "That volume as a share of the whole lens."});
        schema.push_back({"fragments.crumbs", "1", "Crumbs that drift about."});
        schema.push_back({"fragments.highest_mm", "mm", "Highest point of any piece over the lens equator at rest."});
        if (bag_) {
            schema.push_back({"fragments.sunk_mm", "mm",
                              "How far the middle of the deepest piece is behind the posterior capsule; 0: none is."});
        }
    }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double>,
                 std::span<double> values) const override {
        double largest = 0.0;
        double left = 0.0;
        double highest = -1e9;
        double lowest = 1e9;
        for (const LensPiece& piece : *lens.pieces) {
            largest = std::max(largest, piece.volume);
            left += piece.volume;
            highest = std::max(highest, piece.highest);
            lowest = std::min(lowest, piece.centre.z());
        }
        for (const Debris& crumb : input.state.debris) {
            left += crumb.volume;
        }
        values[0] = static_cast<double>(lens.pieces->size());
        values[1] = largest;
        values[2] = left;
        const std::vector<double>& whole = lens.fill->fine_volumes;
        values[3] = left / std::accumulate(whole.begin(), whole.end(), 0.0);
        values[4] = static_cast<double>(input.state.debris.size());
        values[5] = lens.pieces->empty() ? 0.0 : highest;
        if (bag_) {
            const double back = input.state.bags[0].pose.position.z() - input.world.bags[0].shape.posterior;
            values[6] = lens.pieces->empty() ? 0.0 : std::max(0.0, back - lowest);
        }
    }

private:
    bool bag_;
};

}  // namespace

std::unique_ptr<MeasureGroup> fragment_measures(bool bag) { return std::make_unique<FragmentMeasures>(bag); }

}  // namespace rhexis
