-- SPDX-License-Identifier: GPL-3.0-or-later
-- Mistakes of who writes an exercise are told by the line that they stand on, in words that help.
local host = require "engine.host"
local quotes = require "engine.quotes"
local settings_check = require "engine.settings_check"
local support = require "support"
local words = require "engine.words"

local case, equal, fails = support.case, support.equal, support.fails

local settings = { { name = "phaco.power_limit", from = 0, to = 1, live = true },
    { name = "implant.triangles", from = 100, to = 9000, live = false },
    { name = "bleeding.pressure", from = 0, to = 80, live = true, tissue = true } }

-- Runs a script of a step with one line of its own, the sixth of the file; settings are known.
local function scripted(line)
    local exercise = support.demo({ steps = 'step "s" { script = function(eye, act)\n ' .. line .. "\nend }" })
    settings_check.know(settings)
    local ok, result, commands = pcall(support.attempt, exercise, 1, function() return {} end)
    settings_check.forget()
    if not ok then error(result, 0) end
    return commands
end

case("a script of a step that gives a wrong value is told its line and what is allowed", function()
    local function refused(line, ...)
        local advice = { ... }
        fails(function() scripted(line) end, "demo/curriculum.lua:6: ", "(in step 's')", table.unpack(advice))
    end
    refused('act.set("phaco.power_limt", 1)', "no setting 'phaco.power_limt'", "did you mean phaco.power_limit")
    refused('act.set("phaco.power_limit", 0/0)', "act.set: phaco.power_limit must be a number, not nan")
    refused('act.set("phaco.power_limit", "x")', "act.set: phaco.power_limit must be a number, not \"x\"")
    refused('act.set("phaco.power_limit", 7)', "phaco.power_limit = 7 is out of range (0 to 1)")
    refused('act.set("implant.triangles", 500)', "implant.triangles is fixed before the first step")
    refused('act.set("bleeding.pressure", 40)', "bleeding.pressure is the eye's", "only a request of the instructor")
    refused("act.set(nil, 1)", "act.set: setting must be a text in quotes, not nil")
    refused("act.wait(0/0)", "act.wait must be a number of seconds, 0 or more, not nan")
    refused("act.wait(math.huge)", "0 or more, not inf")
    refused("act.wait(-1)", "0 or more, not -1")
    refused('act.wait("x")', "0 or more, not \"x\"")
    refused("act.say({})", "act.say must be a text in quotes, not a table")
    refused("act.say(nil)", "act.say must be a text in quotes, not nil")
    refused('act.say("\\27[31m")', "act.say holds the control character \\27")
    refused('act.sayy("x")', "act has no 'sayy' (did you mean say?)")
    refused("act.picture(3)", "act.picture: name must be a text in quotes, not 3")
    refused('act.wait_until("tip.deth_mm > 1")', "unknown measure 'tip.deth_mm'")
    refused('act.wait_until("tip.depth_mm")', "tip.depth_mm is a number")
    refused('act.wait_until("tip.touch", 0/0)', "act.wait_until: the longest time must be a number of seconds")
end)

case("what a script of a step may give is taken", function()
    local commands = scripted('act.set("phaco.power_limit", true) act.say("a\\n\\tb") act.picture("p") '
        .. 'act.wait_until("tip.touch", 0.1) act.wait(0) act.set("phaco.power_limit", 0.5)')
    equal(commands[1].value, 1)
    equal(commands[2].text, "a\n\tb")
    equal(commands[4].value, 0.5)
end)

case("tables of names hold no entry without one", function()
    fails(function() support.demo({ rest = 'levels = { "easy" },' }) end,
        "demo/curriculum.lua:7: levels: \"easy\" has no name: write easy = {")
    fails(function() support.demo({ rest = "goals = { 5 }," }) end, "demo/curriculum.lua:7: goals: 5 has no name")
    fails(function() support.demo({ rest = "settings = { 5 }," }) end, "demo/curriculum.lua:7: settings: 5 has no name")
    fails(function() support.demo({ rest = "reference = { 5 }," }) end, "curriculum.lua:7: reference: 5 has no name")
    fails(function() support.demo({ rest = 'texts = { "fr" },' }) end, "curriculum.lua:7: texts: \"fr\" has no name")
end)

