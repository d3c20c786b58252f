-- SPDX-License-Identifier: GPL-3.0-or-later
-- French puts a space before : ; ? ! and % at which no line may break. It is set on the finished page, since names of
-- exercises and of items have such signs too.

local spaces = {}

local joined = "\u{A0}"

local verbatim = { style = true, script = true }

--- What stands between the tags of a page, but not its styles and scripts.
function spaces.page(html, language)
    if language ~= "fr" then return html end
    return (html:gsub("(<(/?%a*)[^>]*>)([^<]*)", function(tag, name, text)
        return tag .. (verbatim[name] and text or text:gsub(" ([:;?!%%])", joined .. "%1"))
    end))
end

return spaces
