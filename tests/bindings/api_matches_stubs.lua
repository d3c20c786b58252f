-- SPDX-License-Identifier: GPL-3.0-or-later
-- Walks the live API and the stubs and fails on any name that is missing on either side, and on defaults and ranges
-- that are not those of the binding.
package.path = "scripts/dev/api/?.lua;" .. package.path
local stubs = require "stubs"
local classes, by_name = stubs.read("bindings/lua/meta")

local faults = {}
local function fault(...)
    faults[#faults + 1] = string.format(...)
end

local function set_of(list, key)
    local set = {}
    for _, item in ipairs(list) do
        set[key and item[key] or item] = true
    end
    return set
end

local function compare(what, live, described)
    for name in pairs(live) do
        if not described[name] then
            fault("%s: %s exists but has no stub", what, name)
        end
    end
    for name in pairs(described) do
        if not live[name] then
            fault("%s: %s has a stub but does not exist", what, name)
        end
    end
end

local function keys(table)
    local set = {}
    for name in pairs(table) do
        set[name] = true
    end
    return set
end

-- ---- modules and classes

compare("rhexis", keys(rhexis), set_of(by_name["rhexis"].fields, "name"))
local registry = debug.getregistry()
for name, metatable in pairs(registry) do
    if type(name) == "string" and name:find("^rhexis%.%u") and not by_name[name] then
        fault("class %s has no stub", name, metatable)
    end
end
for _, class in ipairs(classes) do
    local module = rhexis[class.name:match("^rhexis%.(%l%w*)$") or ""]
    local metatable = registry[class.name]
    if module then
        compare(class.name, keys(module), set_of(class.functions, "name"))
    elseif metatable then
        local methods = type(metatable.__index) == "table" and metatable.__index or {}
        compare(class.name, keys(methods), set_of(class.functions, "name"))
    elseif #class.functions > 0 then
        fault("%s has a stub but does not exist", class.name)
    end
    for _, fn in ipairs(class.functions) do
        if not fn.example then
            fault("%s.%s: the stub has no example", class.name, fn.name)
        end
        if #fn.text == 0 then
            fault("%s.%s: the stub does not say what it does", class.name, fn.name)
        end
    end
end

-- ---- options: an unknown field is refused with the list of those that are known

local scene = rhexis.scene.create()
local mesh = rhexis.mesh.bar()
local sheet = rhexis.mesh.sheet { triangles = 50 }
local tool = scene:add_ball()
local takes = {
    ["rhexis.Box"] = function(t) mesh:select(t) end,
    ["rhexis.BarOptions"] = rhexis.mesh.bar,
    ["rhexis.BallOptions"] = rhexis.mesh.ball,
    ["rhexis.LensOptions"] = rhexis.mesh.lens,
    ["rhexis.SheetOptions"] = rhexis.mesh.sheet,
    ["rhexis.SceneOptions"] = rhexis.scene.create,
    ["rhexis.SolidOptions"] = function(t) t.mesh = mesh scene:add_solid(t) end,
    ["rhexis.MembraneOptions"] = function(t) t.sheet = sheet scene:add_membrane(t) end,
    ["rhexis.BallToolOptions"] = function(t) scene:add_ball(t) end,
    ["rhexis.RodToolOptions"] = function(t) scene:add_rod(t) end,
    ["rhexis.PhacoToolOptions"] = function(t) scene:add_phaco(t) end,
    ["rhexis.PlaneOptions"] = function(t) scene:add_plane(t) end,
    ["rhexis.MoveOptions"] = function(t) tool:move(t) end,
    ["rhexis.DrawOptions"] = function(t) rhexis.render.draw(scene, t) end,
    ["rhexis.CameraOptions"] = function(t) rhexis.render.draw(scene, { camera = t }) end,
    ["rhexis.VideoOptions"] = function(t) rhexis.render.video("unused.mp4", t) end,
    ["rhexis.EyeOptions"] = rhexis.eye.create,
}

-- What a stub says of a default, as a value; nil where it is told in words ("as it is", "from age").
local function said_default(text)
    local said = text:match("default (.*)$")
    local literal = said and load("return " .. said, "default", "t", {})
    if not literal then return nil, said end
    local done, value = pcall(literal)
    if done then return value, said end
    return nil, said
end

local function same(a, b)
    if type(a) ~= "table" or type(b) ~= "table" then
        return a == b
    end
    for k = 1, math.max(#a, #b) do
        if a[k] ~= b[k] then return false end
    end
    return true
end

-- "0.001 to 1000 mm" and "[mm]; 0.001 to 1000; default 1": the same two numbers?
local function same_range(allowed, text)
    local low, high = allowed:match("^above (%S+) up to (%S+)")
    local said_low, said_high = text:match("above (%S+) up to ([^%s;,]+)")
    if not low then
        low, high = allowed:match("^(%S+) to (%S+)")
        for a, b in text:gmatch("(%-?%d[%d.e+-]*)[^;:]- to (%-?%d[%d.e+-]*)") do
            said_low, said_high = a, b
        end
    end
    return not low or (tonumber(low) == tonumber(said_low) and tonumber(high) == tonumber(said_high))
end

local function compare_options(name, told)
    for _, field in ipairs(by_name[name].fields) do
        local live = told[field.name]
        local value, said = said_default(field.text)
        if live and said and value ~= nil and not same(live.default, value) then
            fault("%s: %s: the stub says default %s, the binding takes %s", name, field.name, said,
                type(live.default) == "table" and table.concat(live.default, ", ") or tostring(live.default))
        end
        if live and not same_range(live.allowed, field.text) then
            fault("%s: %s: the stub says \"%s\", the binding allows %s", name, field.name, field.text, live.allowed)
        end
        local chosen = live and field.type:find('"', 1, true)
        if chosen and live.allowed ~= field.type:gsub('"', ""):gsub("|", ", ") then
            fault("%s: %s: the stub says %s, the binding allows %s", name, field.name, field.type, live.allowed)
        end
    end
end

for name, take in pairs(takes) do
    local told = {}
    registry["rhexis.options"] = told
    local done, message = pcall(take, { qqqqqqqqqqqq = 1 })
    registry["rhexis.options"] = nil
    compare_options(name, told)
    local list = not done and message:match("unknown field 'qqqqqqqqqqqq' %(one of (.*)%)")
    if not list then
        fault("%s: an unknown field gives: %s", name, tostring(message))
    else
        local live = {}
        for field in list:gmatch("[%w_]+") do
            live[field] = true
        end
        compare(name, live, set_of(by_name[name].fields, "name"))
    end
end

-- ---- results

scene:add_plane { point = { 0, 0, 0.001 } }
scene:add_solid { mesh = mesh, young_modulus = 3000 }
local membrane = scene:add_membrane { sheet = rhexis.mesh.sheet() }
membrane:puncture({ 5, 5, 0 }, { 1, 0, 0 })
assert(scene:step(3))
local eye = rhexis.eye.create { tetrahedra = 500 }
local contact = {}  -- one is of a body or of a sheet
for _, one in ipairs(scene:contacts()) do
    for field, value in pairs(one) do contact[field] = value end
end
local gives = {
    ["rhexis.MeshInfo"] = mesh:info(),
    ["rhexis.SheetInfo"] = sheet:info(),
    ["rhexis.TearTip"] = membrane:tips()[1],
    ["rhexis.Torn"] = membrane:torn(),
    ["rhexis.MembraneReport"] = scene:report().membranes[1],
    ["rhexis.Contact"] = contact,
    ["rhexis.Energy"] = scene:energy(),
    ["rhexis.Report"] = scene:report(),
    ["rhexis.SolidReport"] = scene:report().solids[1],
    ["rhexis.Measure"] = eye:measures()[1],
    ["rhexis.Anatomy"] = eye:anatomy(),
}
for name, result in pairs(gives) do
    compare(name, keys(result), set_of(by_name[name].fields, "name"))
end
for _, class in ipairs(classes) do
    if #class.fields > 0 and not (takes[class.name] or gives[class.name] or class.name == "rhexis") then
        fault("%s is described but not compared here", class.name)
    end
end

assert(#faults == 0, "\n" .. table.concat(faults, "\n"))
