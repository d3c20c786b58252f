-- SPDX-License-Identifier: GPL-3.0-or-later
-- A declaration that several exercises share, with what one of them puts in place of it or adds.

--- common: a table of fields, made anew for each call; own: the fields that differ. Returns common.
return function(common, own)
    for field, value in pairs(own) do common[field] = value end
    return common
end
