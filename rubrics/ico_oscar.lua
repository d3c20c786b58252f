-- SPDX-License-Identifier: GPL-3.0-or-later
-- ICO-OSCAR:phaco (Golnik et al. 2011 and 2013): the rubric of the International Council of Ophthalmology, built on
-- OSACSS, with a written anchor for every level. Anchors are told here in own, short words; take the original for a
-- rating by hand. Judge a recording by it, whatever its exercise is scored by:
--
--   rhexis replay runs/groove-expert-1 --score-with rubrics/ico_oscar.lua
--   rhexis report runs/groove-expert-1 --score-with rubrics/ico_oscar.lua
--
-- Levels: 2 novice, 3 beginner, 4 advanced beginner, 5 competent; what the preceptor did or what was not simulated is
-- not scored. two to five are the values that earn so many points. errors_of: the item is judged where an exercise
-- scores one of these items of OSACSS, and errors that it counts against those cap it. These scores have not been
-- validated clinically.

local osacss = require "osacss"

local source = "proposal, after the anchors of ICO-OSCAR; the original has no figures"

-- Touches and the like: how often something happened.
local function count(id, name, of, better, more)
    local given = { id = id, name = name, of = of, take = "count", quiet_s = 1, unit = "1", digits = 0, five = 0,
        four = 1, three = 2, two = 4, weight = 1, source = source, better = better }
    for key, value in pairs(more or {}) do given[key] = value end
    return given
end

local function half_way(a, b)
    if type(a) == "table" and type(b) == "table" then return { half_way(a[1], b[1]), half_way(a[2], b[2]) } end
    return ((type(a) == "table" and a[1] or a) + (type(b) == "table" and b[1] or b)) / 2
end

-- The measures of an item of OSACSS: what earns 5, 3 and 1 points there earns 5, 3 and 2 here, and half way between 5
-- and 3 it is 4.
local function as_in_osacss(id, own_id)
    local list = {}
    for i, measure in ipairs(osacss.by_id[id].measures) do
        local given = {}
        for key, value in pairs(measure) do given[key] = value end
        local five, three, one = measure.thresholds[1].value, measure.thresholds[2].value, measure.thresholds[3].value
        given.id, given.of, given.during = measure.id:gsub("^" .. id, own_id), measure.of.text,
            measure.during and measure.during.text
        given.given = measure.given and measure.given.text
        given.five, given.four, given.three, given.two = five, half_way(five, three), three, one
        given.curve, given.thresholds = nil, nil
        list[i] = given
    end
    return list
end

