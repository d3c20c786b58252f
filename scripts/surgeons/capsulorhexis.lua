-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon opens the anterior capsule: words that plans share. They see the picture only: no measure, no
-- event, no score.
--
-- The tear goes round against the clock as the surgeon sees it. Places about the middle of the pupil are given by
-- radius [mm], angle [degrees, 0 to the surgeon's right, 90 away from the surgeon] and height over the lens [mm].
-- Numbers below are proposals, tried on seeds under 200.

local filling = require "surgeons.filling"
local instruments = require "surgeons.instruments"
local sculpting = require "surgeons.sculpting"
local vector = require "surgeons.vector"

local capsulorhexis = {}

local free_speed = 12       -- where nothing is near [mm/s]
local clear = 0.6           -- height at which an instrument touches nothing
local lift = 1.2            -- of an instrument that is taken away, at least, for what it hooks to slip off
local lift_speed = 5
local full = 1.0            -- share of the chamber that viscoelastic is to fill

local pierce_speed = 0.6    -- of the needle, down [mm/s]
local back = 0.3           -- how far it is raised again once it is seen to be through: it has dented capsule and lens
local deepest = 0.6         -- where it is not through the capsule by then, something is wrong
local cut_speed = 3.4
local first_angle = -10     -- where the needle goes in
local first_radius = 0.9
local spiral = 25           -- angle over which the cut comes out to the planned circle
local cut_end = 200         -- angle at which it ends
local least_cut = 90        -- angle short of which the flap is not begun
local cut_look = 20         -- angle from one look to the next
local beside = 0.15         -- how far inside of the needle's way it cuts [mm]
local flare = 0.2           -- at its end the cut leads outwards by so much, for the forceps begin by leading in [mm]
local left_behind = 1.4     -- the end of the tear, by the needle, when that is not in it [mm]

local pull_speed = 4.4
local first_speed = 3.0     -- while the tear leaves the end of the cut, whose way it keeps for a while [mm/s]
local first_share = 0.5     -- of what is to be torn
local pull_step = 0.8       -- of one look to the next [mm]
local pull_height = 0.2
local ahead = 0.4           -- along the circle, how far the tear goes on until the jaws are where one sends them [mm]
local even_pull = 34        -- inwards from the circle: the tear neither leaves it nor turns in, at first [degrees]
local even_round = 29       -- and more when it has come all the way round, for it tends outwards by then
local steer_back = 140      -- more, per mm that the tear is too far out: it runs at a right angle to the pull, and the
                            -- farther out it is the more the zonules draw it on
local steer_out = 80        -- less, per mm that it is too far in
local farthest_back = 140   -- a pull that is turned farther back tears nothing [degrees]
local least_inwards = 10    -- one does not dare to pull less far inwards [degrees]
local most_turn = 25        -- of the pull from one look to the next [degrees]
local farthest_out = 3.1    -- of the jaws, clear of the iris [mm]
local another_way = 30      -- more inwards than before, where a pull has torn nothing [degrees]
local nothing = 0.3         -- the end of the tear went on by less than this [mm]
local stretch = 4.2         -- from the tear to the jaws, at which one takes hold anew [mm]
local patience = 1.8        -- how long one pulls at a tear that does not go on [s]
local least_gone = 0.01     -- of what is to be torn, that one sees [share]
local least_move = 0.15     -- of the jaws, short of which a pull has no room left [mm]
local drawn = 0.75          -- towards the jaws, how far a pull draws the end of a tear before it goes on [mm]
local drawn_round = 0.5     -- and more when it has gone all the way round
local heads = 0.75          -- share of what it has come out since the torn edge behind it, that it comes out next
local sprung = 0.05         -- outwards, how far the rest of the capsule draws the end of a fresh tear [mm]
local sprung_round = 0.15    -- and more when it has gone all the way round
local inside_tip = 0.4      -- where one takes hold, if no flap is seen [mm]
local behind_tip = 12       -- likewise [degrees]
local tries = 6             -- to take hold, before one gives up
local shallow = 0.77        -- share of the chamber below which it is filled again

--- A place by radius, angle and height.
function capsulorhexis.place(eye, radius, angle, height)
    local a = math.rad(angle)
    return { eye.pupil[1] + radius * math.cos(a), eye.pupil[2] + radius * math.sin(a),
        sculpting.surface(eye, radius) + height }
end

--- Radius and angle of a place about the middle of the pupil.
function capsulorhexis.polar(eye, place)
    local x, y = place[1] - eye.pupil[1], place[2] - eye.pupil[2]
    return math.sqrt(x * x + y * y), math.deg(math.atan(y, x))
end

local function over(eye, place, height)
    local radius = capsulorhexis.polar(eye, place)
    return { place[1], place[2], sculpting.surface(eye, radius) + height }
end

--- Through the wound, over a place of the lens.
function capsulorhexis.bring(me, eye, instrument, place)
    me.take_up(instruments.outside(eye.wound), instrument)
    me.wait(0.5)
    me.go(eye.wound, free_speed)
    me.go({ place[1], place[2], math.max(place[3], eye.front[3] + clear) }, free_speed)
end

local function withdraw(me, eye)
    me.go(eye.wound, free_speed)
    me.go(instruments.outside(eye.wound), free_speed)
    me.put_down()
end

--- Straight up and out.
function capsulorhexis.take_away(me, eye)
    local tip = me.tip()
    local up = over(eye, tip, clear)
    up[3] = math.max(up[3], tip[3] + lift)
    me.go(up, lift_speed)
    withdraw(me, eye)
end

local function mark(me, name)
    local seen = me.see()
    return seen and seen.landmarks[name]
end

--- Whether the chamber is to be filled before one pulls.
function capsulorhexis.is_shallow(seen)
    return filling.is_below(seen, shallow)
end

--- Viscoelastic until the chamber looks full, or as full as this person finds full.
function capsulorhexis.fill(me, eye)
    capsulorhexis.bring(me, eye, "cannula", capsulorhexis.place(eye, 1.0, -90, 1.0))
    filling.press(me, full)
    withdraw(me, eye)  -- straight: raised over the lens, its shaft would touch the iris by the wound
    sculpting.look_at_height(me, eye)
end

--- How far from the middle this person means the opening's edge to be.
function capsulorhexis.plan_radius(me, wanted)
    return wanted * (0.85 + 0.15 * me.about(1))
end

local function is_open(seen) return seen.landmarks.tear_tip ~= nil end

-- Cuts from the slit out to the circle and along it, a little at a time and with an eye on the tear, whose end may stay
-- behind: then the needle is not deep enough. low: height under the front [mm].
local function cut(me, eye, radius, low)
    local angle = first_angle
    local deeper = 0
    while angle < cut_end do
        local from, to = angle, math.min(cut_end, angle + cut_look)
        local tip = mark(me, "tear_tip")
        local off = angle > first_angle + spiral and tip
            and capsulorhexis.polar(eye, tip.position) - sprung - radius or 0
        local aim = radius + beside + (to == cut_end and flare or math.max(-beside, math.min(beside, -off)))
        me.follow(function(share)
            local now = from + share * (to - from)
            local out = math.sqrt(math.min(1, (now - first_angle) / spiral))  -- along the slit at first
            return capsulorhexis.place(eye, first_radius + (aim - first_radius) * out, now, low - deeper)
        end, cut_speed)
        angle = to
        tip = mark(me, "tear_tip")
        if tip and vector.distance(me.tip(), tip.position) > left_behind and deeper < deepest then
            local _, there = capsulorhexis.polar(eye, tip.position)
            deeper = deeper + 0.15
            angle = math.max(first_angle, there)
            me.go({ tip.position[1], tip.position[2], me.tip()[3] }, cut_speed)
        end
    end
end

--- Pierces the capsule and cuts until the flap is begun. True when that was seen to be so.
function capsulorhexis.begin_flap(me, eye, radius)
    local start = capsulorhexis.place(eye, first_radius, first_angle, 0)
    capsulorhexis.bring(me, eye, "cystotome", start)
    for _ = 1, 8 do
        me.wait(0.1)
        sculpting.look_at_height(me, eye)
    end
    start = capsulorhexis.place(eye, first_radius, first_angle, 0)  -- as high as it looks now
    me.go(vector.add(start, { 0, 0, 0.4 }), free_speed)
    me.go(vector.add(start, { 0, 0, -deepest }), pierce_speed, nil, is_open)
    if not mark(me, "tear_tip") then
        me.wait(0.5)
        if not mark(me, "tear_tip") then return false end
    end
    me.go(vector.add(me.tip(), { 0, 0, back }), pierce_speed)
    local low = me.tip()[3] - start[3]  -- felt, where the front is only seen
    cut(me, eye, radius, low)
    local tip = mark(me, "tear_tip")
    local _, angle = capsulorhexis.polar(eye, tip and tip.position or start)
    return angle < first_angle or angle > least_cut  -- past a half turn it counts from below
end

-- Where the flap is to be held; where none is seen, inside of the end of the tear. Nothing where that is not seen.
local function where_to_hold(me, eye)
    local flap, tip = mark(me, "flap"), mark(me, "tear_tip")
    if flap then return flap.position end
    if not tip then return nil end
    local radius, angle = capsulorhexis.polar(eye, tip.position)
    return capsulorhexis.place(eye, radius - inside_tip, angle - behind_tip, 0)
end

-- Takes hold of the flap near the tear; true when it is seen to be held.
local function grasp(me, eye)
    for try = 1, tries do
        local place = where_to_hold(me, eye)
        if not place then return false end
        me.jaw(1)
        me.go(over(eye, place, clear), free_speed)
        me.wait(0.15)
        place = where_to_hold(me, eye) or place
        me.go(vector.add(place, { 0, 0, 0.05 - 0.1 * (try - 1) }), 3)  -- lower, if it was not low enough
        me.jaw(0)
        if me.wait_until(function(seen) return seen.landmarks.held ~= nil end, 1.2) then return true end
        sculpting.look_at_height(me, eye)
    end
    return false
end

local function let_go(me, eye)
    me.jaw(1)
    me.wait(0.2)
    me.go(over(eye, me.tip(), clear), free_speed)
end

local function closed(seen) return seen.landmarks.rim ~= nil end

-- Share of what the forceps tear that is done when the tear ends at an angle; it may end a little before they begin.
local function gone(angle)
    return math.max(0, math.min(1, ((angle - cut_end + 90) % 360 - 90) / (360 - cut_end)))
end

-- How far out the end of the tear would lie in a capsule that nothing pulls at. The rest of the capsule draws it
-- outwards, the more the farther the tear has come round; the jaws draw it from where it lay when they took hold, and
-- only then does the tear go on.
local function unstrained_radius(eye, tip, grip, jaws)
    local _, angle = capsulorhexis.polar(eye, tip)
    local most = drawn + drawn_round * gone(angle)
    grip.goes_on = grip.goes_on or vector.distance(tip, grip.lay) > most
    local place = grip.lay
    if grip.goes_on then place = vector.sub(tip, vector.scale(vector.unit(vector.sub(jaws, tip)), most)) end
    return capsulorhexis.polar(eye, place) - sprung - sprung_round * gone(angle)
end

-- How much farther out the end of the tear will come next, as its edge behind it heads.
local function heading(me, eye, tip)
    local margin = mark(me, "margin")
    if not margin then return 0 end
    local at, behind = capsulorhexis.polar(eye, tip), capsulorhexis.polar(eye, margin.position)
    return heads * (at - behind)
end

-- Where the jaws go next, as seen from the end of the tear: along the circle and inwards, and the farther out the tear
-- is the more back the way it came, for it runs at a right angle to the pull. The jaws are there a look later: one
-- steers for where the tear will be then.
local function aim(me, eye, tip, grip, radius)
    local now = unstrained_radius(eye, tip, grip, me.tip())
    local soon = now + (grip.radius and now - grip.radius or grip.heads)
    if grip.goes_on then grip.radius = now end
    local _, angle = capsulorhexis.polar(eye, tip)
    local off = soon - radius
    local wanted = even_pull + even_round * gone(angle) + (off > 0 and steer_back or steer_out) * off + grip.more
    wanted = math.max(least_inwards, math.min(farthest_back, wanted))
    local last = grip.inwards or wanted
    grip.inwards = math.max(last - most_turn, math.min(last + most_turn, wanted))
    local along, way = math.rad(angle + 90), math.rad(angle + 90 + grip.inwards)
    local lead = grip.goes_on and ahead or 0
    local from = vector.add(tip, { lead * math.cos(along), lead * math.sin(along), 0 })
    local reach = vector.distance(me.tip(), from) + pull_step
    local out, where = capsulorhexis.polar(eye,
        { from[1] + reach * math.cos(way), from[2] + reach * math.sin(way), 0 })
    return capsulorhexis.place(eye, math.min(out, farthest_out), where, pull_height)
end

-- Whether the end of a tear that went on has not come farther round for longer than one waits.
local function is_stuck(me, eye, tip, grip)
    if not grip.goes_on then return false end
    local _, angle = capsulorhexis.polar(eye, tip)
    local share = gone(angle)
    if not grip.farthest or share > grip.farthest + least_gone then
        grip.farthest, grip.went_on_s = share, me.time_s()
    end
    return me.time_s() > grip.went_on_s + patience
end

-- Pulls until it is time to take hold anew. more: inwards than one would [degrees]. Returns what ended it.
local function pull(me, eye, radius, more)
    -- lay: where the end of the tear lay at first; goes_on: the tear does; of the last look, inwards: the pull
    -- [degrees], radius: how far out the tear was
    local grip
    while true do
        if mark(me, "rim") then return "closed" end
        local tip = mark(me, "tear_tip")
        if not tip then return "lost" end
        if not mark(me, "held") then return "slipped" end
        if vector.distance(me.tip(), tip.position) > stretch then return "far" end
        grip = grip or { lay = tip.position, more = more, heads = heading(me, eye, tip.position) }
        if is_stuck(me, eye, tip.position, grip) then return "stuck" end
        local place = aim(me, eye, tip.position, grip, radius)
        if vector.distance(me.tip(), place) < least_move then return "far" end
        local _, angle = capsulorhexis.polar(eye, tip.position)
        me.go(place, gone(angle) < first_share and first_speed or pull_speed, nil, closed)
    end
end

-- The forceps through the wound, over the end of the tear.
local function bring_forceps(me, eye)
    local tip = mark(me, "tear_tip")
    capsulorhexis.bring(me, eye, "forceps", tip and tip.position or eye.pupil)
end

-- Whether a pull has led the end of the tear on, from where it lay.
local function went_on(me, lay)
    local tip = mark(me, "tear_tip")
    return not lay or not tip or vector.distance(tip.position, lay.position) > nothing
end

--- Tears the flap round with the forceps. plan: { radius = of the circle [mm], inwards = how much farther inwards than
--- usual one pulls [degrees] }; longest: [s]. Returns "closed", or why it stopped.
function capsulorhexis.tear_round(me, eye, plan, longest)
    local until_s = me.time_s() + longest
    local more = 0
    bring_forceps(me, eye)
    while me.time_s() < until_s do
        if mark(me, "rim") then return "closed" end
        if me.notices(capsulorhexis.is_shallow) then
            capsulorhexis.take_away(me, eye)
            capsulorhexis.fill(me, eye)
            bring_forceps(me, eye)
        end
        local lay = mark(me, "tear_tip")
        if not grasp(me, eye) then return "not grasped" end
        local why = pull(me, eye, plan.radius, plan.inwards + more)
        if why == "closed" then return why end
        let_go(me, eye)
        more = went_on(me, lay) and 0 or more + another_way
        if why == "lost" then return why end
    end
    return "late"
end

return capsulorhexis
