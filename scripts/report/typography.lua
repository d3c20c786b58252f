-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a language is set: no line breaks before %. French has a decimal comma, « » and spaces that do not break before
-- : ; ? ! and units as well. It is done on the finished page, since much of its text comes from exercises, rubrics and
-- the kernel.

local typography = {}

local joined = "\u{A0}"

local units = {}
for unit in ("mm mm² mm³ mm/s mm/s³ mm³/s mm³/mmHg cm µm ml ml/min µl/s mmHg mN N mg mJ s ms min Hz kHz × x ans points"
    .. " °C"):gmatch("%S+") do units[unit] = true end

local function before_unit(digit, word)
    return units[word] and digit .. joined .. word or nil
end

--- One piece of French text.
function typography.french(text)
    text = text:gsub("(%d)%.(%d)", "%1,%2"):gsub("(%d) ([^%s,;:%.%)%(&]+)", before_unit)
    text = text:gsub("“%s*", "«" .. joined):gsub("%s*”", joined .. "»"):gsub("« ", "«" .. joined)
    text = text:gsub(" ([:;?!%%])", joined .. "%1"):gsub(" »", joined .. "»")
    return (text:gsub("(%d" .. joined .. "min) (%d)", "%1" .. joined .. "%2"))
end

-- One piece of text in any other language.
local function usual(text) return (text:gsub(" %%", joined .. "%%")) end

local verbatim = { style = true, code = true, script = true }

--- A whole page: what stands between its tags, but not styles, scripts and code.
function typography.page(html, language)
    local set = language == "fr" and typography.french or usual
    return (html:gsub("(<(/?%a*)[^>]*>)([^<]*)", function(tag, name, text)
        return text == "" and tag or tag .. (verbatim[name] and text or set(text))
    end))
end

return typography
