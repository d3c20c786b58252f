-- SPDX-License-Identifier: GPL-3.0-or-later
return { hello = function(name) return "hello " .. name end }
