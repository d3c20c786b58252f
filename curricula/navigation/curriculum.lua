-- SPDX-License-Identifier: GPL-3.0-or-later
-- Steadiness and orientation: a blunt probe is held still at four places of the anterior chamber and led round a
-- circle.

local targets = require "targets"
local touch_events = require "touch_events"

local near = "max(max(abs(probe.tip_x_mm - (%g)), abs(probe.tip_y_mm - (%g))), abs(probe.tip_z_mm - (%g)))"

-- How far the tip is from a place, the largest of the three directions.
local function away_from(place) return near:format(place[1], place[2], place[3]) end

-- Held: the tip stays as near as the goal says for as long as the goal says.
local function held(place)
    local inside
    return function(eye)
        local probe = eye.probe
        local near_it = probe.present and math.abs(probe.tip_x_mm - place[1]) <= eye.goal.near_mm
            and math.abs(probe.tip_y_mm - place[2]) <= eye.goal.near_mm
            and math.abs(probe.tip_z_mm - place[3]) <= eye.goal.height_mm
        if not near_it then inside = nil else inside = inside or eye.time_s end
        return inside ~= nil and eye.time_s - inside >= eye.goal.hold_s
    end
end

local circle = targets.circle

-- How far the tip is from the circle, across it or in height.
local function off_circle(probe)
    local across = math.sqrt(probe.tip_x_mm ^ 2 + probe.tip_y_mm ^ 2) - circle.radius
    return math.max(math.abs(across), math.abs(probe.tip_z_mm - circle.height))
end

local function hold(target)
    return step("hold " .. target.name) {
        title = "Hold the tip: " .. target.name,
        hint = ("Bring the tip to %g mm right, %g mm away and %g mm over the lens equator, and hold it still."):format(
            table.unpack(target.place)),
        done = held(target.place),
        time_limit_s = 40,
    }
end

return exercise {
    title = "Holding still and finding the way",
    version = 1,
    summary = "A basic skill: hold the tip of a blunt probe still at four places of the anterior chamber, lead it "
        .. "round a circle, and leave, without touching iris or cornea.",
    objectives = { "Steady the hand", "Know where the tip is in all three directions" },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "iris", "cornea" },
    instruments = { "probe" },

    goals = {
        near_mm = { 0.7, from = 0.1, to = 2, meaning = "how near to a place the tip must stay, across" },
        height_mm = { 1.0, from = 0.1, to = 3, meaning = "and in height, which is harder to see" },
        hold_s = { 2, from = 0.5, to = 20, meaning = "for how long" },
        path_mm = { 0.8, from = 0.2, to = 2, meaning = "how far from the circle the tip may get" },
    },
    reference = { time_s = 45, path_mm = 60 },

    steps = {
        hold(targets[1]), hold(targets[2]), hold(targets[3]), hold(targets[4]),
        step "circle" {
            title = "Lead the tip round the circle",
            hint = "From the left, once round against the clock: near side, right, far side, left.",
            done = { away_from { 0, -circle.radius, circle.height } .. " < goal.path_mm",
                away_from { circle.radius, 0, circle.height } .. " < goal.path_mm",
                away_from { 0, circle.radius, circle.height } .. " < goal.path_mm",
                away_from { -circle.radius, 0, circle.height } .. " < goal.path_mm" },
            time_limit_s = 60,
        },
        step "withdraw" { title = "Leave the eye", hint = "Out the way you came.", done = "not probe.present" },
    },

    errors = {
        error_event "Path left" {
            when = function(eye) return eye.probe.present and off_circle(eye.probe) > eye.goal.path_mm end,
            recovered = function(eye) return eye.probe.present and off_circle(eye.probe) < eye.goal.path_mm end,
            deadline_s = 2,
            near_miss_s = 0,
            severity = "minor",
            steps = { "circle" },
            cue = "The tip is inside or outside the ring that it has to follow, or too high or too low.",
            advice = "Stop, look, and go back to the circle the shortest way before you go on.",
            items = { "T8", "G4" },
        },
        error_event "Iris touched" (touch_events.iris { items = { "G5", "G4" } }),
        error_event "Cornea touched" (touch_events.cornea("probe", { items = { "G3", "G4" } })),
    },

    time_limit_s = 300,
    scoring = osacss { "T8", "G3", "G4", "G5", "G6" },
}
