-- Formulas: from plain text, as it stands in the notes and on a forge, to MathML.
--
-- One source for both: "t_split = (s − e) / d" is read as it is typed. A name of one letter is italic, a longer
-- one upright; "_" lowers what follows, superscripts raise; "√disc" is a root; three blanks or more part formulas that
-- share a line; each line is a row, and equations one below the other stand aligned.

local formula = {}

local raised = {["⁰"] = "0", ["¹"] = "1", ["²"] = "2", ["³"] = "3", ["⁴"] = "4", ["⁵"] = "5", ["⁶"] = "6",
                ["⁷"] = "7", ["⁸"] = "8", ["⁹"] = "9", ["⁻"] = "−"}

local function escaped(text)
    return (text:gsub("[&<>]", {["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;"}))
end

-- A name, with what is behind "_" below it.
local function name(text)
    local base, below = text:match("^(.-)_(.+)$")
    if base then
        return "<msub>" .. name(base) .. "<mi mathvariant=\"normal\">" .. below .. "</mi></msub>"
    end
    -- A letter is italic by itself.
    return utf8.len(text) == 1 and "<mi>" .. text .. "</mi>" or "<mi mathvariant=\"normal\">" .. text .. "</mi>"
end

-- The next piece of text from position at on: its MathML, and where it ends.
local function piece(text, at)
    local found = text:match("^%a[%w_]*'*", at)
    if found then
        local plain, primes = found:match("^([^']*)('*)$")
        local set = name(plain)
        -- The letter stands high already, so it is none of the powers.
        if primes ~= "" then set = set .. "<mo lspace=\"0\" rspace=\"0\">′</mo>" end
        return set, at + #found
    end
    -- Thin blanks part the digits of large numbers: "8 589 934 592".
    found = text:match("^%d+%.?%d*", at)
    if found then
        local finish = at + #found
        while not found:find("%.") do
            local more = text:match("^ (%d%d%d)%f[%D]", finish)
            if not more then break end
            found, finish = found .. " " .. more, finish + 4
        end
        return "<mn>" .. found .. "</mn>", finish
    end
    local char = text:match("^" .. utf8.charpattern, at)
    if char == "√" then
        local root, finish = piece(text, at + #char)
        return "<msqrt>" .. root .. "</msqrt>", finish
    end
    if text:sub(at, at + 1) == "+=" then return "<mo>+=</mo>", at + 2 end
    if char == "½" then return "<mfrac><mn>1</mn><mn>2</mn></mfrac>", at + #char end
    if char == "Σ" then return "<mo>∑</mo>", at + #char end
    if char == "|" then return "<mo stretchy=\"false\" lspace=\"0\" rspace=\"0\">|</mo>", at + 1 end
    -- Brackets and bars are as large as the text: they hold no fraction.
    return "<mo stretchy=\"false\">" .. escaped(char) .. "</mo>", at + #char
end

-- A formula without wide gaps.
local function row(text)
    local set, at = {}, 1
    while at <= #text do
        local blanks = text:match("^ +", at)
        if blanks then
            -- Words and names with an index stay apart; "b d" is a product.
            local left = text:sub(1, at - 1):match("%a[%w_]*$")
            local right = text:match("^%a[%w_]*", at + #blanks)
            if left and right and #left + #right > 2 then set[#set + 1] = "<mspace width=\"0.25em\"/>" end
            at = at + #blanks
        else
            set[#set + 1], at = piece(text, at)
            local power = ""
            while at <= #text do
                local char = text:match("^" .. utf8.charpattern, at)
                if not raised[char] then break end
                power, at = power .. raised[char], at + #char
            end
            if power ~= "" then set[#set] = "<msup>" .. set[#set] .. "<mn>" .. power .. "</mn></msup>" end
        end
    end
    return table.concat(set)
end

-- Is this block of plain text a formula, and no drawing?
function formula.is(text)
    for _, code in utf8.codes(text) do
        -- Lines of boxes, blocks and dots of drawings.
        if code >= 0x2500 and code < 0x2600 then return false end
    end
    for _, relation in ipairs{"=", "≈", "≤", "~", ">"} do
        if text:find(relation, 1, true) then return true end
    end
    return false
end

-- A line as its cells: where lines are equations one below the other, what is left of "=" and the rest.
local function cells(line, aligned)
    if aligned then
        local left, right = line:match("^(.-)%s+(=.*)$")
        return {row(left), row(right)}
    end
    local parts = {}
    -- "a = 1,     b = 2": two formulas and a gap.
    for part in (line:gsub("   +", "\0")):gmatch("[^%z]+") do
        parts[#parts + 1] = row(part)
    end
    return {table.concat(parts, "<mspace width=\"2em\"/>")}
end

-- The lines of text as one <math>.
function formula.mathml(text)
    local lines, aligned = {}, true
    for line in text:gmatch("[^\n]+") do
        lines[#lines + 1] = line
        aligned = aligned and line:match("^%S+%s+=") ~= nil and not line:match("=.*=")
    end
    local rows = {}
    for _, line in ipairs(lines) do
        local set = {}
        for n, cell in ipairs(cells(line, aligned and #lines > 1)) do
            set[n] = "<mtd style=\"text-align: left\">" .. cell .. "</mtd>"
        end
        rows[#rows + 1] = "<mtr>" .. table.concat(set) .. "</mtr>"
    end
    return "<math display=\"block\"><mtable>" .. table.concat(rows) .. "</mtable></math>"
end

return formula
