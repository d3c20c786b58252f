-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon sculpts: words that plans share. They see the picture only: no measure, no event, no score.
--
-- A groove must be wider than the tip, so that the sleeve behind it can follow: each layer is two strokes side by side.
-- y is the direction away from the surgeon, z the one towards the microscope. [mm]

local sculpting = {}

sculpting.lens_thickness = 4.5  -- of an old lens, as biometry says before the operation
sculpting.free_speed = 6.0      -- in front of the lens

local front_radius = 10.0     -- of the front surface
local layer = 0.55            -- taken by one pair of strokes, of a tip 0.9 wide
local half_width = 0.40       -- of the groove, without the tip's own width
local cutting = 2.35          -- pedal: 35 % of full ultrasound; 30 to 60 % is usual [AscrsUltrasoundTime2014]
local stroke_speed = 7.0      -- with it [mm/s]
local return_speed = 7.0
local slower = 0.15           -- share of the speed of a careful stroke less, per mm of depth
local steepest = 0.78         -- slope of the shaft at which its sleeve still clears the iris
local heed = 0.15             -- how much a new look counts against those before
local pushed = 0.4            -- shift of the lens that makes a surgeon stop

-- A place as it is believed to be after another look.
local function blend(believed, seen)
    for axis = 1, 3 do believed[axis] = believed[axis] + heed * (seen[axis] - believed[axis]) end
end

--- What is known of the eye after looking for a while: wound, pupil, pupil_radius, front, reflex; and port, if there is
--- a second wound.
function sculpting.look_around(me)
    me.wait_until(function(seen)
        return seen and seen.landmarks.incision and seen.landmarks.pupil and seen.landmarks.lens_front
    end, 5)
    local marks = me.see() and me.see().landmarks or {}
    for _, name in ipairs({ "incision", "pupil", "lens_front" }) do
        if not marks[name] then
            error(("look_around: no '%s' is seen: it needs the tissues lens (or anterior_capsule) and iris"):format(
                name), 2)
        end
    end
    local eye = { wound = marks.incision.position, pupil = marks.pupil.position, pupil_radius = marks.pupil.size,
        front = marks.lens_front.position, reflex = me.see().reflex_brightness,
        port = marks.side_port and marks.side_port.position }
    for _ = 1, 12 do
        me.wait(0.25)
        marks = me.see().landmarks
        blend(eye.wound, marks.incision.position)
        blend(eye.pupil, marks.pupil.position)
        blend(eye.front, marks.lens_front.position)
        if eye.port then blend(eye.port, marks.side_port.position) end
        eye.reflex = eye.reflex + heed * (me.see().reflex_brightness - eye.reflex)
    end
    return eye
end

--- How high the lens is, looked at again and again.
function sculpting.look_at_height(me, eye)
    local front = me.see().landmarks.lens_front
    if front then eye.front[3] = eye.front[3] + heed * (front.position[3] - eye.front[3]) end
end

--- Front of the lens at a distance from its middle, as it was before sculpting.
function sculpting.surface(eye, y) return eye.front[3] - y * y / (2 * front_radius) end

-- Least height of the tip at y at which the shaft, which turns about the wound, still clears the near edge of the iris.
local function lowest(eye, y) return eye.wound[3] - steepest * (y - eye.wound[2]) end

--- Where a groove begins, is deepest and ends. lean: how far it goes aside per way away from the surgeon.
function sculpting.plan_groove(eye)
    return { near = eye.pupil[2] - 0.35 * eye.pupil_radius, deepest = eye.pupil[2] + 0.50 * eye.pupil_radius,
        far = eye.pupil[2] + 0.75 * eye.pupil_radius, x = eye.pupil[1], middle = eye.pupil[2], lean = 0 }
end

-- The groove's line at y, and beside it.
local function line(groove, beside, y) return groove.x + beside + groove.lean * (y - groove.middle) end

-- Depth of the floor at y when it is `depth` at its deepest place: a ramp down, then up again as the capsule curves.
local function floor_depth(groove, depth, y)
    if y < groove.deepest then
        return depth * math.max(0, 0.25 + 0.75 * (y - groove.near) / (groove.deepest - groove.near))
    end
    return depth * (1 - 0.6 * (y - groove.deepest) / (groove.far - groove.deepest))
end

-- The way of the tip along the groove at a depth, beside its middle; lift raises it.
local function along(eye, groove, depth, beside, from, to, lift)
    return function(share)
        local y = from + (to - from) * share
        local z = math.max(sculpting.surface(eye, y) - floor_depth(groove, depth, y), lowest(eye, y))
        return { line(groove, beside, y), y, z + lift }
    end
end

local function outside(eye) return { eye.wound[1], eye.wound[2] - 2.0, eye.wound[3] + 1.0 } end

--- Brings the tip through the wound to where the groove begins.
function sculpting.enter(me, eye, groove)
    me.take_up(outside(eye), "phaco")  -- another instrument may have been in this hand before
    me.pedal(1)
    me.wait(0.5)
    me.go(eye.wound, sculpting.free_speed)
    me.go({ groove.x, groove.near, sculpting.surface(eye, groove.near) + 0.9 }, sculpting.free_speed)
end

--- Lifts the tip over the lens and draws it out.
function sculpting.leave(me, eye)
    local tip = me.tip()
    me.pedal(1)
    me.go({ tip[1], tip[2], sculpting.surface(eye, tip[2]) + 0.9 }, sculpting.free_speed)
    me.go(eye.wound, sculpting.free_speed)
    me.go(outside(eye), sculpting.free_speed)
    me.put_down()
    me.pedal(0)
    me.wait(0.5)
