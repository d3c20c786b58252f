// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of a shell that stick to each other.
#include "physics/shell/tack.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "scenes/shell_account.hpp"
#include "support/finite_difference.hpp"
#include "support/sanitized.hpp"

using namespace rhexis;

namespace {

constexpr double area = 4.0;  ///< of the plates [mm^2]

/// One plate on another that is held, a little apart.
ShellModel two_plates(double tack) {
    ShellModel model = scenes::plates({{2.0, 0.2, 4, 0.1}, {2.0, 0.2, 4, 0.301}});
    for (int n = 0; n < 25; ++n) {
        model.holds.push_back({n});
    }
    model.material.young_modulus = 3e7;  // stiff: the gap is the same all over
    model.tack = tack;
    model.damping_mass = 2e3;
    return model;
}

/// The upper of the two, and what draws it.
class Pulled {
public:
    explicit Pulled(const ShellModel& model) : model_(model), shell_(model_, accounted()), account_(model_) {
        shell_.settings = {.tolerance = 1e-4, .max_newton = 100, .newton_tolerance = 1e-8, .most_travel = 0.05};
    }

    /// Evenly up to a force in so many steps [uN], negative: it presses.
    void draw(double force, int steps) {
        ShellLoad load;
        const double before = force_;
        for (int i = 1; i <= steps; ++i) {
            force_ = before + (force - before) * i / steps;
            load.force.assign(50, Vec3::Zero());
            for (std::size_t n = 25; n < 50; ++n) {
                load.force[n].z() = force_ * share(n);
            }
            const ShellStepEnergy e = account_.step(shell_, ShellPartners{}, load, Vec3::Zero(), 1e-3);
            CHECK(e.gain + e.contact <= e.external + std::abs(e.renewed) + 1e-6 * account_.brought + 1e-9);
        }
    }

    [[nodiscard]] double gap() const {
        double sum = 0.0;
        for (std::size_t n = 25; n < 50; ++n) {
            sum += (shell_.state.position[n].z() - 0.3) / 25.0;
        }
        return sum;
    }
    [[nodiscard]] const scenes::ShellAccount& account() const { return account_; }
    [[nodiscard]] const ShellState& state() const { return shell_.state; }
    [[nodiscard]] double stored() const { return shell_.contacts.work().stored; }

private:
    static ShellContactSettings accounted() {
        ShellContactSettings settings;
        settings.accounts = true;
        return settings;
    }
    /// Evenly over the area: so that the plate stays flat.
    [[nodiscard]] double share(std::size_t node) const {
        double sum = 0.0;
        for (const std::array<int, 3>& t : model_.mesh.triangles) {
            for (const int n : t) {
                sum += static_cast<std::size_t>(n) == node
                           ? triangle_area(model_.mesh.nodes[static_cast<std::size_t>(t[0])],
                                           model_.mesh.nodes[static_cast<std::size_t>(t[1])],
                                           model_.mesh.nodes[static_cast<std::size_t>(t[2])]) /
                                 3.0
                           : 0.0;
            }
        }
        return sum / area;
    }

    ShellModel model_;
    scenes::TouchingShell shell_;
    scenes::ShellAccount account_;
    double force_ = 0.0;
};

}  // namespace

TEST_SUITE("tack") {
    TEST_CASE("pull and slope are derivatives of the energy; greatest at a third, nothing beyond the range") {
        const Tack tack{1500.0, 0.02};
        for (const double gap : {1e-4, 0.004, 0.0066, 0.01, 0.019}) {
            const VecX x = VecX::Constant(1, gap);
            const auto energy = [&](const VecX& at) { return VecX(VecX::Constant(1, tack_at(tack, at[0]).energy)); };
            const auto pull = [&](const VecX& at) { return VecX(VecX::Constant(1, tack_at(tack, at[0]).pull)); };
            const TackPull here = tack_at(tack, gap);
            CHECK(rhexis::test::derivative_error(energy, x, MatX::Constant(1, 1, here.pull), 1e-6) < 1e-6);
            CHECK(rhexis::test::derivative_error(pull, x, MatX::Constant(1, 1, here.slope), 1e-6) < 1e-6);
        }
        CHECK(tack_at(tack, 0.02 / 3.0).pull == doctest::Approx(1500.0));
        CHECK(std::abs(tack_at(tack, 0.02 / 3.0).slope) < 1e-6);
        CHECK(tack_at(tack, 1.0).energy == doctest::Approx(9.0 / 16.0 * 1500.0 * 0.02));
        for (const double gap : {-0.01, 0.0, 0.02, 1.0}) {
            CHECK(tack_at(tack, gap).pull == 0.0);
        }
        CHECK(tack_at(tack, -1.0).energy == 0.0);
    }

    TEST_CASE("plates that were pressed together part at the traction times their area, and not before" *
              doctest::skip(rhexis::testing::sanitized)) {
        for (const double tack : {200.0, 5000.0}) {
            CAPTURE(tack);
            Pulled pair(two_plates(tack));
            pair.draw(-50.0, 50);
            REQUIRE(pair.gap() < 0.0);
            pair.draw(0.97 * tack * area, 200);
            pair.draw(0.97 * tack * area, 50);
            CHECK(pair.gap() < 0.02 / 3.0);
            CHECK(pair.gap() > 0.5 * 0.02 / 3.0);
            CHECK(pair.account().unbalanced == 0);
            pair.draw(1.03 * tack * area, 20);
            pair.draw(1.03 * tack * area, 20);
            CHECK(pair.gap() > 0.02);
            CHECK(pair.stored() == 0.0);
            CHECK(pair.state().touches.empty());
        }
    }

    TEST_CASE("without tackiness they part at nothing, and with it where they never touched") {
        Pulled bare(two_plates(0.0));
        bare.draw(-50.0, 50);
        REQUIRE(bare.gap() < 0.0);
        bare.draw(10.0, 100);
        CHECK(bare.gap() > 0.02);
        Pulled apart(two_plates(5000.0));
        apart.draw(10.0, 100);
        CHECK(apart.gap() > 0.02);
    }

    TEST_CASE("the ledger finds again what was brought; parting takes what the law says") {
        const double tack = 2000.0;
        Pulled pair(two_plates(tack));
        pair.draw(-50.0, 50);
        pair.draw(1.05 * tack * area, 210);
        REQUIRE(pair.gap() > 0.02);
        const scenes::ShellAccount& account = pair.account();
        CHECK(account.unbalanced == 0);
        CHECK(std::abs(account.sum.rest) < 1e-6 * account.brought);
        CHECK(account.brought > 9.0 / 16.0 * tack * 0.02 * area);
        CHECK(account.sum.contact == doctest::Approx(0.0));
    }
}
