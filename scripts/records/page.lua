-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the pages about stored attempts have in common.

local markup = require "report.markup"
local report_words = require "report.words"
local style = require "report.style"
local typography = require "report.typography"

local page = {}

--- A table that scrolls within its section where it is wider than the window, which body() fills: at least so many
--- letters wide; a keyboard can move it too.
function page.wide_table(w, least, body)
    w('<div class="scroll" tabindex="0"><table style="min-width:', least, 'rem">')
    body()
    w("</table></div>")
end

--- A moment as it is stored, "2026-03-01T09:30:00Z", for readers.
function page.moment(stored)
    local day, time = tostring(stored):match("^(%d+%-%d+%-%d+)T(%d+:%d+)")
    return day and day .. " " .. time .. " UTC" or tostring(stored)
end

--- The whole page, in the language chosen with report_words.use; body(w) writes what is inside. more: style of its own.
function page.html(title, body, more)
    local w = markup.writer()
    w('<!doctype html><html lang="', report_words.language(), '"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1"><title>', markup.escape(title),
        "</title><style>", style, more or "", "</style></head><body><main>")
    body(w)
    w("</main></body></html>\n")
    return typography.page(w:text(), report_words.language())
end

--- Values from `low` to `high` at distances that read well, at most seven of them.
function page.ticks(low, high)
    local step = 10 ^ math.floor(math.log((high - low) / 3, 10))
    while (high - low) / step > 6 do step = step * (math.log(step, 10) % 1 < 0.01 and 2 or 2.5) end
    local list = {}
    for i = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) do list[#list + 1] = i * step end
    return list
end

return page
