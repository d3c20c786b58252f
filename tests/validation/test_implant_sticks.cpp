// SPDX-License-Identifier: GPL-3.0-or-later
// Haptics that were folded onto the optic stay there where the lens is tacky, and come off where it is not.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "observe/implant_place.hpp"
#include "physics/shell/shell_motion.hpp"
#include "session/build_world.hpp"
#include "session/implant_fold.hpp"

using namespace rhexis;

namespace {

/// A lens folded with its haptics on its optic, let go in viscoelastic of 10 Pa s.
class LetGo {
public:
    explicit LetGo(double tackiness_kpa) {
        SceneDescription scene = folding_scene(
            {{"implant.triangles", 400.0}, {"cartridge.tucked", 1.0}, {"implant.tackiness_kpa", tackiness_kpa}});
        Result<ImplantFold> fold = ImplantFold::create(scene);
        REQUIRE_MESSAGE(fold.ok(), fold.error().text());
        while (!fold.value().done()) {
            REQUIRE(fold.value().step().ok());
        }
        const Result<PreparedState> folded = fold.value().result();
        REQUIRE_MESSAGE(folded.ok(), folded.error().text());
        state_ = folded.value().snapshot.world.shells[0];
        scene.tissues.emplace_back("viscoelastic");
        world_ = build_world(scene).value().world;
    }

    int haptics_on_optic_after(double seconds) {
        const ShellModel& model = world_->shells[0];
        ShellContacts contacts(model);
        ShellStepper stepper = ShellStepper::create(model, "").value();
        const ShellPartners partners;
        const Vec3 weight = Vec3::Zero();
        constexpr double dt = 0.02;
        for (int i = 0; i < std::lround(seconds / dt); ++i) {
            ShellStepReport report;
            int rollbacks = 0;
            const ShellTask task{state_, partners, weight, dt};
            ShellState next = state_;
            rough_ += move_shell(stepper, contacts, task, next, report, rollbacks) == ShellMotion::balanced ? 0 : 1;
            state_ = std::move(next);
        }
        const std::array<bool, 2> on = place().on_optic;
        return static_cast<int>(std::count(on.begin(), on.end(), true));
    }

    [[nodiscard]] double unfolded() const { return place().unfolded; }
    [[nodiscard]] int rough() const { return rough_; }

private:
    [[nodiscard]] ImplantPlace place() const {
        return ImplantGauge(world_->shells[0], *world_->implant).measure(state_);
    }

    std::shared_ptr<const WorldModel> world_;
    ShellState state_;
    int rough_ = 0;
};

}  // namespace

TEST_SUITE("implant sticks") {
    TEST_CASE("let go, the lens opens; its haptics come off by themselves, and stay where 100 kPa hold them") {
        LetGo bare(0.0);
        REQUIRE(bare.haptics_on_optic_after(0.5) == 2);
        CHECK(bare.haptics_on_optic_after(11.5) == 0);
        CHECK(bare.unfolded() > 0.98);
        LetGo tacky(100.0);
        CHECK(tacky.haptics_on_optic_after(12.0) == 2);
        CHECK(tacky.unfolded() > 0.98);
        CHECK(tacky.rough() <= 5);  // of 600 steps
    }
}
