-- SPDX-License-Identifier: GPL-3.0-or-later
-- OSACSS: the Objective Structured Assessment of Cataract Surgical Skill (Saleh et al. 2007, Arch Ophthalmol 125:363),
-- twenty items of 1 to 5 points, as measures of the simulator. Edit this table to make it your centre's own.
--
-- five, three, one: the values that earn 5, 3 and 1 points; in between the score is linear, beyond it stays. A pair
-- such as five = { 80, 90 } is a range. An item is the weighted mean of its measures, then capped by error events.
-- A measure counts only where its exercise simulates what it needs; an item without any is left out and the scale
-- shrinks to the items that were scored.
--
-- source says where thresholds come from. "proposal": nobody has published a figure; discuss and change it.
-- These scores have not been validated clinically.

local scoring = require "scoring"

-- Some measures count only where an exercise has the goal that they tell of.
local parting = "goal.bridge_percent >= 0"
local removing = "fragments.count ~= 1 and goal.left_percent > 0"

return scoring.rubric {
    name = "OSACSS",
    source = "Saleh et al. 2007; measures and thresholds as given with each",

    -- The most an item can still earn after an error of its kind.
    caps = {
        critical = { not_recovered = 1, open = 1, recovered = 3, near_miss = 4 },
        minor = { not_recovered = 3, open = 3, recovered = 4, near_miss = 5 },
    },

    -- Share of the scale (0: all items 1 point, 1: all items 5 points). Cuts where the groups A and B, and B and C, of
    -- Saleh 2007 part if their scores are taken as normal: 41 and 78 of 100.
    bands = {
        { from = 0.0, name = "needs teaching", meaning = "scores like surgeons with fewer than 50 operations" },
        { from = 0.2625, name = "supervised", meaning = "scores like surgeons with 50 to 249 operations" },
        { from = 0.725, name = "independent", meaning = "scores like surgeons with 250 operations or more" },
    },

    items = {
        { id = "T1", name = "Draping", not_scored = "draping is not simulated in this exercise." },
        { id = "T2", name = "Incision and paracentesis", not_scored = "the incision is already made." },
        { id = "T3", name = "Viscoelastic: use and safe insertion", not_scored = "viscoelastic is not simulated." },
        { id = "T4", name = "Capsulorhexis: commencement of flap and follow-through",
            not_scored = "the capsule is already open." },
        { id = "T5", name = "Capsulorhexis: formation and circular completion",
            not_scored = "the capsule is already open." },
        { id = "T6", name = "Hydrodissection: visible fluid wave and free nuclear rotation",
            not_scored = "hydrodissection is not simulated." },
        { id = "T7", name = "Phaco probe and second instrument: insertion into the eye",
            not_scored = "the wound is not simulated.", measures = {
            { id = "T7.phaco_entries", name = "Attempts to bring the phaco probe in", unit = "1", digits = 0,
                of = "phaco.present", take = "count", five = 1, three = 2, one = 3, weight = 1, source = "proposal",
                better = "Come to the wound slowly and along its tunnel." },
            { id = "T7.second_entries", name = "Attempts to bring the second instrument in", unit = "1", digits = 0,
                of = "spatula.present", take = "count", five = 1, three = 2, one = 3, weight = 1, source = "proposal",
                better = "Leave the second instrument in the eye until the step that needs it is finished." },
            { id = "T7.iris_touches", name = "Touches of the iris before the first cut", unit = "1", digits = 0,
                of = "iris.touch", take = "count", during = "lens.removed_mm3 <= 0", quiet_s = 1, five = 0, three = 1,
                one = 2, weight = 1, source = "proposal",
                better = "Lower the tip only when it has passed the edge of the pupil." },
            { id = "T7.second_touches", name = "Times that the second instrument pressed on the capsule", unit = "1",
                digits = 0, of = "spatula.capsule_gap_mm < -0.1", take = "count", quiet_s = 1, five = 0, three = 1,
                one = 3, weight = 1, source = "proposal",
                better = "Keep the end of the second instrument inside the capsule's opening." },
        } },

        { id = "T8", name = "Phaco probe and second instrument: effective use and stability", measures = {
            { id = "T8.safe_ultrasound", name = "Ultrasound given with the tip in safe distance of iris, cornea and "
                .. "posterior capsule", unit = "%", digits = 0,
                of = "phaco.endothelium_mm > 1.0 and phaco.tip_posterior_mm > 0.5 and iris.gap_mm > 0.1",
                take = "share", during = "phaco.ultrasound", five = 98, three = 90, one = 75, weight = 1,
                source = "proposal", better = "Let go of pedal position 3 before the tip leaves the lens's middle." },
            { id = "T8.idle_ultrasound", name = "Ultrasound given while the tip touched no lens", unit = "%",
                digits = 0, of = "not phaco.in_contact and lens.removal_rate_mm3_s <= 0", take = "share",
                during = "phaco.ultrasound",
                five = 10, three = 25, one = 50, weight = 1, source = "proposal",
                better = "Give ultrasound only on the forward stroke and only in contact: it heats the wound and harms "
                    .. "the endothelium." },
            { id = "T8.endothelium", name = "Least distance of the working tip from the corneal endothelium",
                unit = "mm", digits = 2, of = "phaco.endothelium_mm", take = "min", during = "phaco.aspirating",
                five = 1.5, three = 1.0, one = 0.5, weight = 1, source = "proposal",
                better = "Work deeper, in the plane of the iris or behind it." },
            { id = "T8.tremor", name = "Trembling of the tip (6 to 12 Hz)", unit = "um", digits = 0,
                of = "phaco.tremor_um", take = "mean", during = "phaco.aspirating", five = 60, three = 130, one = 250,
                weight = 1, source = "Riviere 1997: 49 um holding still, 133 um while actuating",
                better = "Rest the hand on the patient's forehead and steady the handpiece with the second hand." },
        } },

        { id = "T9", name = "Nucleus: sculpting or primary chop", measures = {
            { id = "T9.depth", name = "Depth of the groove as a share of the lens's thickness there", unit = "%",
                digits = 0, of = "100 * groove.depth_share", take = "last", if_never = 0, five = { 80, 90 },
                three = 60, one = { 40, 95 }, weight = 1.5,
                source = "teaching rule of 80 to 90 %; teachers differ",
                too_low = "Go on in thin layers until the reflex in the groove glows red.",
                too_high = "Stop when the reflex in the groove glows evenly: the last tenth cracks by itself." },
            { id = "T9.length", name = "Length of the groove", unit = "mm", digits = 1, of = "groove.length_mm",
                take = "last", if_never = 0, five = 4.0, three = 3.0, one = 1.5, weight = 1, source = "proposal",
                better = "Begin each stroke nearer to yourself and end it nearer to the far edge of the pupil." },
            -- Of the second groove, where there is an instrument to turn the lens for it.
            { id = "T9.second_depth", name = "Depth of the shallower groove as a share of the lens's thickness there",
                unit = "%", digits = 0, of = "100 * groove_2.depth_share", take = "last",
                during = "spatula.present or lens.removed_mm3 > 0", if_never = 0, five = { 70, 90 }, three = 55,
                one = { 30, 95 }, weight = 1, source = "proposal; five points from 70 % on, the deeper one from 80 %",
                too_low = "Go on in thin layers until both grooves glow alike.",
                too_high = "Stop when the reflex in the groove glows evenly." },
            { id = "T9.angle", name = "Angle between the grooves, off a right angle", unit = "deg", digits = 0,
                of = "90 - grooves.angle_deg", take = "last", during = "spatula.present or lens.removed_mm3 > 0",
                if_never = 90, five = 5, three = 15, one = 30, weight = 0.5, source = "proposal",
                better = "Turn the nucleus until the first groove lies across, and keep it there while you sculpt." },
            { id = "T9.cde", name = "Ultrasound energy (CDE) over what this nucleus needs", unit = "1", digits = 2,
                of = "phaco.cde / reference.cde", take = "last", five = 1.2, three = 2, one = 3, weight = 0.5,
                source = "proposal",
                better = "Give ultrasound on the forward stroke only, and no more than the nucleus asks for." },
            { id = "T9.posterior", name = "Least distance of the working tip from the posterior capsule", unit = "mm",
                digits = 2, of = "phaco.tip_posterior_mm", take = "min", during = "phaco.aspirating",
                five = 1.0, three = 0.6, one = 0.3, weight = 1, source = "proposal",
                better = "Follow the curve of the posterior capsule: shallower towards both ends of the groove." },
            { id = "T9.push", name = "Most that the lens was pushed", unit = "mm", digits = 2,
                of = "lens.peak_displacement_mm", take = "last", five = 0.2, three = 0.5, one = 1.0, weight = 1,
                source = "proposal", better = "Slow the stroke or give more power, so that the tip cuts and does not "
                    .. "push." },
        } },

        { id = "T10", name = "Nucleus: rotation and manipulation", not_scored = "the nucleus need not be turned.",
            measures = {
            { id = "T10.rotation", name = "Turn of the nucleus", unit = "deg", digits = 0,
                of = "abs(lens.rotation_deg)", take = "max", during = "spatula.present and goal.angle_deg > 0",
                five = 80, three = 45, one = 0, weight = 1.5,
                source = "90 degrees for five points is a proposal; 80 leaves room for the tolerance",
                better = "Push the wall of the groove farther from the middle of the lens, until the groove lies "
                    .. "across." },
            { id = "T10.strain", name = "Most that a zonule was stretched by the second instrument", unit = "%",
                digits = 1, of = "100 * zonules.strain", take = "max",
                during = "spatula.in_contact and not phaco.ultrasound", five = 15,
                three = 30, one = 50, weight = 1,
                source = "proposal; Mikielewicz 2011 for the loads of zonules",
                better = "Push along an arc about the middle of the lens, not straight across and not down." },
            { id = "T10.push", name = "Most that the lens was shifted by the second instrument", unit = "mm",
                digits = 2, of = "lens.displacement_mm", take = "max",
                during = "spatula.in_contact and not phaco.ultrasound", five = 0.2,
                three = 0.5, one = 1.0, weight = 1, source = "proposal",
                better = "Turn the lens, do not shift it: push at a right angle to the line to its middle." },
        } },
        { id = "T11", name = "Nucleus: cracking or chopping with safe phaco of segments",
            not_scored = "the nucleus is not divided.", measures = {
            { id = "T11.bridge", name = "Nucleus that still bridges the groove", unit = "%", digits = 0,
                of = "100 * crack.bridge_share", take = "last", during = parting, five = 0,
                three = 10, one = 30, weight = 4, source = "proposal",
                better = "Go back with both tips into the lower third, next to where the halves still hang "
                    .. "together." },
            { id = "T11.depth", name = "Parting done with both tips in the lower third of the groove", unit = "%",
                digits = 0, of = "max(phaco.tip_posterior_mm, spatula.tip_posterior_mm) < groove.floor_posterior_mm "
                    .. "+ 0.33 * groove_1.depth_mm", take = "share",
                during = parting .. " and phaco.force_mN > 2 and spatula.force_mN > 2", five = 90,
                three = 60, one = 30, weight = 1, source = "proposal",
                better = "Put both tips on the floor of the groove before you part its walls." },
            { id = "T11.left", name = "Part of the lens that was left", unit = "%", digits = 0,
                of = "100 * fragments.left_share", take = "last", during = removing, five = 10,
                three = 25, one = 60, weight = 4, source = "proposal",
                better = "Go on until the bag is empty: draw the next piece to the middle as soon as one has "
                    .. "cleared." },
            { id = "T11.surges", name = "Losses of more than 30 % of the chamber's depth within a second", unit = "1",
                digits = 0, of = "chamber.surges", take = "max", during = removing, five = 0, three = 2,
                one = 4, weight = 1, source = "proposal",
                better = "Ease the pedal as a piece is about to clear; less vacuum or a higher bottle." },
            { id = "T11.plane", name = "Ultrasound at least 1.5 mm from the cornea and 1 mm from the capsule",
                unit = "%", digits = 0, of = "phaco.endothelium_mm > 1.5 and phaco.tip_posterior_mm > 1",
                take = "share", during = "phaco.ultrasound and " .. removing, five = 95,
                three = 80, one = 60, weight = 1,
                source = "proposal",
                better = "Draw the piece to the plane of the iris before emulsifying it." },
            { id = "T11.captures", name = "Times that the capsule was in the tip", unit = "1", digits = 0,
                of = "capsule.captured", take = "count", during = removing, five = 0, three = 0.5,
                one = 1, weight = 1, source = "proposal",
                better = "Keep the mouth turned away from the capsule while vacuum is high." },
            { id = "T11.time", name = "Time with the instrument in the eye", unit = "s", digits = 0,
                of = "phaco.present and " .. removing, take = "time", five = 270, three = 610, one = 900,
                weight = 0.5, source = "Joshi 2019: 267 to 277 s; Rali 2022: 275 to 611 s",
                better = "Hold, draw and emulsify without letting go in between." },
        } },
        { id = "T12", name = "Irrigation and aspiration with adequate removal of cortex",
            not_scored = "cortex is not aspirated." },
        { id = "T13", name = "Lens insertion, rotation and final position of the implant",
            not_scored = "no implant is inserted." },
        { id = "T14", name = "Wound closure", not_scored = "the wound is not simulated." },

        { id = "G1", name = "Wound neutrality and minimising eye rolling and corneal distortion",
            not_scored = "the wound and the rolling of the eye are not simulated." },
        { id = "G2", name = "Eye positioned centrally within microscope view",
            not_scored = "the microscope is not moved." },

        { id = "G3", name = "Conjunctival and corneal tissue handling", measures = {
            { id = "G3.endothelium_dose", name = "Ultrasound within 1 mm of the corneal endothelium", unit = "s",
                digits = 1, of = "phaco.ultrasound and phaco.endothelium_mm < 1.0", take = "time",
                five = 1, three = 5, one = 15, weight = 1, source = "proposal",
                better = "Wait with ultrasound until the tip is well below the cornea." },
        } },

        { id = "G4", name = "Intraocular spatial awareness", measures = {
            { id = "G4.iris_touches", name = "Touches of the iris", unit = "1", digits = 0, of = "iris.touch",
                take = "count", quiet_s = 1, five = 0, three = 1, one = 3, weight = 0.5, source = "proposal",
                better = "Look at the shaft and at the pupil's edge as well as at the tip." },
            { id = "G4.capsule_touches", name = "Touches of the posterior capsule with the tip", unit = "1",
                digits = 0, of = "phaco.tip_posterior_mm < 0.1", take = "count", quiet_s = 1, five = 0, three = 1,
                one = 3, weight = 1, source = "proposal",
                better = "Stop deepening while there is still a plate of lens." },
            { id = "G4.safe_time", name = "Time with the tip in safe distance of iris and posterior capsule",
                unit = "%", digits = 0, of = "phaco.tip_posterior_mm > 0.5 and iris.gap_mm > 0.1", take = "share",
                during = "phaco.aspirating", five = 98, three = 90, one = 75, weight = 1, source = "proposal",
                better = "Keep the working tip in the middle of the pupil, and judge its depth by the reflex." },
            { id = "G4.posterior", name = "Least distance from the posterior capsule while aspirating", unit = "mm",
                digits = 2, of = "phaco.tip_posterior_mm", take = "min", during = "phaco.aspirating",
                five = 1.0, three = 0.5, one = 0.2, weight = 1, source = "proposal",
                better = "Let go to pedal position 1 whenever you are unsure of the depth." },
        } },

        { id = "G5", name = "Iris protection", measures = {
            { id = "G5.touches", name = "Touches of the iris", unit = "1", digits = 0, of = "iris.touch",
                take = "count", quiet_s = 1, five = 0, three = 2, one = 5, weight = 1, source = "proposal",
                better = "Turn back before the pupil's edge, and keep the shaft above the iris." },
            { id = "G5.touch_time", name = "Time in touch with the iris", unit = "s", digits = 1, of = "iris.touch_s",
                take = "last", five = 0, three = 0.5, one = 2, weight = 1, source = "proposal",
                better = "When you touch the iris, stop and draw back at once." },
        } },

        { id = "G6", name = "Overall speed and fluidity of procedure", measures = {
            { id = "G6.time", name = "Time, as a multiple of what an expert needs", unit = "x", digits = 2,
                of = "time_s / reference.time_s", take = "last", five = 1.0, three = 1.67, one = 2.67, weight = 1,
                source = "15, 25 and 40 min of a whole operation; BMJ Open 2013: seniors 13.4, juniors 17.8 min",
                better = "Plan the next stroke while the tip comes back." },
            { id = "G6.path", name = "Way of the tip, as a multiple of what an expert needs", unit = "x", digits = 2,
                of = "phaco.path_mm / reference.path_mm", take = "last", five = 1.2, three = 1.8, one = 2.5,
                weight = 1, source = "proposal; Smith 2013: path length separates under 200 from over 1000 cases",
                better = "Fewer and straighter strokes; do not search with the tip." },
            { id = "G6.entries", name = "Entries into the eye", unit = "1", digits = 0, of = "phaco.present",
                take = "count", five = 1, three = 2, one = 3, weight = 0.5, source = "proposal",
                better = "Leave the instrument in the eye until the step is finished." },
        } },
    },
}
