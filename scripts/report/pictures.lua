-- SPDX-License-Identifier: GPL-3.0-or-later
-- Pictures of an attempt, held in the page itself: not more than a browser opens readily.

local markup = require "report.markup"
local report_words = require "report.words"

local t, known, count = report_words.t, report_words.known, report_words.count

local pictures = {}

local e = markup.escape

--- A picture adds some 0.65 MB to the page. Usual attempts have 8 to 30, one with an error every few seconds hundreds.
pictures.most = 48

-- For each picture: how many of its name there are up to it. An error put right counts with that error.
local function turns(list)
    local seen, result = {}, {}
    for i, picture in ipairs(list) do
        local name, put_right = tostring(picture.name):gsub("^recovered_", "error_")
        if put_right == 0 or not seen[name] then seen[name] = (seen[name] or 0) + 1 end
        result[i] = seen[name]
    end
    return result
end

-- The first of every name, then the second of every name and so on while there is room; in their order. An error made
-- again and again thus leaves room for everything else.
local function chosen(list)
    if #list <= pictures.most then return list end
    local turn, order, result = turns(list), {}, {}
    for i = 1, #list do order[i] = i end
    table.sort(order, function(a, b)
        if turn[a] ~= turn[b] then return turn[a] < turn[b] end
        return a < b
    end)
    local kept = table.move(order, 1, pictures.most, 1, {})
    table.sort(kept)
    for i, index in ipairs(kept) do result[i] = list[index] end
    return result
end

-- Captions that the kernel and the engine give, of a run in English; in an operation, after the name of the part.
local captions = { "Before the first step.", "At the end.", 'Step "%s" completed.', 'Step "%s" not completed.',
    'During step "%s".', "Error: %s." }

local function translated(caption)
    for _, own in ipairs(captions) do
        local pattern = own:gsub("%.", "%%."):gsub("%%s", "(.+)")
        local part, title = caption:match("^(.-: )" .. pattern .. "$")
        if not part then part, title = "", caption:match("^" .. pattern .. "$") end
        if title then
            part = part ~= "" and known(part:sub(1, -3)) .. part:sub(-2) or ""
            return part .. (own:find("%s", 1, true) and t(own, known(title)) or t(own))
        end
    end
    return known(caption)
end

local function figure(w, picture, bytes)
    local caption = translated(picture.caption or picture.name or "")
    w('<figure><img alt="', e(caption), '" src="data:image/png;base64,', bytes, '"><figcaption>', e(caption),
        ' <span class="soft unit">', markup.time(picture.time_s), "</span></figcaption></figure>")
end

--- The section of pictures; none where no picture is left. images: file name to base64 text of a PNG.
function pictures.section(w, report, images)
    local all, shown = report.pictures or {}, {}
    local kept = chosen(all)
    for _, picture in ipairs(kept) do
        local bytes = images[picture.file]
        local again = picture.name == "end" and shown[#shown] and shown[#shown][2] == bytes  -- as the last step ended
        if bytes and not again and bytes:find("^[%w+/=\r\n]+$") then shown[#shown + 1] = { picture, bytes } end
    end
    if #shown == 0 then return end
    w("<section><h2>", e(t("Pictures")), "</h2>")
    if #all > #kept then
        w('<p class="soft small">', t("Of what happened often, only the first pictures are here."), " ",
            count(#all - #kept, "The other %d of %d lies in %s, beside this page.",
                "The other %d of %d lie in %s, beside this page.", #all - #kept, #all,
                '<a href="frames/">frames/</a>'), "</p>")
    end
    w('<div class="pictures">')
    for _, entry in ipairs(shown) do figure(w, entry[1], entry[2]) end
    w("</div></section>")
end

return pictures