end

-- How far the lens seems to have been pushed across the line of sight.
local function push_of(eye, seen)
    local front = seen.landmarks.lens_front
    if not front then return 0 end
    local dx, dy = front.position[1] - eye.front[1], front.position[2] - eye.front[2]
    return math.sqrt(dx * dx + dy * dy)
end

--- What stops a movement that must not shift the lens.
function sculpting.runs_away(eye)
    return function(seen) return push_of(eye, seen) > pushed and "pushing" or nil end
end

--- Waits until the lens has come back.
function sculpting.let_come_back(me, eye)
    me.wait_until(function(seen) return push_of(eye, seen) < 0.5 * pushed end, 2)
end

-- Share of the lens that seems left under the tip. Light passes the lens twice: on its way in through the whole pupil,
-- on its way out here; so the reflex at the start is exp(-2 tau), and what is left here is -log(here) / tau - 1.
local function share_left(eye, seen)
    local tau = -0.5 * math.log(math.min(0.98, eye.reflex))
    return -math.log(math.max(1e-6, seen.tip_brightness)) / tau - 1
end

-- What stops a stroke: the lens runs away from the tip, or the reflex at the tip says that little is left under it.
local function danger(eye, state)
    return function(seen)
        if push_of(eye, seen) > (state.pushed or pushed) then return "pushing" end
        if share_left(eye, seen) < state.thin then return "bright" end
        return state.also and state.also(seen)
    end
end

--- Share of the lens's thickness that a floor seems to have.
function sculpting.seen_share(eye, floor)
    if not floor then return 0 end
    return (sculpting.surface(eye, floor.position[2]) - floor.position[3]) / sculpting.lens_thickness
end

--- Pedal up, tip back and up, and wait until the lens has come back.
function sculpting.draw_back(me, eye)
    local tip = me.tip()
    me.pedal(1)
    me.go({ tip[1], tip[2] - 0.3, tip[3] + 0.8 }, return_speed)
    sculpting.let_come_back(me, eye)
end

-- One stroke away from the surgeon with ultrasound, and the way back without.
local function stroke(me, eye, groove, state, beside)
    local way = along(eye, groove, state.depth, beside, groove.near, groove.far, 0)
    me.go(way(0), sculpting.free_speed)
    me.pedal(cutting)
    local reason = me.follow(way, me.about(stroke_speed) * state.pace, danger(eye, state))
    me.pedal(1)
    sculpting.look_at_height(me, eye)
    if reason then state.recover(me, eye) end
    me.follow(along(eye, groove, state.depth, beside, me.tip()[2], groove.near, 0.5), return_speed)
    return reason
end

-- The same in a lens that turns easily: the tip comes back over the lens and goes in with ultrasound, so that it
-- does not push the walls sideways.
local function careful_stroke(me, eye, groove, state, beside)
    local way = along(eye, groove, state.depth, beside, groove.near, groove.far, 0)
    local function over(y) return { line(groove, beside, y), y, sculpting.surface(eye, y) + state.return_height } end
    me.go(over(groove.near), return_speed)
    me.pedal(cutting)
    me.go(way(0), state.entry_speed)
    local speed = me.about(stroke_speed) * state.pace * (1 - slower * state.depth)
    local reason = me.follow(way, speed, danger(eye, state))
    me.pedal(1)
    sculpting.look_at_height(me, eye)
    if reason then state.recover(me, eye) else me.go(over(me.tip()[2]), return_speed) end
    return reason
end

-- Whether to stop after a stroke that ended for a reason (nil: at its end). A bright reflex in a shallow groove is a
-- misjudgement, and is trusted less the next time.
local function enough(me, eye, state, reason)
    local share = sculpting.seen_share(eye, state.floor(me.see()))
    if reason == "bright" and share < state.surely_deep then state.thin = state.thin - 0.1 end
    return share >= state.deep_enough or (reason == "bright" and share >= state.surely_deep)
        or state.depth > sculpting.lens_thickness or me.time_s() > state.until_s
end

--- Strokes until the groove seems deep enough. state: { deep_enough = share of the thickness at which to stop,
--- surely_deep = the same once the reflex says that little is left, thin = share of the lens that seems left under the
--- tip, by its brightness, at which to lift, until_s = time to stop, floor = function(seen) that gives the landmark of
--- its floor, recover = function(me, eye) that ends a stroke which went wrong, also = function(seen): more that stops a
--- stroke, depth = to begin with }; in a lens that turns easily also { return_height = over
--- the lens on the way back, entry_speed, half_width = of the groove, without the tip's own, pushed = shift
--- of the lens that ends a stroke, before = function(me, eye): done before each stroke }.
function sculpting.sculpt(me, eye, groove, state)
    state.depth, state.pace = state.depth or 0, 1
    for number = 1, 80 do
        if state.before then state.before(me, eye) end
        if number % 2 == 1 then state.depth = state.depth + me.about(layer) end
        local side = (number % 2 == 1 and -1 or 1) * (state.half_width or half_width)
        local reason = (state.return_height and careful_stroke or stroke)(me, eye, groove, state, side)
        if reason == "pushing" then
            state.pace = math.max(0.3, 0.7 * state.pace)
            state.depth = state.depth - 0.5 * layer
        end
        if enough(me, eye, state, reason) then break end
    end
end

return sculpting
