-- SPDX-License-Identifier: GPL-3.0-or-later
-- Conditions and quantities written as text: "phaco.tip_posterior_mm < 0.3 and phaco.aspirating".
--
--   or, and, not     < <= > >= == ~= !=     + - * /     ( )     numbers, true, false     min, max, abs, sqrt
--
-- A measure that is not defined now (an instrument outside the eye has no depth) makes a sum undefined and a
-- comparison false. parse() finds mistakes of form when a curriculum loads; bind() finds unknown names when the
-- scene is known, and makes a function without arguments.

local measures = require "engine.measures"
local words = require "engine.words"

local expression = {}

local longest, deepest = 4000, 100  -- characters of a text, and how many brackets or `not` may stand in each other

local comparisons = { ["<"] = true, ["<="] = true, [">"] = true, [">="] = true, ["=="] = true, ["~="] = true,
    ["!="] = true }

-- What was meant by a character that means nothing here.
local meant = { ["="] = "write == to compare", ["&"] = "write and", ["|"] = "write or", ["!"] = "write not",
    ["%"] = "numbers stand without a unit", ["^"] = "write x * x", ["≤"] = "write <=", ["≥"] = "write >=",
    ["≠"] = "write ~=", ["×"] = "write *", ["·"] = "write *", ["÷"] = "write /", ["−"] = "write -" }

local function shown(text)
    return #text <= 200 and text or text:sub(1, 60):gsub("[\128-\255]+$", "") .. " ..."
end

local function refuse_character(text, at, where)
    local odd = text:match("^[\194-\244][\128-\191]+", at) or text:sub(at, at)
    local turned = text:match("^=([<>])", at)
    local advice = turned and "write " .. turned .. "=" or meant[odd]
    words.fail(where, ("'%s' does not belong in the condition \"%s\"%s"):format(odd, shown(text),
        advice and ": " .. advice or ""))
end

