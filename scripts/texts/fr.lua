-- SPDX-License-Identifier: GPL-3.0-or-later
-- French words of engine, rubric, shared errors, report and records. Keys are the English texts, letter for letter.

local french = {}
local files = { "engine", "errors", "task_items", "global_items", "sources", "report", "charts", "names", "records",
    "anchors", "station", "theatre" }
for _, name in ipairs(files) do
    for english, text in pairs(require("texts.fr." .. name)) do french[english] = text end
end
return french
