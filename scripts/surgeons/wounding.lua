-- SPDX-License-Identifier: GPL-3.0-or-later
-- What hands do at the wounds of the eye: cut, swell, sew, press. Everything by what is seen. [mm]

local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local wounding = {}

local quick, careful = 12.0, 4.0
local swollen = 0.7        -- how white the stroma is made
local press_depth = 0.8    -- of the sponge into the lip

--- A place so far inwards from a site, along the surface of the view, so high over it, and so far along the lip.
function wounding.from(site, inwards, up, aside)
    local out = vector.unit({ site[1], site[2], 0 })
    aside = aside or 0
    return { site[1] - inwards * out[1] - aside * out[2], site[2] - inwards * out[2] + aside * out[1], site[3] + up }
end
local from = wounding.from

local function site_of(me, name) return me.see().landmarks[name].position end

--- Takes up an instrument outside a site.
function wounding.take(me, hand, name, site)
    hand.take_up(instruments.outside(site_of(me, site)), name, site)
    me.wait(0.4)
end

--- Away from the eye, and put down.
function wounding.put_away(me, hand, site)
    hand.jaw(0)
    hand.go(from(site_of(me, site), -1.5, 1.2), quick)
    hand.put_down()
end

--- The side port: straight through.
function wounding.cut_side_port(me)
    wounding.take(me, me.left, "side_port_blade", "side_port_site")
    local site = site_of(me, "side_port_site")
    me.left.go(site, quick)
    me.left.go(from(site, 2.8, 0.7), careful)
    me.left.go(site, careful)
    wounding.put_away(me, me.left, "side_port_site")
end

--- The main incision: along the slope of the cornea, then level into the chamber, and back the same way.
function wounding.cut_tunnel(me, within)
    wounding.take(me, me, "keratome", "incision_site")
    local site = site_of(me, "incision_site")
    local first = math.max(0.2, math.min(2.4, me.about(within)))
    local turn = from(site, first, 0.72 * first)
    me.go(site, quick)
    me.go(turn, careful)
    me.go(from(site, first + 2.7, 0.72 * first - 0.1), careful)
    me.go(turn, careful)
    me.go(site, careful)
    wounding.put_away(me, me, "incision_site")
end

local function size(seen, name)
    local mark = seen.landmarks[name]
    return mark and mark.size or 0
end

--- Saline into the stroma beside the main wound, until it is white.
function wounding.hydrate(me, more)
    wounding.take(me, me, "hydration_cannula", "incision_site")
    local site = site_of(me, "incision_site")
    me.go(site, quick)
    me.go(from(site, 0.55, 0.2), careful)
    me.jaw(1)
    local wanted = math.min(0.98, me.about(swollen) + (more or 0))
    me.wait_until(function(seen) return size(seen, "stroma_white") >= wanted end, 4)
    me.jaw(0)
    me.go(site, careful)
    wounding.put_away(me, me, "incision_site")
end

--- Saline into the chamber, for so long.
function wounding.fill(me, seconds)
    wounding.take(me, me, "hydration_cannula", "incision_site")
    local site = site_of(me, "incision_site")
    me.go(site, quick)
    me.go(from(site, 1.3, 0.4), careful)
    me.go(from(site, 2.8, 0.75), careful)
    me.jaw(1)
    me.wait(me.about(seconds))
    me.jaw(0)
    me.go(from(site, 1.3, 0.4), quick)
    me.go(site, quick)
    wounding.put_away(me, me, "incision_site")
end

--- Presses on the lip; returns how hard the eye felt [mmHg] and whether fluid came.
function wounding.test(me)
    wounding.take(me, me, "sponge", "incision_site")
    local site = site_of(me, "incision_site")
    me.go(from(site, -0.4, 0.4), quick)
    me.go(from(site, 0.77 * press_depth, -0.64 * press_depth), careful)
    me.wait(2.0)  -- what lay there is soaked up first
    local seen = me.see()
    local hard, wet = size(seen, "hardness"), seen.landmarks.wound_fluid ~= nil
    me.go(from(site, -0.4, 0.4), careful)
    wounding.put_away(me, me, "incision_site")
    return hard, wet
end

--- A stitch over the lip, so far from its middle.
function wounding.stitch(me, aside)
    wounding.take(me, me, "needle_holder", "incision_site")
    local site = site_of(me, "incision_site")
    me.go(from(site, -1.3, 0.4, aside), quick)
    me.go(from(site, -0.75, -0.86, aside), careful)
    me.go(from(site, 0.2, -0.3, aside), careful)
    me.go(from(site, 0.95, 1.2, aside), careful)
    wounding.put_away(me, me, "incision_site")
end

return wounding
