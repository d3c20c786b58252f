// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to a capsular bag that is a membrane: to its opening, and to its back.
#include <algorithm>

#include "base/index.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double touch_force = 1.0;    ///< from which an instrument touches [mN]
constexpr double release_force = 0.5;  ///< below which it has let go [mN]

enum Memory : std::size_t { peak_stretch, touches, touched, memory_count };

struct Forces {
    double posterior = 0.0;  ///< largest of an instrument behind the equator [mN]
    double rim = 0.0;        ///< beside the opening [mN]
};

class SoftBagMeasures : public MeasureGroup {
public:
    explicit SoftBagMeasures(int membrane) : membrane_(membrane) {}
    [[nodiscard]] std::size_t memory_size() const override { return memory_count; }

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"bag.rim_stretch", "1",
                          "Length of an eighth of the bag's opening over that at rest, of the most stretched one."});
        schema.push_back({"bag.rim_peak_stretch", "1", "Its greatest value so far."});
        schema.push_back({"bag.rim_split", "bool", "A tear has gone from the edge of the bag's opening."});
        schema.push_back({"bag.rim_force_mN", "mN",
                          "Force of an instrument on the bag within 0.5 mm of its opening, of the strongest one."});
        schema.push_back({"bag.posterior_force_mN", "mN",
                          "Force of an instrument on the bag behind its equator, of the strongest one."});
        schema.push_back(
            {"bag.posterior_touches", "1", "Times so far that an instrument has pressed there with more than 1 mN."});
    }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override {
        const BagPlace& bag = *lens.soft_bag;
        const Forces forces = forces_on(input, lens);
        memory[peak_stretch] = std::max(memory[peak_stretch], bag.rim_stretch);
        if (forces.posterior > touch_force && memory[touched] == 0.0) {
            memory[touched] = 1.0;
            memory[touches] += 1.0;
        } else if (forces.posterior < release_force) {
            memory[touched] = 0.0;
        }
        values[0] = bag.rim_stretch;
        values[1] = memory[peak_stretch];
        values[2] = bag.rim_split ? 1.0 : 0.0;
        values[3] = forces.rim;
        values[4] = forces.posterior;
        values[5] = memory[touches];
    }

private:
    [[nodiscard]] Forces forces_on(const ObserveInput& input, const LensView& lens) const {
        const MembraneSheet& sheet = *input.state.membranes[at(membrane_)].sheet;
        std::vector<Vec3> posterior(input.tools.size(), Vec3::Zero());
        std::vector<Vec3> rim(input.tools.size(), Vec3::Zero());
        for (const Contact& contact : input.contacts) {
            if (contact.membrane != membrane_ || contact.partner != ContactPartner::tool) {
                continue;
            }
            const std::size_t tool = at(contact.partner_index);
            for (std::size_t k = 0; k < 3; ++k) {
                const int node = contact.nodes[k];
                if (node >= 0 && lens.bag_gauge->is_posterior(sheet, node)) {
                    posterior[tool] += contact.weights[k] * contact.force;
                } else if (node >= 0 && lens.bag_gauge->is_at_rim(sheet, node)) {
                    rim[tool] += contact.weights[k] * contact.force;
                }
            }
        }
        Forces most;
        for (std::size_t tool = 0; tool < posterior.size(); ++tool) {
            most.posterior = std::max(most.posterior, 1e-3 * posterior[tool].norm());
            most.rim = std::max(most.rim, 1e-3 * rim[tool].norm());
        }
        return most;
    }

    int membrane_;
};

}  // namespace

std::unique_ptr<MeasureGroup> soft_bag_measures(int membrane) { return std::make_unique<SoftBagMeasures>(membrane); }

}  // namespace rhexis
