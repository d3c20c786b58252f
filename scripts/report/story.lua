-- SPDX-License-Identifier: GPL-3.0-or-later
-- "In short": how far the attempt came, its errors, and what to do next time.

local markup = require "report.markup"
local report_words = require "report.words"

local t, known, count, quoted = report_words.t, report_words.known, report_words.count, report_words.quoted

local story = {}

local e = markup.escape

-- What the operator made, and what the exercise began with.
local function parted(events)
    local made, given = {}, {}
    for _, event in ipairs(events) do table.insert(event.given and given or made, event) end
    return made, given
end

-- "2 errors were made, and one put right."
local function errors_told(events)
    local made, right = #events, 0
    for _, event in ipairs(events) do right = right + (event.recovered and 1 or 0) end
    if made == 0 then return t("No error was made.") end
    if made == 1 then
        return right == 1 and t("One error was made, and put right.") or t("One error was made, and not put right.")
    end
    if right == made then return t("%d errors were made, and all put right.", made) end
    if right == 0 then return t("%d errors were made, and none put right.", made) end
    if right == 1 then return t("%d errors were made, and one of them put right.", made) end
    return t("%d errors were made, and %d of them put right.", made, right)
end

-- How events of one name ended: "not put right", "put right", "2 of 3 put right".
local function ended(all, right)
    if right == 0 then return t("not put right") end
    if right == all then return t("put right") end
    return t("%d of %d put right", right, all)
end

-- "“Iris touched” (3 times; 2 of 3 put right)", the gravest first, each name once.
local function names_of(events)
    local by_title, order = {}, {}
    for _, event in ipairs(events) do
        local title = event.title or event.id
        local same = by_title[title]
        if not same then
            same = { title = title, all = 0, right = 0, minor = event.severity == "minor", first = #order }
            by_title[title], order[#order + 1] = same, same
        end
        same.all, same.right = same.all + 1, same.right + (event.recovered and 1 or 0)
    end
    table.sort(order, function(a, b)
        if a.minor ~= b.minor then return b.minor end
        return a.first < b.first
    end)
    local names = {}
    for i, same in ipairs(order) do
        local how = ended(same.all, same.right)
        if same.all > 1 then how = t("%d times; ", same.all) .. how end
        names[i] = ("%s (%s)"):format(quoted(known(same.title)), how)
    end
    return table.concat(names, ", ")
end

local function events_told(w, events)
    local made, given = parted(events)
    if #made > 0 then w('<p class="tb">', e(t("Errors: ") .. names_of(made)), ".</p>") end
    if #given > 0 then w("<p>", e(t("The exercise began with: ") .. names_of(given)), ".</p>") end
end

-- A part that was never loaded is known by its folder only: "phaco_quadrants".
local function title_of(entry)
    local title = type(entry) == "table" and (entry.title or entry.id) or tostring(entry)
    return title:find("^[%l%d_]+$") and title:gsub("_", " ") or known(title)
end

local function titles_of(list)
    local titles = {}
    for i, entry in ipairs(list) do titles[i] = quoted(title_of(entry)) end
    return table.concat(titles, ", ")
end

-- "2 of 3 steps were completed; not completed: “Out”."
local function steps_told(report)
    local done, undone = 0, {}
    for _, step in ipairs(report.steps or {}) do
        if step.completed then
            done = done + 1
        elseif not step.skipped then
            undone[#undone + 1] = step
        end
    end
    local all = done + #undone
    if report.completed then return count(all, "The only step was completed.", "All %d steps were completed.", all) end
    if all == 0 then return t("No step was begun.") end
    if #undone == 0 then
        return count(all, "The only step that was begun was completed.",
            "All %d steps that were begun were completed.", all)
    end
    local rest = (#undone == 1 and t("; not completed: ") or t("; these were not completed: ")) .. titles_of(undone)
    if all == 1 then return t("The only step was not completed.") end
    if done == 0 then return t("None of the %d steps was completed.", all) end
    return done == 1 and t("One of %d steps was completed%s.", all, rest)
        or t("%d of %d steps were completed%s.", done, all, rest)
end

-- Where the bag could not have what was torn.
local function opening_told(w, report)
    for _, part in ipairs(report.parts or { report }) do
        if part.opening_note then
            local title = known(part.title or report.title) or t("Exercise")
            w("<p>", e(t("%s began with a round opening of the bag: what was torn before could not be its opening.",
                quoted(title))), ' <span class="soft small">(', e(part.opening_note), ")</span></p>")
        end
    end
end

-- Of an operation that was broken off, or of which only some parts were wanted.
local function not_begun_told(w, report)
    local titles = titles_of(report.not_begun or {})
    if titles == "" then return end
    w('<p class="tb">', e(t("Parts of the operation that were not begun: ")), e(titles), ".</p>")
end

-- What a report begins with is a part of an operation, or a state, whose name may be that of a file.
local function begun_in_the_middle_told(w, report)
    local place = report.begun_at
    if type(place) ~= "string" or place == "" then return end
    local part
    for _, own in ipairs(report.parts or {}) do part = part or own.id == place and own end
    local told = part and t("This operation was begun in the middle, with %s.", quoted(known(part.title or place)))
        or t("This exercise was begun in the middle: %s.", place)
    w("<p><b>", e(told), "</b> ", e(t("What came before is not judged, and the score is not compared.")), "</p>")
end

local aid_words = {
    rewound = "went back to try again", slowed = "simulated time ran slower than the clock", guided = "an expert's way "
        .. "was shown", warned = "warnings were shown", injected = "an instructor changed something",
}

-- "went back to try again (2 times)"
local function aids_told(w, report)
    local aids = report.aids or {}
    if #aids == 0 then return end
    local list = {}
    for i, aid in ipairs(aids) do
        local how = aid.id == "slowed" and t("%s s", markup.number(aid.seconds, 0)) or count(aid.times, "once",
            "%d times", aid.times)
        local of = {}
        for k, one in ipairs(aid.told or {}) do of[k] = known(one.text) end
        list[i] = #of > 0 and ("%s (%s)"):format(t(aid_words[aid.id] or aid.id), table.concat(of, "; "))
            or ("%s (%s)"):format(t(aid_words[aid.id] or aid.id), how)
    end
    w("<p><b>", e(t("With aids: ")), "</b>", e(table.concat(list, ", ")), ". ",
        e(t("Such an attempt counts for no gate, and its score is not compared.")), "</p>")
end

-- What an instructor pinned to the clock.
local function notes_told(w, report)
    if not report.notes then return end
    w("<p><b>", e(t("Notes of the instructor")), "</b></p><ul>")
    for _, note in ipairs(report.notes) do
        w("<li>", e(t("%s s", markup.number(note.time_s, 1))), " ", e(note.text), "</li>")
    end
    w("</ul>")
end

--- The section.
function story.section(w, report)
    local events = report.events or {}
    w("<section><h2>", e(t("In short")), "</h2><p>", e(steps_told(report) .. " " .. errors_told((parted(events)))),
        "</p>")
    events_told(w, events)
    begun_in_the_middle_told(w, report)
    aids_told(w, report)
    notes_told(w, report)
    opening_told(w, report)
    not_begun_told(w, report)
    if report.error then
        w('<p class="tb"><b>', e(t("The exercise was stopped by a mistake in its script:")), "</b> ", e(report.error),
            "</p>")
    end
    local advice = report.advice or {}
    if #advice > 0 then
        w("<p><b>", e(t("Next time:")), '</b></p><ol class="advice">')
        for _, line in ipairs(advice) do w("<li>", e(known(line)), "</li>") end
        w("</ol>")
    end
    w("</section>")
end

return story
