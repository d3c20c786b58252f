// SPDX-License-Identifier: GPL-3.0-or-later
// The microscope's field over the pupil, against circles worked out by hand.
#include <doctest/doctest.h>

#include <algorithm>

#include "eye/anatomy.hpp"
#include "observe/field.hpp"

using namespace rhexis;

namespace {

/// A pupil of radius 3.75 mm at height 2 without a cornea, so that it looks as it is.
EyeAnatomy bare_pupil() {
    EyeAnatomy eye;
    eye.has_cornea = false;
    eye.iris_z = 2.0;
    eye.pupil_radius = 3.75;
    return eye;
}

MicroscopeModel microscope() {
    MicroscopeModel model;
    model.field_radius = 7.0;
    model.depth_of_field = 1.5;
    return model;
}

FieldOfView field_at(const Vec3& position, const EyeAnatomy& eye = bare_pupil()) {
    return field_of_view(microscope(), MicroscopeState{position}, eye, Vec3(0.0, 0.0, eye.iris_z));
}

bool shows(const Percept& percept, const std::string& name) {
    return std::any_of(percept.landmarks.begin(), percept.landmarks.end(),
                       [&](const Landmark& mark) { return mark.name == name && mark.visible; });
}

Percept seen_from(const Vec3& position) {
    Percept percept;
    percept.landmarks = {{"pupil", true, Vec3(0.0, 0.0, 2.0), 3.75},
                         {"tear_tip", true, Vec3(2.0, 0.0, 2.0), 0.0},
                         {"hidden", false, Vec3(0.0, 0.0, 2.0), 0.0},
                         {"incision", true, Vec3(0.0, -5.0, 2.5), 1.2}};
    look_through(microscope(), MicroscopeState{position}, bare_pupil(), Vec3(0.0, 0.0, bare_pupil().iris_z), percept);
    return percept;
}

}  // namespace

TEST_SUITE("field") {
    TEST_CASE("the pupil is off by the distance of the two middles, and whole as long as its circle is inside") {
        const FieldOfView field = field_at(Vec3(-1.8, 2.4, 2.0));
        CHECK(field.pupil_offset == doctest::Approx(3.0).epsilon(1e-12));
        CHECK(field.pupil_radius == 3.75);
        CHECK(field.shows_whole_pupil());
        CHECK(field_at(Vec3(3.25, 0.0, 2.0)).shows_whole_pupil());  // touches the field's edge from inside
        CHECK_FALSE(field_at(Vec3(3.2501, 0.0, 2.0)).shows_whole_pupil());
    }

    TEST_CASE("focus is measured from the pupil's plane, and sharp within half the depth of field each way") {
        CHECK(field_at(Vec3(0.0, 0.0, 4.5)).defocus == doctest::Approx(2.5));
        CHECK(field_at(Vec3(0.0, 0.0, 4.5)).out_of_focus() == doctest::Approx(1.75));
        CHECK(field_at(Vec3(0.0, 0.0, 1.0)).defocus == doctest::Approx(-1.0));
        CHECK(field_at(Vec3(0.0, 0.0, 1.0)).out_of_focus() == doctest::Approx(0.25));
        CHECK(field_at(Vec3(0.0, 0.0, 2.75)).out_of_focus() == 0.0);
        CHECK(field_at(Vec3(0.0, 0.0, 1.25)).out_of_focus() == 0.0);
    }

    TEST_CASE("the cornea shows the pupil larger, by n / (n - P d)") {
        const EyeAnatomy eye = make_anatomy(Patient{});
        const double depth = eye.cornea_apex_z - eye.iris_z;
        const double wanted = 1.336 / (1.336 - 0.336 / eye.cornea_radius * depth);
        CHECK(field_at(Vec3::Zero(), eye).pupil_radius / eye.pupil_radius == doctest::Approx(wanted).epsilon(1e-12));
        CHECK(wanted > 1.05);
        CHECK(wanted < 1.2);
    }

    TEST_CASE("what lies outside of the field is not seen, but a part of the pupil is, and wounds are felt") {
        const Percept whole = seen_from(Vec3(0.0, 0.0, 4.0));
        CHECK(shows(whole, "tear_tip"));
        CHECK_FALSE(shows(whole, "hidden"));
        REQUIRE(whole.field.has_value());
        CHECK(whole.field->radius == 7.0);
        CHECK(whole.field->out_of_focus == doctest::Approx(1.25));
        const Percept aside = seen_from(Vec3(-5.5, 0.0, 2.0));  // the tear is 7.5 mm from its middle
        CHECK_FALSE(shows(aside, "tear_tip"));
        CHECK(shows(aside, "pupil"));
        CHECK(shows(aside, "incision"));
        CHECK_FALSE(shows(seen_from(Vec3(-10.8, 0.0, 2.0)), "pupil"));
    }
}
