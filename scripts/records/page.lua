-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the pages about stored attempts have in common.

local markup = require "report.markup"
local report_words = require "report.words"
local style = require "report.style"

local page = {}

--- The whole page, in the language chosen with report_words.use; body(w) writes what is inside. more: style of its own.
function page.html(title, body, more)
    local w = markup.writer()
    w('<!doctype html><html lang="', report_words.language(), '"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1"><title>', markup.escape(title),
        "</title><style>", style, more or "", "</style></head><body><main>")
    body(w)
    w("</main></body></html>\n")
    return w:text()
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
