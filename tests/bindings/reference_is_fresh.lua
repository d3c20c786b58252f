-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "scripts/dev/api/?.lua;" .. package.path
local reference = require "reference"
local file = assert(io.open("docs/api.md"))
local text = file:read("a")
file:close()
assert(text == reference.render("bindings/lua/meta"),
    "docs/api.md is stale: rhexis lua scripts/dev/api/reference.lua > docs/api.md")
