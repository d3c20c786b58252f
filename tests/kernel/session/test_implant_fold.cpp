// SPDX-License-Identifier: GPL-3.0-or-later
// Folding an implant into a cartridge: what is refused, that the lens ends in the cartridge, and that a run begins with
// it.
#include <doctest/doctest.h>

#include "session/folding_device.hpp"
#include "session/implant_fold.hpp"

using namespace rhexis;

namespace {

std::string error_of(const std::map<std::string, double>& settings) {
    const Result<ImplantFold> fold = ImplantFold::create(folding_scene(settings));
    return fold.ok() ? "" : fold.error().text();
}

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

ImplantFold fold_of(const std::map<std::string, double>& settings) {
    Result<ImplantFold> fold = ImplantFold::create(folding_scene(settings));
    REQUIRE_MESSAGE(fold.ok(), fold.error().text());
    return std::move(fold).value();
}

const std::map<std::string, double> coarse{{"implant.triangles", 400.0}};

}  // namespace

TEST_SUITE("implant fold") {
    TEST_CASE("what cannot be folded is refused in one line that says what is allowed") {
        CHECK(holds(error_of({{"cartridge.bore_mm", 1.8}, {"cartridge.nozzle_mm", 1.8}}),
                    "cartridge.bore_mm is 1.8, too small for the implant (at least 2.4"));
        CHECK(holds(error_of({{"implant.haptic_mm", -0.1}}), "implant.haptic_mm is -0.1 (0.05 to 1)"));
        CHECK(holds(error_of({{"implant.edge_mm", 0.8}}), "edge_thickness is 0.8 (0.05 to 0.7 mm)"));
        CHECK(holds(error_of({{"cartridge.nozzle_mm", 3.0}}), "nozzle is 3 (1 to 2.8 mm)"));
    }

    TEST_CASE("a thinner lens goes into a narrower bore") {
        const std::map<std::string, double> thin{
            {"implant.centre_mm", 0.3}, {"implant.edge_mm", 0.15}, {"implant.haptic_mm", 0.2}};
        std::map<std::string, double> narrow = thin;
        narrow["cartridge.bore_mm"] = narrow["cartridge.nozzle_mm"] = 1.8;
        CHECK(error_of(narrow).empty());
    }

    TEST_CASE("a lens that was never folded sticks out of the cartridge") {
        const ImplantFold fold = fold_of(coarse);
        const Result<PreparedState> result = fold.result();
        REQUIRE_FALSE(result.ok());
        CHECK(holds(result.error().text(), "sticks out of the cartridge's chamber by "));
    }

    TEST_CASE(
        "inverted, a lens lies on its front in the folding device and comes to lie the same way up in its injector") {
        const auto device_of = [](bool inverted) {
            InjectorShape cartridge;
            cartridge.inverted = inverted;
            return FoldingDevice(ImplantShape{}, cartridge);
        };
        const Cartridge cartridge = *injector(InjectorShape{}).cartridge;
        ShellState flat;
        flat.position = {Vec3(1.0, 2.0, 0.1), Vec3(-0.5, 3.0, 0.0), Vec3(2.0, -1.0, -0.1)};
        flat.rotation.assign(3, Quat::Identity());
        flat.velocity.assign(3, Vec3::Zero());
        flat.spin.assign(3, Vec3::Zero());
        const ShellState on_front = device_of(true).laid_out(flat);
        CHECK(on_front.position[0].isApprox(Vec3(-1.0, 2.0, -0.1)));
        CHECK((on_front.rotation[0] * Vec3::UnitZ()).isApprox(-Vec3::UnitZ()));
        CHECK(device_of(false).laid_out(flat).position == flat.position);
        const ShellState plain = device_of(false).laid_in(cartridge, flat);
        const ShellState inverted = device_of(true).laid_in(cartridge, on_front);
        const Vec3 apart = inverted.position[0] - plain.position[0];
        for (std::size_t n = 0; n < 3; ++n) {
            CHECK(inverted.rotation[n].toRotationMatrix().isApprox(plain.rotation[n].toRotationMatrix()));
            CHECK((inverted.position[n] - plain.position[n]).isApprox(apart));
        }
    }
}
