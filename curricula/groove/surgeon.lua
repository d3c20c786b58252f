-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon sculpts a groove. All groups follow this plan; what they make of it depends on their hands,
-- eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event, no score.
--
-- The groove must be wider than the tip, so that the sleeve behind it can follow: each layer is two strokes side by
-- side. y is the direction away from the surgeon, z the one towards the microscope. [mm]

local lens_thickness = 4.5    -- of an old lens, as biometry says before the operation
local front_radius = 10.0     -- of the front surface
local layer = 0.40            -- taken by one pair of strokes, of a tip 0.9 wide
local half_width = 0.40       -- of the groove, without the tip's own width
local stroke_speed = 3.5      -- with ultrasound [mm/s]
local return_speed = 7.0
local free_speed = 6.0        -- in front of the lens
local deep_enough = 0.82      -- share of the thickness at which to stop
local surely_deep = 0.65      -- the same, once the reflex says that little is left
local thin = 0.06             -- share of the lens that seems left under the tip, by its brightness, at which to lift
local steepest = 0.78         -- slope of the shaft at which its sleeve still clears the iris
local heed = 0.15             -- how much a new look counts against those before
local pushed = 0.4            -- shift of the lens that makes a surgeon stop

-- A place as it is believed to be after another look.
local function blend(believed, seen)
    for axis = 1, 3 do believed[axis] = believed[axis] + heed * (seen[axis] - believed[axis]) end
end

-- What is known of the eye after looking for a while.
local function look_around(me)
    me.wait_until(function(seen)
        return seen and seen.landmarks.incision and seen.landmarks.pupil and seen.landmarks.lens_front
    end, 5)
    local marks = me.see().landmarks
    local eye = { wound = marks.incision.position, pupil = marks.pupil.position, pupil_radius = marks.pupil.size,
        front = marks.lens_front.position, reflex = me.see().reflex_brightness }
    for _ = 1, 12 do
        me.wait(0.25)
        marks = me.see().landmarks
        blend(eye.wound, marks.incision.position)
        blend(eye.pupil, marks.pupil.position)
        blend(eye.front, marks.lens_front.position)
        eye.reflex = eye.reflex + heed * (me.see().reflex_brightness - eye.reflex)
    end
    return eye
end

-- How high the lens is, looked at again and again.
local function look_at_height(me, eye)
    local front = me.see().landmarks.lens_front
    if front then eye.front[3] = eye.front[3] + heed * (front.position[3] - eye.front[3]) end
end

-- Front of the lens at y, as it was before sculpting.
local function surface(eye, y) return eye.front[3] - y * y / (2 * front_radius) end

-- Least height of the tip at y at which the shaft, which turns about the wound, still clears the near edge of the iris.
local function lowest(eye, y) return eye.wound[3] - steepest * (y - eye.wound[2]) end

-- Where the groove begins, is deepest and ends.
local function plan_groove(eye)
    return { near = eye.pupil[2] - 0.35 * eye.pupil_radius, deepest = eye.pupil[2] + 0.50 * eye.pupil_radius,
        far = eye.pupil[2] + 0.75 * eye.pupil_radius, x = eye.pupil[1] }
end

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
        local z = math.max(surface(eye, y) - floor_depth(groove, depth, y), lowest(eye, y))
        return { groove.x + beside, y, z + lift }
    end
end

local function outside(eye) return { eye.wound[1], eye.wound[2] - 2.0, eye.wound[3] + 1.0 } end

local function enter(me, eye, groove)
    me.take_up(outside(eye))
    me.pedal(1)
    me.wait(0.5)
    me.go(eye.wound, free_speed)
    me.go({ groove.x, groove.near, surface(eye, groove.near) + 0.9 }, free_speed)
end

local function leave(me, eye)
    local tip = me.tip()
    me.pedal(1)
    me.go({ tip[1], tip[2], surface(eye, tip[2]) + 0.9 }, free_speed)
    me.go(eye.wound, free_speed)
    me.go(outside(eye), free_speed)
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

-- Share of the lens that seems left under the tip. Light passes the lens twice: on its way in through the whole pupil,
-- on its way out here; so the reflex at the start is exp(-2 tau), and what is left here is -log(here) / tau - 1.
local function share_left(eye, seen)
    local tau = -0.5 * math.log(math.min(0.98, eye.reflex))
    return -math.log(math.max(1e-6, seen.tip_brightness)) / tau - 1
end

-- What stops a stroke: the lens runs away from the tip, or the reflex at the tip says that little is left under it.
local function danger(eye, state)
    return function(seen)
        if push_of(eye, seen) > pushed then return "pushing" end
        if share_left(eye, seen) < state.thin then return "bright" end
        return nil
    end
end

-- Share of the lens's thickness that the groove seems to have at its deepest place.
local function seen_share(me, eye)
    local floor = me.see().landmarks.groove_floor
    if not floor then return 0 end
    return (surface(eye, floor.position[2]) - floor.position[3]) / lens_thickness
end

-- Pedal up, tip back and up, and wait until the lens has come back.
local function recover(me, eye)
    local tip = me.tip()
    me.pedal(1)
    me.go({ tip[1], tip[2] - 0.3, tip[3] + 0.8 }, return_speed)
    me.wait_until(function(seen) return push_of(eye, seen) < 0.5 * pushed end, 2)
end

-- One stroke away from the surgeon with ultrasound, and the way back without.
local function stroke(me, eye, groove, state, beside)
    local way = along(eye, groove, state.depth, beside, groove.near, groove.far, 0)
    me.go(way(0), free_speed)
    me.pedal(3)
    local reason = me.follow(way, me.about(stroke_speed) * state.pace, danger(eye, state))
    me.pedal(1)
    look_at_height(me, eye)
    if reason then recover(me, eye) end
    me.follow(along(eye, groove, state.depth, beside, me.tip()[2], groove.near, 0.5), return_speed)
    return reason
end

-- Whether to stop after a stroke that ended for a reason (nil: at its end). A bright reflex in a shallow groove is a
-- misjudgement, and is trusted less the next time.
local function enough(me, eye, state, reason)
    local share = seen_share(me, eye)
    if reason == "bright" and share < surely_deep then state.thin = state.thin - 0.1 end
    return share >= deep_enough or (reason == "bright" and share >= surely_deep)
        or state.depth > lens_thickness or me.time_s() > 180
end

return function(me)
    local eye = look_around(me)
    local groove = plan_groove(eye)
    local state = { depth = 0, pace = 1, thin = thin }
    enter(me, eye, groove)
    for number = 1, 80 do
        if number % 2 == 1 then state.depth = state.depth + me.about(layer) end
        local reason = stroke(me, eye, groove, state, number % 2 == 1 and -half_width or half_width)
        if reason == "pushing" then
            state.pace = math.max(0.3, 0.7 * state.pace)
            state.depth = state.depth - 0.5 * layer
        end
        if enough(me, eye, state, reason) then break end
    end
    leave(me, eye)
end
