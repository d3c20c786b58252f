// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "eye/empty_bag.hpp"
#include "flow/microscope.hpp"
#include "session/build_world.hpp"
#include "session/settings.hpp"
#include "tools/instruments.hpp"

namespace rhexis {
namespace {

const auto known_tissues = std::to_array<std::string>(
    {"lens", "bag", "capsule", "anterior_capsule", "iris", "cornea", "chamber", "viscoelastic", "implant", "vitreous",
     "globe", "wounds", "zonules", "hydrodissection", "cortex", "retained_viscoelastic", "lids", "beads"});
const std::array<std::string, 3> known_instruction_sets{"baseline", "avx2", "avx512"};

Status check_names(const char* field, const std::vector<std::string>& names, std::span<const std::string> known) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::find(known.begin(), known.end(), names[i]) == known.end()) {
            return Error{std::string(field) + " names " + names[i], "", suggestion(names[i], known)};
        }
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
            names.begin() + static_cast<std::ptrdiff_t>(i)) {
            return Error{std::string(field) + " names " + names[i] + " twice", "", "each once"};
        }
    }
    return success();
}

Status check_patient(const Patient& patient) {
    for (const Status& status : {check_range("patient.age", patient.age, 20.0, 95.0),
                                 check_range("patient.nuclear_grade", patient.nuclear_grade, 1.0, 6.0),
                                 check_range("patient.cortical_opacity", patient.cortical_opacity, 0.0, 1.0),
                                 check_range("patient.pupil_mm", patient.pupil_mm, 3.0, 9.0),
                                 check_range("patient.tetrahedra", patient.tetrahedra, 500.0, 24000.0)}) {
        if (!status) {
            return status;
        }
    }
    if (patient.side != "right" && patient.side != "left") {
        return Error{"patient.side is " + patient.side, "", "right or left"};
    }
    return success();
}

Status check_instruction_set(const std::string& name) {
    const bool known = name.empty() || std::find(known_instruction_sets.begin(), known_instruction_sets.end(), name) !=
                                           known_instruction_sets.end();
    return known ? success()
                 : Status(Error{"instruction_set is " + name, "", suggestion(name, known_instruction_sets)});
}

/// The opening of a bag that is a membrane.
Status check_bag(const SceneDescription& scene) {
    const bool soft = has_tissue(scene, "implant") && has_tissue(scene, "bag");
    if (!scene.opening.empty() && !soft) {
        return Error{"an opening is given, but the scene has no bag that one is torn in", "",
                     "a scene with the tissues implant and bag"};
    }
    return check_opening(scene.opening);
}

Status check_settings(const SceneDescription& scene) {
    for (const auto& [name, value] : scene.settings) {
        Status status = check_setting(name, value);
        if (!status) {
            return status;
        }
    }
    return success();
}

/// Instruments before it have the numbers of tools, and it shows how it stands over the pupil.
Status check_microscope(const SceneDescription& scene) {
    const auto found = std::find(scene.instruments.begin(), scene.instruments.end(), microscope_name);
    if (found == scene.instruments.end()) {
        return success();
    }
    if (found + 1 != scene.instruments.end()) {
        return Error{"instruments names microscope before " + *(found + 1), "", "last"};
    }
    if (std::find(scene.tissues.begin(), scene.tissues.end(), "iris") == scene.tissues.end()) {
        return Error{"instruments names microscope, but tissues no iris", "", "both: it is centred on the pupil"};
    }
    return success();
}

/// What fills the bag between the steps that are simulated in full.
Status check_bag_contents(const SceneDescription& scene) {
    if (has_tissue(scene, "hydrodissection") &&
        !(has_tissue(scene, "lens") && has_tissue(scene, "capsule") && has_tissue(scene, "chamber"))) {
        return Error{"tissues names hydrodissection without lens, capsule and chamber", "",
                     "all four: saline parts the lens from the capsule and comes out into the chamber"};
    }
    for (const char* name : {"cortex", "retained_viscoelastic"}) {
        if (!has_tissue(scene, name)) {
            continue;
        }
        if (!has_tissue(scene, "capsule") || !has_tissue(scene, "chamber")) {
            return Error{std::string("tissues names ") + name + " without capsule and chamber", "",
                         "all three: it is aspirated out of the bag"};
        }
        if (has_tissue(scene, "lens")) {
            return Error{std::string("tissues names ") + name + " with lens", "",
                         "the one or the other: the lens has left the bag"};
        }
    }
    for (const auto& [tissue, instrument] :
         {std::pair{"hydrodissection", "saline_cannula"}, std::pair{"cortex", "ia_tip"},
          std::pair{"retained_viscoelastic", "ia_tip"}}) {
        if (has_tissue(scene, tissue) &&
            std::find(scene.instruments.begin(), scene.instruments.end(), instrument) == scene.instruments.end()) {
            return Error{std::string("tissues names ") + tissue + ", but instruments no " + instrument, "", "both"};
        }
    }
    return success();
}

