// SPDX-License-Identifier: GPL-3.0-or-later
// Lids, lashes and the test of the pedal.
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double enough_s = 0.3;  ///< of each position, for it to be seen that it does what it is to do [s]. Proposal

class LidsMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"lids.covered_percent", "%", "Lashes that are under a drape."});
        schema.push_back({"lids.opening", "1", "How far a speculum has opened the lids, 0 to 1."});
        schema.push_back({"lids.drip_ml_min", "ml/min", "Infusion that runs out of a tip in the air."});
        schema.push_back({"lids.pedal_1_s", "s", "Time with the tip in the air in which pedal 1 let infusion run."});
        schema.push_back({"lids.pedal_2_s", "s", "The same: pedal 2 aspirated as well."});
        schema.push_back({"lids.pedal_3_s", "s", "The same: pedal 3 gave ultrasound as well."});
        schema.push_back({"lids.pedal_tested", "bool", "All three were seen to do so for 0.3 s."});
    }
    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const LidsState& lids = *input.state.lids;
        values[0] = 100.0 * covered_share(lids);
        values[1] = lids.opening;
        values[2] = lids.drip / mm3_s_per_ml_min;
        bool all = true;
        for (std::size_t i = 0; i < lids.tested.size(); ++i) {
            values[3 + i] = lids.tested[i];
            all = all && lids.tested[i] >= enough_s;
        }
        values[6] = all ? 1.0 : 0.0;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> lids_measures() { return std::make_unique<LidsMeasures>(); }

}  // namespace rhexis