local function tokens_of(text, where)
    local tokens, at = {}, 1
    local function take(kind, pattern)
        local value = text:match("^" .. pattern, at)
        if not value then return false end
        tokens[#tokens + 1] = { kind = kind, text = value, from = at, to = at + #value - 1 }
        at = at + #value
        return true
    end
    while at <= #text do
        local space = text:match("^%s+", at)
        if space then
            at = at + #space
        elseif not (take("number", "%d+%.?%d*[eE][+-]?%d+") or take("number", "%d*%.?%d+")
                or take("name", "[%a_][%w_]*%.[%a_][%w_]*") or take("name", "[%a_][%w_]*")
                or take("sign", "[<>=~!]=") or take("sign", "[<>+*/(),-]")) then
            refuse_character(text, at, where)
        end
    end
    return tokens
end

local Parser = {}
Parser.__index = Parser

function Parser:peek() return self.tokens[self.at] and self.tokens[self.at].text end

function Parser:accept(text)
    if self:peek() ~= text then return false end
    self.at = self.at + 1
    return true
end

-- What is most often behind a mistake of form here, for who does not program.
function Parser:slip()
    local before, token, after = self.tokens[self.at - 1], self.tokens[self.at], self.tokens[self.at + 1]
    for _, one in ipairs({ before or false, token or false }) do
        local small = one and one.text:lower()
        if small and small ~= one.text and (small == "and" or small == "or" or small == "not") then
            return (": write %s in small letters"):format(small)
        end
    end
    if not before or not token or before.kind ~= "number" then return "" end
    if token.text == "," and after and after.kind == "number" then
        return (": write a decimal point, %s.%s"):format(before.text, after.text)
    end
    if token.kind == "name" and token.text ~= "not" then return ": numbers stand without a unit" end
    return ""
end

function Parser:fail(message)
    local near = self:peek() and (" near '" .. self:peek() .. "'") or " at its end"
    words.fail(self.where, ("%s%s of the condition \"%s\"%s"):format(message, near, shown(self.text), self:slip()))
end

-- Reads what stands within a bracket or behind `not` or `-`.
function Parser:within(read)
    self.depth = self.depth + 1
    if self.depth > deepest then
        words.fail(self.where, ("the condition \"%s\" is nested more than %d deep"):format(shown(self.text), deepest))
    end
    local node = read(self)
    self.depth = self.depth - 1
    return node
end

function Parser:expect(text)
    if not self:accept(text) then self:fail("'" .. text .. "' is missing") end
end

local functions = { min = 2, max = 2, abs = 1, sqrt = 1 }  -- of how many numbers, min and max also of more

function Parser:arguments(name)
    local list = { self:within(Parser.sum) }
    while self:accept(",") do list[#list + 1] = self:within(Parser.sum) end
    self:expect(")")
    if #list < functions[name] or #list > functions[name] and functions[name] == 1 then
        words.fail(self.where, ("%s takes %s: the condition \"%s\""):format(name, functions[name] == 1
            and "one number, as in abs(a.x_mm)" or "two numbers or more, as in min(a.x_mm, 2)", shown(self.text)))
    end
    return { op = name, table.unpack(list) }
end

function Parser:constant(text)
    local value = tonumber(text)
    if value == math.huge then
        words.fail(self.where, ("%s is too large a number: the condition \"%s\""):format(text, shown(self.text)))
    end
    return { op = "constant", value = value }
end

function Parser:primary()
    local token = self.tokens[self.at]
    if not token then self:fail("a number or a measure is missing") end
    if self:accept("(") then
        local inner = self:within(Parser.any)
        self:expect(")")
        return inner
    end
    if token.kind == "sign" or token.text == "and" or token.text == "or" then
        self:fail("a number or a measure is missing")
    end
    self.at = self.at + 1
    if token.kind == "number" then return self:constant(token.text) end
    if token.text == "true" or token.text == "false" then return { op = "constant", value = token.text == "true" } end
    if functions[token.text] and self:accept("(") then return self:arguments(token.text) end
    self.names[#self.names + 1] = token.text
    return { op = "name", name = token.text }
end

function Parser:unary()
    if self:accept("-") then return { op = "-", { op = "constant", value = 0 }, self:within(Parser.unary) } end
    return self:primary()
end

function Parser:product()
    local left = self:unary()
    while self:peek() == "*" or self:peek() == "/" do
        local op = self:peek()
        self.at = self.at + 1
        left = { op = op, left, self:unary() }
    end
    return left
end

function Parser:sum()
    local left = self:product()
    while self:peek() == "+" or self:peek() == "-" do
        local op = self:peek()
        self.at = self.at + 1
        left = { op = op, left, self:product() }
    end
    return left
end

-- A sum that knows its own text, for messages.
function Parser:quoted_sum()
    local first = self.tokens[self.at]
    local node = self:sum()
    node.text = node.text or self.text:sub(first.from, self.tokens[self.at - 1].to)
    return node
end

function Parser:comparison()
    local left = self:quoted_sum()
    local op = self:peek()
    if op and comparisons[op] then
        self.at = self.at + 1
        if op == "!=" then op = "~=" end
        return { op = op, left, self:quoted_sum() }
    end
    return left
end

function Parser:negation()
    if self:accept("not") then return { op = "not", self:within(Parser.negation) } end
    return self:comparison()
end

function Parser:all()
    local left = self:negation()
    while self:accept("and") do left = { op = "and", left, self:negation() } end
    return left
end

function Parser:any()
    local left = self:all()
    while self:accept("or") do left = { op = "or", left, self:all() } end
    return left
end

--- Reads a text. where: "file:line" for messages. Returns { text, where, names, tree }.
function expression.parse(text, where)
    if #text > longest then
        words.fail(where, ("the condition \"%s\" is longer than %d characters: write a function of the eye"):format(
            shown(text), longest))
    end
    local parser = setmetatable({ tokens = tokens_of(text, where), at = 1, text = text, where = where, names = {},
        depth = 0 }, Parser)
    local tree = parser:any()
    if parser:peek() then parser:fail("'and' or 'or' is missing") end
    return { text = text, where = where, names = parser.names, tree = tree }
end

local make = {}

make["and"] = function(a, b) return function() return (a() and b()) and true or false end end
make["or"] = function(a, b) return function() return (a() or b()) and true or false end end
make["not"] = function(a) return function() return not a() end end

-- A comparison with something undefined is false.
local function compared(f)
    return function(a, b)
        return function()
            local x, y = a(), b()
            if x == nil or y == nil then return false end
            return f(x, y)
        end
    end
end

local function ordered(f)
    return compared(function(x, y)
        if type(x) == "boolean" or type(y) == "boolean" then
            error("what is true or false has no size: write it alone, or after `not`", 0)
        end
        return f(x, y)
    end)
end
make["<"] = ordered(function(x, y) return x < y end)
make["<="] = ordered(function(x, y) return x <= y end)
make[">"] = ordered(function(x, y) return x > y end)
make[">="] = ordered(function(x, y) return x >= y end)
make["=="] = compared(function(x, y) return x == y end)
make["~="] = compared(function(x, y) return x ~= y end)

-- Arithmetic with something undefined, and division by zero, is undefined.
local function computed(f)
    return function(a, b)
        return function()
            local x, y = a(), b()
            if x == nil or y == nil then return nil end
            local value = f(x, y)
            if value ~= value or value == math.huge or value == -math.huge then return nil end
            return value
        end
    end
end
make["+"] = computed(function(x, y) return x + y end)
make["-"] = computed(function(x, y) return x - y end)
make["*"] = computed(function(x, y) return x * y end)
make["/"] = computed(function(x, y) return x / y end)
make.min = computed(math.min)
make.max = computed(math.max)

function make.abs(a)
    return function()
        local x = a()
        return x and math.abs(x)
    end
end

-- Of less than nothing it is undefined.
function make.sqrt(a)
    return function()
        local x = a()
        if x == nil or x ~= x or x < 0 then return nil end
        return math.sqrt(x)
    end
end

local function build(node, resolve)
    if node.op == "constant" then
        local value = node.value
        return function() return value end
    end
    if node.op == "name" then return resolve(node.name) end
    local built = build(node[1], resolve)
    if #node == 1 then return make[node.op](built) end
    for i = 2, #node do built = make[node.op](built, build(node[i], resolve)) end
    return built
end

local function unknown(name, known)
    return ("unknown measure '%s'%s"):format(name, measures.missing(name, known) or words.hint(name, known))
end

--- Makes a function of a parsed text. resolve(name) returns a function that gives the value now, or nil and the list of
--- known names.
function expression.bind(parsed, resolve)
    return build(parsed.tree, function(name)
        local value, known = resolve(name)
        if not value then
            words.fail(parsed.where, unknown(name, known))
        end
        return value
    end)
end

--- What bind would say of a name that is not known, without raising it; nil when all are known.
function expression.complaint(parsed, resolve)
    for _, name in ipairs(parsed.names) do
        local value, known = resolve(name)
        if not value then
            return unknown(name, known)
        end
    end
    return nil
end

--- Whether all names of a parsed text are known.
function expression.known(parsed, resolve)
    for _, name in ipairs(parsed.names) do
        if not resolve(name) then return false end
    end
    return true
end

return expression
