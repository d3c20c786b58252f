-- SPDX-License-Identifier: GPL-3.0-or-later
-- Building HTML and SVG text. Whatever comes from a report, a curriculum or a patient goes through escape(). Numbers
-- of attributes are written with string.format: number() and time() are for readers.

local markup = {}

local entities = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;", ["'"] = "&#39;" }

function markup.escape(value)
    return (tostring(value):gsub("[&<>\"']", entities))
end

local point = "."

--- Chooses the language whose decimal sign numbers have.
function markup.use(language) point = language == "fr" and "," or "." end

--- A number with at most `digits` decimals; "-" for what is no number.
function markup.number(value, digits)
    if type(value) ~= "number" or value ~= value then return "–" end
    local text = ("%." .. (digits or 2) .. "f"):format(value)
    if text:find(".", 1, true) then text = text:gsub("0+$", ""):gsub("%.$", "") end
    return (text:gsub("^%-0$", "0"):gsub("^%-", "−"):gsub("%.", point))
end

--- Minutes and seconds.
function markup.time(seconds)
    if type(seconds) ~= "number" then return "–" end
    if seconds < 60 then return (("%.1f s"):format(seconds):gsub("%.", point)) end
    return ("%d min %02d s"):format(seconds // 60, math.floor(seconds % 60))
end

local Writer = {}
Writer.__index = Writer

--- Collects pieces of text: w("<p>", text, "</p>").
function markup.writer() return setmetatable({ pieces = {} }, Writer) end

function Writer.__call(self, ...)
    for i = 1, select("#", ...) do
        local piece = select(i, ...)
        self.pieces[#self.pieces + 1] = tostring(piece)
    end
end

function Writer:text() return table.concat(self.pieces) end

return markup
