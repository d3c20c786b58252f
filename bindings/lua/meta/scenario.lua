---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

-- The words of scenario tests (docs/scenarios.md). Places are { x, y, z } in the eye's frame [mm]: origin in the middle
-- of the lens, +x to the surgeon's right, +y away from the surgeon, +z to the microscope. Times are simulated [s].

---Ends a file of scenario tests: `return scenarios { ... }` for the exercise in whose folder the file lies,
---`return scenarios "groove" { ... }` for any. `patient = { ... }` in it: whose eye the hands know, in place of the
---exercise's.
---@param list rhexis.Scenario[] | string
function scenarios(list) end

---One test: `scenario "iris touched, put right" { fields, function(t) ... end }`.
---@param name string
---@return fun(fields: rhexis.Scenario): rhexis.Scenario
function scenario(name) end

---Ends the file starts.lua of an exercise: states that it prepares to start from.
---@param list table<string, rhexis.Start>
function starts(list) end

---@class rhexis.Scenario
---@field seed? integer # of the session; default 1
---@field set? table # as --set of rhexis run: { patient = { age = 80 }, ["phaco.power_limit"] = 0.6 }
---@field start? string # a name in the exercise's starts.lua, or a state file
---@field recover_within_s? number # no error has longer to be put right, whatever its own deadline [s]
---@field hold_within_s? number # no error has to last longer before it is told, whatever its own hold_s [s]
---@field silent_twin_of? string | string[] # error events that it nearly raises, and must not have raised at its end
---@field near? string | function | table # of a silent twin: holds at some time in it, else it stayed away and fails
---@field time_limit_s? number # simulated time it may take; default 300
---@field [1] fun(t: rhexis.ScenarioTest)

---@class rhexis.Start
---@field surgeon? string # who operates until the moment comes; default "d"; none beside a function
---@field seed? integer # default 1
---@field set? table # as in a scenario
---@field when? string # the moment that is kept: a condition, as in the exercise
---@field limit_s? number # simulated time in which it must come; default 300
---@field opening? string # where the bag's opening was torn: a state, a recording, a run's folder, or "EXERCISE:START"
---@field [1]? fun(t: rhexis.ScenarioTest) # instead of surgeon and moment: leads the instruments; its end is kept

---@class rhexis.ScenarioTest
---@field phaco rhexis.Instrument
---@field probe rhexis.Instrument
---@field microscope rhexis.Microscope
---@field [string] rhexis.Instrument # every other instrument of the exercise by its name
local ScenarioTest = {}

---Lets time pass.
---@param seconds number
function ScenarioTest:wait(seconds) end

---Waits until a condition holds; fails when `longest` seconds pass first.
---@param condition string | function | table # as in an exercise
---@param longest number
---@return boolean # whether it came true
function ScenarioTest:wait_until(condition, longest) end

---Runs functions side by side, for instruments that move at once; goes on when all have ended.
---@param ... fun()
function ScenarioTest:together(...) end

---Sets machine settings from the next step on: `t:set { ["phaco.power_limit"] = 0.4 }`.
---@param values table<string, number>
function ScenarioTest:set(values) end

---Asks the staff for something, or declares it, by its name in the exercise: `t:request("Bottle down")`.
---@param name string
function ScenarioTest:request(name) end

---A condition holds now.
---@param condition string | function | table
---@return boolean
function ScenarioTest:expect(condition) end

---A measure, or a sum of some, is now within a tolerance of a value.
---@param measure string
---@param value number
---@param tolerance number
---@return boolean
function ScenarioTest:expect_near(measure, value, tolerance) end

---An error event has happened, by its title or id.
---@param name string
---@param options? { recovered: boolean?, within: number? } # put right, or its deadline passed; seconds to wait for it
---@return boolean
function ScenarioTest:expect_event(name, options) end

---An error event has not happened so far; without a name: none has.
---@param name? string
---@return boolean
function ScenarioTest:expect_no_event(name) end

---The value of a measure now; nil when it is not defined.
---@param measure string
---@return number | boolean | nil
function ScenarioTest:value(measure) end

---Time since the start [s].
---@return number
function ScenarioTest:time_s() end

---@class rhexis.Movement
---@field speed? number # [mm/s], 0.01 to 200; of a smooth movement its peak; default 5
---@field seconds? number # how long it takes, instead of a speed
---@field motion? "smooth" | "even" # minimum jerk, or one speed from start to end; default smooth
---@field shaft? rhexis.Vec3 | "wound" # direction from tip to hand at the end; "wound": turning about the wound again
---@field stop? string | function | table # ends the movement as soon as this condition holds

---An instrument in an exact hand. Its shaft turns about the wound that it goes through.
---@class rhexis.Instrument
local Instrument = {}

---Appears outside its wound and goes in; the tip stops in the wound.
---@param options? { speed: number?, through: string? } # through: landmark of another wound, like "incision"
function Instrument:enter(options) end

---Straight back to the wound, out of it, and gone.
---@param options? { speed: number? }
function Instrument:withdraw(options) end

---In a straight line to a place.
---@param place rhexis.Vec3
---@param options? rhexis.Movement
---@return boolean # whether `stop` ended it
function Instrument:move_to(place, options) end

---The same by a shift from where the tip is.
---@param shift rhexis.Vec3
---@param options? rhexis.Movement
---@return boolean
function Instrument:move_by(shift, options) end

---Through several places without a halt.
---@param places rhexis.Vec3[]
---@param options? rhexis.Movement
---@return boolean
function Instrument:path(places, options) end

---The foot: 0 up, 1 irrigation, 2 aspiration, 3 ultrasound; the fraction is travel within the position.
---@param position number
function Instrument:pedal(position) end

---The jaws of the forceps: 0 closed to 1 open. Of a cannula: how hard the hand presses its syringe, 0 to 1.
---Of an injector: how far the hand pushes its plunger, share of its stroke; it goes there at up to 40 mm/s, unless
---that takes more than `injector.push_n`. At once.
---@param opening number
function Instrument:jaw(opening) end

---Turns it about its own shaft, so far from how it is held otherwise, anticlockwise as the hand sees it. At once.
---@param angle number degrees, -180 to 180
function Instrument:turn(angle) end

---Where the tip is.
---@return rhexis.Vec3
function Instrument:tip() end

---The microscope under an exact foot: 4 mm/s across and 2 mm/s in focus at most. Each word waits until it is there.
---@class rhexis.Microscope
local Microscope = {}

---Until a place is in the middle of its field and in focus. Each direction -25 to 25 mm.
---@param place rhexis.Vec3
function Microscope:move_to(place) end

---The same by a shift from where it is.
---@param shift rhexis.Vec3
function Microscope:move_by(shift) end

---Until the pupil is in the middle and its edge in focus.
function Microscope:centre() end

---What is in the middle of its field and in focus.
---@return rhexis.Vec3
function Microscope:position() end