/// What parts need of each other, and of the way of stepping.
Status check_combination(const SceneDescription& scene) {
    const auto named = [&](const char* name) {
        return std::find(scene.tissues.begin(), scene.tissues.end(), name) != scene.tissues.end();
    };
    if (named("vitreous") && !(named("capsule") && named("chamber"))) {
        return Error{"tissues names vitreous without capsule and chamber", "",
                     "all three: it comes forward through the one into the other"};
    }
    if (named("globe") && !named("cornea")) {
        return Error{"tissues names globe without cornea", "", "both: shafts turn the globe by the cornea"};
    }
    if (named("wounds") && !(named("cornea") && named("chamber"))) {
        return Error{"tissues names wounds without cornea and chamber", "",
                     "all three: a wound goes through the one into the other"};
    }
    if (const double angle = std::abs(all_settings(scene).at("side_port.angle_deg")); named("wounds") && angle < 30.0) {
        return Error{"settings.side_port.angle_deg is " + short_number(angle) + " from the main wound", "",
                     "30 to 150, or -150 to -30: the wounds must not run into each other"};
    }
    if (Status status = check_bag_contents(scene); !status) {
        return status;
    }
    if (named("lids") && !named("cornea")) {
        return Error{"tissues names lids without cornea", "", "both: lids lie on the eye"};
    }
    if (named("beads") && named("chamber")) {
        return Error{"tissues names beads with chamber", "", "beads alone: they lie in viscoelastic that stays"};
    }
    if (const auto beads = scene.settings.find("beads.count");
        beads != scene.settings.end() && std::fmod(beads->second, 1.0) != 0.0) {
        return Error{"settings.beads.count is " + short_number(beads->second), "", "a whole number, 1 to 6"};
    }
    if (named("capsule") && !named("bag")) {
        return Error{"tissues names capsule without bag", "", "both: the posterior capsule is a part of the bag"};
    }
    if (named("zonules") && (!named("bag") || named("implant"))) {
        return Error{"tissues names zonules " + std::string(named("implant") ? "with implant" : "without bag"), "",
                     "zonules with a bag that a lens lies in, or lay: those of an implant's bag do not break"};
    }
    for (const char* instrument : {"capsule_hook", "ring"}) {
        if (std::find(scene.instruments.begin(), scene.instruments.end(), instrument) != scene.instruments.end() &&
            !named("zonules")) {
            return Error{std::string("instruments names ") + instrument + ", but tissues no zonules", "",
                         "both: it stands in for zonules that are lost"};
        }
    }
    for (const char* other : {"lens", "bag"}) {
        if (named("anterior_capsule") && named(other)) {
            return Error{std::string("tissues names anterior_capsule with ") + other, "",
                         "the one or the other: a lens that is operated on has its capsule open, by "
                         "capsulorhexis.diameter_mm"};
        }
    }
    for (const char* other : {"lens", "anterior_capsule"}) {
        if (named("implant") && named(other)) {
            return Error{std::string("tissues names implant with ").append(other), "",
                         "the one or the other: an implant lies where the lens was"};
        }
    }
    if (named("implant") && named("capsule")) {
        return Error{"tissues names implant with capsule", "",
                     "implant with bag: the wall of a bag that holds an implant is all simulated"};
    }
    if (named("implant") && named("bag") && !injects(scene)) {
        return Error{"tissues names implant with bag, but instruments no injector", "",
                     "all three: an implant comes into a bag through an injector"};
    }
    if (named("viscoelastic") && named("chamber")) {
        return Error{"tissues names viscoelastic with chamber", "",
                     "viscoelastic that stays, or chamber: fluid that flows"};
    }
    const auto segments = scene.settings.find("nucleus.segments");
    if (segments != scene.settings.end() && std::fmod(segments->second, 2.0) != 0.0) {
        return Error{"settings.nucleus.segments is " + short_number(segments->second), "", "0, 2, 4, 6 or 8"};
    }
    const auto trench = scene.settings.find("nucleus.trench_mm");
    if (trench != scene.settings.end() && trench->second > 0.0 &&
        (segments == scene.settings.end() || segments->second == 0.0)) {
        return Error{"settings.nucleus.trench_mm is " + short_number(trench->second) + " without cuts to follow", "",
                     "nucleus.segments of 2, 4, 6 or 8 with it"};
    }
    if (named("implant")) {
        const std::map<std::string, double> settings = all_settings(scene);
        if (Status status = check_implant(implant_shape(settings)); !status) {
            return status;
        }
        if (Status status = check_injector(injector_shape(settings)); !status) {
            return status;
        }
    }
    if (named("chamber") && scene.advance == Advance::implicit) {
        return Error{"advance is implicit with a chamber", "",
                     "automatic or explicit: suction holds tissue in substeps"};
    }
    return success();
}

}  // namespace

Status check_scene(const SceneDescription& scene) {
    for (const Status& status :
         {check_patient(scene.patient), check_names("tissues", scene.tissues, known_tissues),
          check_names("instruments", scene.instruments, instrument_names()),
          check_range("step_s", scene.step_s, 0.001, 0.02), check_range("threads", scene.threads, 1.0, 64.0),
          check_instruction_set(scene.instruction_set), check_settings(scene), check_combination(scene),
          check_microscope(scene), check_bag(scene)}) {
        if (!status) {
            return status;
        }
    }
    return success();
}

}  // namespace rhexis