local items = {
    { id = "P1", name = "Draping", errors_of = { "T1" }, not_scored = "draping is not simulated here.", anchors = {
        [2] = "cannot start without help", [3] = "most lashes covered, with prompting",
        [4] = "lashes covered, drape seldom in the way", [5] = "all lashes covered, field clear" },
        measures = as_in_osacss("T1", "P1") },
    { id = "P2", name = "Incision and paracentesis: formation and technique", errors_of = { "T2" },
        not_scored = "the incisions are already made.", anchors = {
        [2] = "wrong place, size or construction", [3] = "right place or size, leaks or is hard to work through",
        [4] = "well made, small fault", [5] = "parallel to the iris, self-sealing, right size" },
        measures = as_in_osacss("T2", "P2") },
    { id = "P3", name = "Viscoelastic: appropriate use and safe insertion", errors_of = { "T3" },
        not_scored = "viscoelastic is not simulated here.", anchors = {
        [2] = "unsure when, how much and which", [3] = "knows when, wrong amount", [4] = "mostly the right amount",
        [5] = "in time, the right amount, no touch of cornea or capsule" },
        measures = as_in_osacss("T3", "P3") },
    { id = "P4", name = "Capsulorhexis: commencement of flap and follow-through", errors_of = { "T4" },
        not_scored = "the capsule is already open.", anchors = {
        [2] = "tentative, cortex disturbed, chases the flap", [3] = "fairly in control, some cortex disturbed",
        [4] = "in control, few attempts", [5] = "delicate, in control from the first move" }, measures = {
        { id = "P4.punctures", name = "Punctures of the capsule", unit = "1", digits = 0, of = "rhexis.punctures",
            take = "last", five = 1, four = 2, three = 3, two = 4, source = source,
            better = "Once through, keep the point of the needle under the capsule until the cut is done." },
        { id = "P4.depth", name = "Deepest that the needle was in the cortex", unit = "mm", digits = 2,
            of = "cystotome.tip_depth_mm", take = "max", five = 0.7, four = 0.85, three = 1.0, two = 1.3,
            source = source, better = "Only the point of the needle goes under the capsule." },
    } },
    { id = "P5", name = "Capsulorhexis: formation and circular completion", errors_of = { "T5" },
        not_scored = "the capsule is already open.", anchors = {
        [2] = "wrong size and place, tear runs out", [3] = "hard to keep round, needs help",
        [4] = "nearly the right size and place, in control", [5] = "right size, central, no tear" }, measures = {
        { id = "P5.diameter", name = "Mean diameter of the opening", unit = "mm", digits = 2,
            of = "rhexis.diameter_mm", take = "last", if_never = 0, five = { 5.0, 5.5 }, four = { 4.75, 5.75 },
            three = { 4.5, 6.0 }, two = { 4.0, 6.5 }, weight = 2,
            source = "Packer 2015: 5.25 mm; the rest: proposal",
            too_low = "Lead the flap farther out.", too_high = "Lead the flap farther in." },
        { id = "P5.circularity", name = "Roundness of the opening (1: a circle)", unit = "1", digits = 3,
            of = "rhexis.circularity", take = "last", if_never = 0, five = 0.92, four = 0.88, three = 0.84,
            two = 0.78, source = "0.88 in live surgery (ImmersiveTouch study); the rest: proposal",
            better = "Turn the direction of the pull with the tear." },
        { id = "P5.centre", name = "Distance of the opening's middle from the axis", unit = "mm", digits = 2,
            of = "rhexis.centre_offset_mm", take = "last", if_never = 2, five = 0.25, four = 0.4, three = 0.55,
            two = 1.0, source = source, better = "Compare the tear with the edge of the pupil all round." },
    } },
    { id = "P6", name = "Hydrodissection: visible fluid wave and free nuclear rotation", errors_of = { "T6" },
        not_scored = "hydrodissection is not simulated here.", anchors = {
        [2] = "no wave, no rotation", [3] = "wave after several tries, rotation by force",
        [4] = "wave, incomplete rotation", [5] = "wave seen, nucleus turns freely" },
        measures = as_in_osacss("T6", "P6") },
    { id = "P7", name = "Phaco probe and second instrument: insertion into the eye", errors_of = { "T7" },
        not_scored = "the way in is not judged in this exercise.", anchors = {
        [2] = "many attempts, tissue harmed", [3] = "in after some attempts",
        [4] = "in at the first or second attempt",
        [5] = "in smoothly, nothing touched" }, measures = {
        { id = "P7.entries", name = "Entries of the probe", unit = "1", digits = 0, of = "phaco.present",
            take = "count", five = 1, four = 2, three = 3, two = 5, source = source,
            better = "Come to the wound slowly and along its tunnel." },
        count("P7.iris", "Touches of the iris before the first cut", "iris.touch",
            "Lower the tip only past the edge of the pupil.", { during = "lens.removed_mm3 <= 0" }),
    } },
    { id = "P8", name = "Phaco probe and second instrument: effective use and stability", errors_of = { "T8" },
        not_scored = "no ultrasound was given.", anchors = {
        [2] = "tip often tilted or in danger, pedal unsure", [3] = "tip mostly safe, eye mostly quiet",
        [4] = "tip safe, pedal sure, small lapses", [5] = "tip steady in the safe middle, power only when needed" },
        measures = {
        { id = "P8.safe", name = "Ultrasound in safe distance of iris, cornea and posterior capsule", unit = "%",
            digits = 0, of = "phaco.endothelium_mm > 1.0 and phaco.tip_posterior_mm > 0.5 and iris.gap_mm > 0.1",
            take = "share", during = "phaco.ultrasound", five = 98, four = 94, three = 88, two = 75, weight = 2,
            source = source, better = "Let go of position 3 before the tip leaves the middle." },
        { id = "P8.idle", name = "Ultrasound while the tip touched no lens", unit = "%", digits = 0,
            of = "not phaco.in_contact and lens.removal_rate_mm3_s <= 0", take = "share",
            during = "phaco.ultrasound", five = 10, four = 18, three = 28, two = 50, source = source,
            better = "Ultrasound only in contact and on the way forward." },
        { id = "P8.tremor", name = "Trembling of the tip (6 to 12 Hz)", unit = "um", digits = 0,
            of = "phaco.tremor_um", take = "mean", during = "phaco.aspirating", five = 60, four = 95, three = 130,
            two = 220, not_with = { "mouse", "gamepad" },
            source = "Riviere 1997: 49 um at rest, 133 um while actuating; the rest: proposal",
            better = "Rest the hand on the forehead." },
    } },
    { id = "P9", name = "Nucleus: sculpting or primary chop", errors_of = { "T9" },
        not_scored = "no groove is sculpted.", anchors = {
        [2] = "wrong power, nucleus pushed, uneven or dangerous depth",
        [3] = "groove uneven or too shallow, some push",
        [4] = "sound groove, small faults of depth or power", [5] = "even groove of the right depth, no push" },
        measures = {
        { id = "P9.depth", name = "Depth of the groove, share of the lens's thickness", unit = "%", digits = 0,
            of = "100 * groove.depth_share", take = "last", five = { 80, 90 }, four = { 70, 92 },
            three = { 60, 94 }, two = { 40, 97 }, weight = 2,
            source = "teaching rule of 80 to 90 %; the rest: proposal",
            too_low = "Go on in thin layers until the reflex glows red.",
            too_high = "Stop when the reflex glows evenly." },
        { id = "P9.posterior", name = "Least distance of the working tip from the posterior capsule", unit = "mm",
            digits = 2, of = "phaco.tip_posterior_mm", take = "min", during = "phaco.aspirating", five = 1.0,
            four = 0.8, three = 0.6, two = 0.3, source = source,
            better = "Shallower towards both ends of the groove." },
        { id = "P9.push", name = "Most that the lens was pushed", unit = "mm", digits = 2,
            of = "lens.peak_displacement_mm", take = "last", five = 0.2, four = 0.35, three = 0.5, two = 0.9,
            source = source, better = "Slower, or more power." },
    } },
    { id = "P10", name = "Nucleus: rotation and manipulation", errors_of = { "T10" },
        not_scored = "the nucleus need not be turned.", anchors = {
        [2] = "cannot turn it", [3] = "turns a little, in many attempts", [4] = "turns it in some attempts",
        [5] = "turns it safely in one or two sweeps" }, measures = {
        { id = "P10.turn", name = "Turn of the nucleus", unit = "deg", digits = 0, of = "abs(lens.rotation_deg)",
            take = "max", during = "spatula.present and goal.angle_deg > 0", five = 80, four = 60, three = 40,
            two = 10, weight = 2, source = source, better = "Push farther from the middle of the lens." },
        { id = "P10.strain", name = "Most that a zonule was stretched", unit = "%", digits = 1,
            of = "100 * zonules.strain", take = "max", during = "spatula.in_contact and not phaco.ultrasound",
            five = 15, four = 22, three = 30, two = 45, source = source, better = "Push along an arc." },
    } },
    { id = "P11", name = "Nucleus: cracking or chopping with safe phaco of segments", errors_of = { "T11" },
        not_scored = "the nucleus is not divided or removed.", anchors = {
        [2] = "cannot part it, pieces chased", [3] = "parts it in many attempts, tip in danger at times",
        [4] = "parts it, pieces removed with small faults",
        [5] = "parts it at once, pieces emulsified in the plane of the iris" }, measures = {
        { id = "P11.bridge", name = "Nucleus that still bridges the groove", unit = "%", digits = 0,
            of = "100 * crack.bridge_share", take = "last", during = "goal.bridge_percent >= 0", five = 0,
            four = 5, three = 12, two = 30, weight = 3, source = source,
            better = "Both tips into the lower third again." },
        { id = "P11.left", name = "Part of the lens that was left", unit = "%", digits = 0,
            of = "100 * fragments.left_share", take = "last",
            during = "fragments.count ~= 1 and goal.left_percent > 0", five = 10, four = 18, three = 30, two = 60,
            weight = 3, source = source, better = "Go on until the bag is empty." },
        count("P11.surges", "Surges: more than 30 % of the depth within a second", "chamber.depth_lost_share > 0.3",
            "Ease the pedal as a piece is about to clear."),
        count("P11.captures", "Times that the capsule was in the tip", "capsule.captured",
            "Turn the mouth away from the capsule while vacuum is high."),
    } },
    { id = "P12", name = "Irrigation and aspiration with adequate removal of cortex", errors_of = { "T12" },
        not_scored = "cortex is not aspirated here.", anchors = {
        [2] = "much cortex left, capsule caught", [3] = "moderate trouble, some cortex left",
        [4] = "little cortex left", [5] = "all of it, port always away from the capsule" },
        measures = as_in_osacss("T12", "P12") },
    { id = "P13", name = "Lens insertion, rotation and final position", errors_of = { "T13" },
        not_scored = "no implant is inserted.", anchors = {
        [2] = "needs help, implant wrongly placed", [3] = "in after trouble, some more manoeuvres",
        [4] = "in with little trouble", [5] = "in the bag at once, centred, nothing stressed" }, measures = {
        { id = "P13.haptics", name = "Haptics in the bag in the end", unit = "1", digits = 0,
            of = "implant.haptics_in_bag", take = "last", five = 2, four = 1.9, three = 1.5, two = 1, weight = 2,
            source = source, better = "Turn the implant until the trailing haptic slips under the rim." },
        { id = "P13.decentration", name = "Optic's middle from the bag's axis", unit = "mm", digits = 2,
            of = "implant.decentration_mm", take = "last", if_never = 2, five = 0.3, four = 0.4, three = 0.55,
            two = 1.0, source = "Ashena 2020: 0.2 to 0.3 mm go unnoticed; the rest: proposal",
            better = "Push the optic to the middle, and see that it stays." },
        { id = "P13.rim", name = "Most that an eighth of the opening was stretched", unit = "1", digits = 2,
            of = "bag.rim_peak_stretch", take = "last", five = 1.10, four = 1.15, three = 1.22, two = 1.35,
            source = "Auffarth 2013: rims break at 1.35 (pig); the rest: proposal",
            better = "Lead the haptic under the rim." },
    } },
    { id = "P14", name = "Wound closure", errors_of = { "T14" }, not_scored = "closing is not simulated here.",
        anchors = { [2] = "leaks, not checked", [3] = "tight after several tries", [4] = "tight, checked late",
        [5] = "tight and checked, right pressure" },
        measures = as_in_osacss("T14", "P14") },

    { id = "P15", name = "Wound neutrality and minimising eye rolling and corneal distortion",
        errors_of = { "G1" }, not_scored = "wound and rolling of the eye are not simulated here.", anchors = {
        [2] = "eye nearly always off its place", [3] = "eye often off its place", [4] = "mostly in place",
        [5] = "eye stays in place, cornea clear" },
        measures = as_in_osacss("G1", "P15") },
    { id = "P16", name = "Eye positioned centrally within microscope view", errors_of = { "G2" },
        not_scored = "the microscope is not moved.", anchors = { [2] = "constant corrections needed",
        [3] = "mild wandering of the pupil", [4] = "slight wandering", [5] = "pupil always in the middle" },
        measures = {
        { id = "P16.offset", name = "Pupil from the middle of the field, share of its radius", unit = "1",
            digits = 2, of = "microscope.pupil_offset", take = "mean", during = "instruments.out_s <= 0",
            five = 0.15, four = 0.22, three = 0.3, two = 0.45, source = source,
            better = "Bring the eye back to the middle as soon as it has left it." },
        { id = "P16.focus", name = "Time with the pupil in focus", unit = "%", digits = 0,
            of = "microscope.in_focus", take = "share", during = "instruments.out_s <= 0", five = 95, four = 88,
            three = 80, two = 65, source = source, better = "Refocus as soon as the edge blurs." },
    } },
    { id = "P17", name = "Conjunctival and corneal tissue handling", errors_of = { "G3" },
        not_scored = "nothing came near the cornea.", anchors = { [2] = "rough, tissue harmed",
        [3] = "potential for harm", [4] = "careful, small lapses", [5] = "tissue not touched or stressed" },
        measures = {
        { id = "P17.dose", name = "Ultrasound within 1 mm of the endothelium", unit = "s", digits = 1,
            of = "phaco.ultrasound and phaco.endothelium_mm < 1.0", take = "time", five = 1, four = 3, three = 6,
            two = 12, source = source, better = "Wait until the tip is well below the cornea." },
        count("P17.rhexis", "Touches of the back of the cornea", "(cystotome.endothelium_mm < 0.1 and "
            .. "cystotome.tip_y_mm > -2.5) or (forceps.endothelium_mm < 0.1 and forceps.tip_y_mm > -2.5)",
            "Go in flat along the tunnel, then down."),
        count("P17.implant", "Touches of the back of the cornea by implant or injector",
            "implant.cornea_mm < 0.05 or (injector.endothelium_mm < 0.1 and injector.tip_y_mm > -2.5)",
            "Let the implant unfold deep in the bag."),
    } },
    { id = "P18", name = "Intraocular spatial awareness", errors_of = { "G4" },
        not_scored = "depth is not judged in this exercise.", anchors = {
        [2] = "instruments often against capsule, iris or cornea", [3] = "often close, some touches",
        [4] = "seldom close", [5] = "always knows where every part of every instrument is" }, measures = {
        count("P18.capsule", "Touches of the posterior capsule with the tip", "phaco.tip_posterior_mm < 0.1",
            "Stop deepening while there is a plate of lens."),
        { id = "P18.bag", name = "Presses on the back of the bag", unit = "1", digits = 0,
            of = "bag.posterior_touches", take = "last", five = 0, four = 1, three = 2, two = 4, source = source,
            better = "Stay at the front of the optic." },
        { id = "P18.hidden", name = "Time with a tip under the iris", unit = "%", digits = 0,
            of = "instruments.hidden", take = "share", five = 2, four = 5, three = 9, two = 18, source = source,
            better = "Work inside the edge of the pupil." },
    } },
    { id = "P19", name = "Iris protection", errors_of = { "G5" }, not_scored = "there is no iris.", anchors = {
        [2] = "iris constantly at risk, harmed", [3] = "iris at risk", [4] = "iris mostly safe",
        [5] = "iris not touched" }, measures = {
        count("P19.touches", "Touches of the iris", "iris.touch", "Keep the shaft above the iris."),
    } },
    { id = "P20", name = "Overall speed and fluidity of procedure", errors_of = { "G6" },
        not_scored = "the exercise names no expert's time.", anchors = { [2] = "hesitant, slow, many pauses",
        [3] = "slow, many corrections", [4] = "steady, few pauses", [5] = "fluent, no movement without purpose" },
        measures = {
        { id = "P20.time", name = "Time, as a multiple of what an expert needs", unit = "x", digits = 2,
            of = "time_s", per = "time_s", take = "last", five = 1.1, four = 1.4, three = 1.7, two = 2.4,
            source = "ICO-OSCAR: 30 min for competent, 60 for novice; the rest: proposal",
            better = "Plan the next move while the tip comes back." },
        { id = "P20.path", name = "Way of the instruments, as a multiple of what an expert needs", unit = "x",
            digits = 2, of = "instruments.path_mm", per = "path_mm", take = "total", five = 1.2, four = 1.5,
            three = 1.8, two = 2.5, source = "Smith 2013: separates; figures: proposal",
            better = "Fewer and straighter movements." },
    } },
}

-- Where no work of an item was begun, OSACSS and this agree.
for _, item in ipairs(items) do
    item.begun = {}
    for i, watch in ipairs(osacss.by_id[item.errors_of[1]].begun) do item.begun[i] = watch.of.text end
end

return rubric {
    name = "ICO-OSCAR",
    source = "Golnik et al. 2011, 2013; Eye 2018 (s41433-018-0185-1) for its scheme; figures: proposals",
    levels = { five = 5, four = 4, three = 3, two = 2 },

    caps = {
        critical = { not_recovered = 2, open = 2, recovered = 3, near_miss = 4 },
        minor = { not_recovered = 3, open = 3, recovered = 4, near_miss = 5 },
    },

    items = items,
}