case("an item of the score is listed once", function()
    fails(function() support.demo({ rest = 'scoring = osacss { "G4", "G4" },' }) end,
        "demo/curriculum.lua:7: item 'G4' is listed twice")
    fails(function() support.demo({ rest = 'scoring = osacss "G4",' }) end, "demo/curriculum.lua:7:", "a list of items")
end)

case("goals and settings that are formed wrongly name their line", function()
    fails(function() support.demo({ rest = 'goals = { far_mm = { 1, from = "a" } },' }) end,
        "demo/curriculum.lua:7: goal far_mm: from must be a number, not \"a\"")
    fails(function() support.demo({ rest = "goals = { far_mm = { 1, form = 2 } }," }) end, "did you mean from")
    fails(function() support.demo({ rest = "goals = { far_mm = { 1, from = 3, to = 2 } }," }) end,
        "goal far_mm: from = 3 is above to = 2")
    fails(function()
        support.load("local s = {}\ns.phaco = s\nreturn exercise { title = 'x', tissues = { 'lens' },\n"
            .. "settings = s, instruments = { 'phaco' }, steps = { step 'a' { done = 'time_s > 1' } } }")
    end, "demo/curriculum.lua:", "settings: phaco.phaco is a table within a table")
end)

case("no text commands the terminal that it is shown on", function()
    fails(function() support.demo({ rest = 'summary = "a\\27[31m",' }) end, "demo/curriculum.lua:7: exercise: summary "
        .. "holds the control character \\27")
    fails(function() support.demo({ rest = 'objectives = { "a\\u{9b}31m" },' }) end, "control character \\155")
    fails(function() support.demo({ rest = 'summary = "a\\xe9",' }) end, "is no UTF-8: save the file in that form")
    fails(function() support.demo({ steps = 'step "a" { title = "a\\nb", done = "tip.touch" }' }) end,
        "step 'a': title holds the control character \\10")
    fails(function() support.demo({ steps = 'step "a\\7" { done = "tip.touch" }' }) end, "its name holds the control")
    fails(function() support.demo({ rest = 'texts = { fr = { Demo = "\\27c" } },' }) end, "holds the control character")
    fails(function() support.demo({ rest = 'levels = { ["e\\27c"] = {} },' }) end, "the name 'e\\27c' holds")
    local message = fails(function() support.demo({ rest = '["\\27[31m"] = 1,' }) end, "'\\27[31m'")
    equal(message:find("%c"), nil, "a message holds what it refuses")
    equal(support.demo({ rest = 'summary = "two\\n\\tlines – é",' }).summary, "two\n\tlines – é")
end)

case("words that are misspelt bring near ones", function()
    local function load_as_host(text)
        words.begin_file("demo/curriculum.lua", text)
        return harness.compile(text, "demo/curriculum.lua", host.environment())()
    end
    fails(function() load_as_host("local a = 1\nreturn stepp 'x' {}") end, "demo/curriculum.lua:2: there is no word "
        .. "'stepp' (did you mean step?)")
    fails(function() load_as_host("return osacs { 'G4' }") end, "did you mean osacss?")
    fails(function() load_as_host("return errorevent 'x' {}") end, "did you mean error_event?")
    fails(function() load_as_host("\nreturn zzzzzzzz") end, "demo/curriculum.lua:2: there is no word 'zzzzzzzz'")
    equal(load_as_host("own = 1 return type(own) .. type(math.pi) .. type(step)"), "numbernumberfunction")
end)

case("quotation marks of a word processor are named", function()
    local function refuse(text) quotes.refuse_curly("demo/curriculum.lua", text) end
    fails(function() refuse('return {\n title = “x”,\n}') end, "demo/curriculum.lua:2: “ is a quotation mark of a word "
        .. "processor: write straight ones")
    fails(function() refuse('return { "a", [[“\n]], ‘x’ }') end, "demo/curriculum.lua:2: ‘")
    fails(function() refuse("-- “\nreturn «x»") end, "demo/curriculum.lua:2: «")
    for _, text in ipairs({ 'return "“a” é \\" ”"', "-- “x”", "--[==[\n“ ]] ” ]==] return 1", "return [=[ “ ]=]",
        "return 'l’œil' -- «", "a - b [1] = 2" }) do
        refuse(text)
    end
end)
