// SPDX-License-Identifier: GPL-3.0-or-later
// A stand, an eye to look at and hands over it, without a session.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "station/hands.hpp"

namespace rhexis::station {

inline EyeAnatomy an_eye() {
    EyeAnatomy eye;
    eye.cornea_apex_z = 4.0;
    return eye;
}

inline Camera above() {
    Camera camera;
    camera.field_mm = 14.6;
    return camera;
}

/// Phaco, spatula, forceps, injector, in this order, and a microscope.
inline Stand a_stand() {
    Stand stand;
    stand.instruments = {{"phaco", Squeeze::nothing, 0.0, true},
                         {"spatula", Squeeze::nothing, 0.0, true},
                         {"forceps", Squeeze::closes, 4.0, true},
                         {"injector", Squeeze::pushes, 0.3, true},
                         {"microscope", Squeeze::nothing, 0.0, false}};
    stand.dials = {{"machine.vacuum_mmhg", "mmHg", 0.0, 650.0, 10.0, 80.0}};
    stand.requests = {{"bottle_down", "Bottle down"}, {"help", "Help"}};
    return stand;
}

inline Surroundings around_the_eye() {
    const EyeAnatomy eye = an_eye();
    Percept percept;
    percept.landmarks = {{"incision", true, Vec3(0.0, -5.0, 1.5), 1.2}, {"side_port", true, Vec3(-5.0, 0.0, 1.5), 0.5}};
    return {Sight(above(), &eye, nullptr, nullptr), percept, Vec3(0.0, 0.0, 1.0)};
}

/// What stands in assets/station.
inline Mapping standard(bool pad, bool left = false) {
    Result<Mapping> mapping = Mapping::read(standard_mapping(".", pad, left));
    REQUIRE(mapping.ok());
    return std::move(mapping).value();
}

inline UserEvent key(const std::string& name, double value) { return {EventKind::key, name, value, 0.0, 0.0}; }

/// A desk with hands over it.
struct DeskScene {
    Mapping mapping;
    Stand stand = a_stand();
    HoldScript holds;
    Surroundings around = around_the_eye();
    Hands hands;

    explicit DeskScene(bool pad = false) : mapping(standard(pad)), holds(loaded()), hands(mapping, stand, holds) {}
    DeskScene(const DeskScene&) = delete;
    DeskScene& operator=(const DeskScene&) = delete;

    static HoldScript loaded() {
        Result<HoldScript> script = HoldScript::load(".");
        REQUIRE(script.ok());
        return std::move(script).value();
    }

    void take(const UserEvent& event) { hands.take(event, around); }
    void press(const std::string& name) {
        take(key(name, 1.0));
        take(key(name, 0.0));
    }
    void advance(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / 0.01 + 0.5); ++i) {
            REQUIRE(hands.advance(around, 0.01).ok());
        }
    }
    [[nodiscard]] const HandState& hand(int which) const {
        return hands.state().hands[static_cast<std::size_t>(which)];
    }
    [[nodiscard]] DeviceSample sample(int instrument) const {
        return hands.samples(around, 0.01)[static_cast<std::size_t>(instrument)];
    }
};

}  // namespace rhexis::station
