-- SPDX-License-Identifier: GPL-3.0-or-later
-- Spaces at which no line may break: before %, and in French before : ; ? ! too. They are set on the finished page,
-- since names of exercises and of items have such signs as well.

local spaces = {}

local joined = "\u{A0}"

local verbatim = { style = true, script = true }

--- What stands between the tags of a page, but not its styles and scripts.
function spaces.page(html, language)
    local before = language == "fr" and " ([:;?!%%])" or " (%%)"
    return (html:gsub("(<(/?%a*)[^>]*>)([^<]*)", function(tag, name, text)
        return tag .. (verbatim[name] and text or text:gsub(before, joined .. "%1"))
    end))
end

return spaces
