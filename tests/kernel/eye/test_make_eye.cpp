// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "eye/anatomy.hpp"
#include "eye/capsular_bag.hpp"
#include "eye/make_eye.hpp"
#include "eye/patient.hpp"
#include "eye/table.hpp"
#include "eye/tissue.hpp"
#include "mesh/quality.hpp"

using namespace rhexis;

namespace {

EyeModel eye_of(const Patient& patient) {
    Result<EyeModel> eye = make_eye(patient);
    REQUIRE(eye.ok());
    return std::move(eye).value();
}

Patient small_patient(double age, double grade) {
    Patient patient;
    patient.age = age;
    patient.nuclear_grade = grade;
    patient.tetrahedra = 500;
    return patient;
}

std::string fault(const Patient& patient) {
    const Result<EyeModel> eye = make_eye(patient);
    return eye.ok() ? "" : eye.error().text();
}

}  // namespace

TEST_SUITE("eye") {
    TEST_CASE("the default patient's lens has its measured size, 2,900 to 3,100 tetrahedra and three tissues") {
        const EyeModel eye = eye_of(Patient{});
        const TetMesh& mesh = eye.lens.coarse;
        CHECK(mesh.tets.size() >= 2900);
        CHECK(mesh.tets.size() <= 3100);
        CHECK(eye.lens.fine.tets.size() == 8 * mesh.tets.size());
        Vec3 low = mesh.nodes[0];
        Vec3 high = mesh.nodes[0];
        for (const Vec3& x : mesh.nodes) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        CHECK(high.x() - low.x() == doctest::Approx(9.64).epsilon(0.01));
        CHECK(high.z() - low.z() == doctest::Approx(4.56).epsilon(0.01));
        CHECK(high.z() / -low.z() == doctest::Approx(0.70).epsilon(0.01));
        std::array<double, 3> volume{};
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            volume[static_cast<std::size_t>(mesh.region[t])] += tet_mass(eye.lens, static_cast<int>(t)) / 1.05e-3;
        }
        const double whole = volume[0] + volume[1] + volume[2];
        CHECK(volume[nucleus] / whole == doctest::Approx(std::pow(nucleus_scale(Patient{}), 3)).epsilon(0.05));
        CHECK(volume[cortex] / whole == doctest::Approx(1 - std::pow(epinucleus_scale(Patient{}), 3)).epsilon(0.1));
        CHECK(eye.lens.fixed_nodes.empty());
    }

    TEST_CASE("the nucleus takes the stiffer of the age rule and the grade rule") {
        CHECK(nucleus_modulus(small_patient(20, 1)) == 2000.0);
        CHECK(nucleus_modulus(small_patient(40, 1)) == doctest::Approx(3000.0));
        CHECK(nucleus_modulus(small_patient(75, 2)) == 5000.0);
        CHECK(nucleus_modulus(small_patient(68, 3)) == 5000.0);
        CHECK(nucleus_modulus(small_patient(68, 4)) == 12000.0);
        CHECK(nucleus_modulus(small_patient(68, 4.5)) == doctest::Approx(std::sqrt(12000.0 * 30000.0)).epsilon(1e-12));
        CHECK(nucleus_modulus(small_patient(68, 6)) == 80000.0);
    }

    TEST_CASE("tissues grow softer, clearer and easier to emulsify from the nucleus outward") {
        for (double grade : {1.0, 2.3, 3.0, 4.0, 5.5, 6.0}) {
            const std::vector<Material> tissue = lens_materials(small_patient(68, grade));
            REQUIRE(tissue.size() == 3);
            for (std::size_t i = 0; i < 2; ++i) {
                CHECK(tissue[i].young_modulus > tissue[i + 1].young_modulus);
                CHECK(tissue[i].ablation_energy > tissue[i + 1].ablation_energy);
                CHECK((tissue[i].extinction.array() > tissue[i + 1].extinction.array()).all());
            }
            for (const Material& material : tissue) {
                CHECK(material.extinction.x() < material.extinction.y());
                CHECK(material.extinction.y() < material.extinction.z());
                CHECK(material.poisson_ratio <= 0.49);
                CHECK(material.poisson_ratio >= 0.45);
            }
        }
        CHECK(lens_materials(small_patient(68, 4))[nucleus].extinction == Vec3(0.15, 0.30, 0.70));
    }

    TEST_CASE("the ring of zonules resists axial motion with the stiffness of its age") {
        const std::array<std::array<double, 2>, 5> expected{
            {{50, 22000}, {60, 22000}, {66.5, 19250}, {73, 16500}, {95, 14000}}};
        for (const auto& [age, stiffness] : expected) {
            const EyeModel eye = eye_of(small_patient(age, 3));
            // Measured as a machine would: the force at a small displacement of the bag, over that displacement.
            for (double shift : {1e-4, -1e-4}) {
                Pose pose;
                pose.position.z() = shift;
                Vec3 force = Vec3::Zero();
                for (const ZonuleSpring& spring : eye.bag.zonules) {
                    force += zonule_force(spring, pose);
                }
                CHECK(-force.z() / shift == doctest::Approx(stiffness).epsilon(1e-3));
                CHECK(force.head<2>().norm() < 1e-6 * std::abs(force.z()));
            }
            const double across = suspension_stiffness(eye.bag, Vec3::UnitX());
            CHECK(across == doctest::Approx(suspension_stiffness(eye.bag, Vec3::UnitY())).epsilon(1e-12));
            CHECK(across > stiffness);  // the zonules run mostly outward
        }
    }

    TEST_CASE("zonules are at rest with the bag and strain as it moves") {
        const EyeModel eye = eye_of(small_patient(68, 3));
        CHECK(eye.bag.zonules.size() == 48);
        Pose moved;
        moved.position = Vec3(0.3, 0, 0);
        double most = 0.0;
        for (const ZonuleSpring& spring : eye.bag.zonules) {
            CHECK(zonule_force(spring, Pose{}).norm() == 0.0);
            CHECK(zonule_strain(spring, Pose{}) == doctest::Approx(0.0));
            most = std::max(most, zonule_strain(spring, moved));
        }
        CHECK(most > 0.05);
        CHECK(most < 0.3);
    }

    TEST_CASE("the insertions of the zonules lie on the bag") {
        const EyeModel eye = eye_of(small_patient(68, 3));
        for (const ZonuleSpring& spring : eye.bag.zonules) {
            CHECK(std::abs(bag_distance(eye.bag.shape, spring.on_bag).distance) < 1e-12);
            CHECK(bag_distance(eye.bag.shape, spring.on_ciliary).distance == doctest::Approx(1.25));
        }
    }

    TEST_CASE("the lens lies free in its bag, with a clearance all round") {
        const EyeModel eye = eye_of(Patient{});
        double closest = 1e300;
        for (const Vec3& x : eye.lens.coarse.nodes) {
            closest = std::min(closest, -bag_distance(eye.bag.shape, x).distance);
        }
        CHECK(closest == doctest::Approx(0.03).epsilon(0.01));
        CHECK(eye.bag.opening_radius == 2.6);
    }

    TEST_CASE("cornea, limbus, iris and lens lie in order along the axis") {
        for (double age : {20.0, 45.0, 68.0, 95.0}) {
            for (double pupil : {3.0, 5.0, 7.5, 9.0}) {
                CAPTURE(age);
                CAPTURE(pupil);
                Patient patient = small_patient(age, 3);
                patient.pupil_mm = pupil;
                const EyeAnatomy eye = make_anatomy(patient);
                const HalfEllipsoids lens = lens_shape(patient);
                CHECK(eye.cornea_apex_z - lens.anterior == doctest::Approx(eye.anterior_chamber_depth));
                CHECK(eye.limbus_z < eye.cornea_apex_z);
                // The back of the iris is just in front of the lens where the pupil ends.
                const double back = eye.iris_z - 0.5 * eye.iris_thickness;
                CHECK(back > anterior_z(lens, eye.pupil_radius) + 0.05);
                CHECK(back < anterior_z(lens, eye.pupil_radius) + 0.2);
                CHECK(eye.iris_z < eye.limbus_z + 0.25);  // bowed forward by an old lens in a small pupil
                CHECK(eye.incision.y() < -eye.pupil_radius + 0.5);
                CHECK(eye.incision.z() > eye.iris_z);
                CHECK(eye.incision.z() < eye.cornea_apex_z - eye.cornea_thickness);
                // The side port: at the surgeon's left, 60 to 100 degrees from the main wound.
                const Vec2 port = eye.side_port.head<2>();
                const double apart = std::acos(port.normalized().dot(eye.incision.head<2>().normalized()));
                CHECK(apart > 60.0 * 3.14159265 / 180.0);
                CHECK(apart < 100.0 * 3.14159265 / 180.0);
                CHECK(port.x() < 0.0);
                CHECK(port.norm() < eye.limbus_radius - 0.5);
                CHECK(eye.side_port.z() > eye.iris_z);
            }
        }
        CHECK(make_anatomy(Patient{}).anterior_chamber_depth == doctest::Approx(3.02).epsilon(0.01));
    }

    TEST_CASE("a patient out of range is refused with field, value and range") {
        Patient patient;
        patient.age = 12;
        CHECK(fault(patient) == "patient: age is 12 (20 to 95 years)");
        patient = Patient{};
        patient.pupil_mm = std::numeric_limits<double>::quiet_NaN();
        CHECK(fault(patient) == "patient: pupil_mm is nan (3 to 9 mm)");
        patient = Patient{};
        patient.nuclear_grade = 6.5;
        CHECK(fault(patient) == "patient: nuclear_grade is 6.5 (1 to 6)");
        patient = Patient{};
        patient.side = "middle";
        CHECK(fault(patient) == "patient: side is \"middle\" (\"right\" or \"left\")");
        patient = Patient{};
        patient.tetrahedra = 100000;
        CHECK(fault(patient) == "patient: tetrahedra is 100000 (500 to 24000)");
    }

    TEST_CASE("tables give their rows, their ends outside, and means between") {
        constexpr std::array<TableRow, 3> rows{{{1, 2}, {2, 8}, {4, 16}}};
        CHECK(linear_between(rows, 0) == 2);
        CHECK(linear_between(rows, 2) == 8);
        CHECK(linear_between(rows, 3) == 12);
        CHECK(linear_between(rows, 9) == 16);
        CHECK(geometric_between(rows, 1.5) == doctest::Approx(4.0).epsilon(1e-14));
        for (double share : {0.1, 0.3, 0.77, 0.999}) {
            CHECK(geometric_between(rows, 1 + share) == doctest::Approx(2 * std::pow(4.0, share)).epsilon(1e-13));
        }
    }
}
