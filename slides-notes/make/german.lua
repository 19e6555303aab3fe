-- Slides in German: german.po has the German of each paragraph, by its English. A paragraph that is
-- changed in English is no longer found there, so it stays English and is never out of date. An
-- entry marked as fuzzy, which is a translator's draft, counts as none.
--
-- A paragraph is one of Markdown on a slide: also a title, an item, a cell of a table, a block of
-- pseudocode, a question with its options, a label of a drawing. Numbers that runs count are not in
-- german.po, but are taken from the English.

local german = {}

local entries            -- entries[English] = German; nil while slides are made in English
local asked = {}         -- what was looked up, in this order: {text, where}
local known = {}         -- the same, known[text] = true
local missing = {}       -- what was not found

-- ---- german.po ----------------------------------------------------------------------------------

local escapes = {n = "\n", ['"'] = '"', ["\\"] = "\\"}
local function unquoted(line)
    return (line:match('"(.*)"'):gsub("\\(.)", escapes))
end

local function quoted(text)
    return '"' .. text:gsub('[\\"]', "\\%0"):gsub("\n", "\\n") .. '"'
end

-- Use the entries of german.po, given as text: from now on slides are made in German.
function german.read(text)
    entries = {}
    local entry, field = {}, nil
    for line in (text .. "\n\n"):gmatch("([^\n]*)\n") do
        if line:match("^#, .*fuzzy") then
            entry.fuzzy = true
        elseif line:match('^[m"]') then
            field = line:match("^msg%a+") or field
            entry[field] = (entry[field] or "") .. unquoted(line)
        elseif line == "" then
            if entry.msgid and entry.msgstr ~= "" and not entry.fuzzy then
                entries[entry.msgid] = entry.msgstr
            end
            entry = {}
        end
    end
end

-- ---- Looking up ---------------------------------------------------------------------------------

-- Text without words is the same in both languages: numbers, code, names as t_split and minX,
-- single letters.
local function has_words(text)
    for _, other in ipairs{"<!%-%-.-%-%->", "`[^`]*`", "%w+_%w+", "%l+%u%w*"} do
        text = text:gsub(other, "")
    end
    return text:match("%l%l")
end

local function look_up(text, where)
    if not known[text] then
        known[text] = true
        asked[#asked + 1] = {text = text, where = where}
        if not entries[text] then missing[#missing + 1] = text end
    end
    return entries[text]
end

-- A number before its mark, "10.4<!-- 07-sphereflake: sphere_tests.mean_per_pixel -->".
local marked = "([%d.\u{a0}]+)(<!%-%- [^>]-: [^>]- %-%->)"

-- One paragraph in German; in English if there is no German for it, and while slides are made in
-- English. where helps a translator: the slide's title, say.
function german.say(text, where)
    if not entries or not has_words(text) then return text end
    local numbers = {}
    local key = text:gsub(marked, function(number, mark)
        numbers[mark] = number
        return mark
    end)
    local found = look_up(key, where)
    if not found then return text end
    return (found:gsub("<!%-%- .- %-%->", function(mark) return (numbers[mark] or "") .. mark end))
end

-- A drawing, SVG as text, with its labels in German. Their numbers are "#" in german.po, in the
-- same order.
local characters = {["&lt;"] = "<", ["&gt;"] = ">", ["&amp;"] = "&"}
local entities = {["<"] = "&lt;", [">"] = "&gt;", ["&"] = "&amp;"}
function german.drawing(svg, where)
    return (svg:gsub("(<text[^>]*>)([^<]*)", function(tag, label)
        label = label:gsub("&%l+;", characters)
        if not has_words(label) then return nil end
        local numbers = label:gmatch("%d[%d.]*")
        local found = look_up(label:gsub("%d[%d.]*", "#"), where)
        if not found then return nil end
        return tag .. found:gsub("[<>&]", entities):gsub("#", function() return numbers() end)
    end))
end

-- ---- A chapter ----------------------------------------------------------------------------------

-- A line of a slide, as what it begins with and its text; "" for a text that stays.
local function parts(line)
    if line:match("^%[[^%]]*%]%([^)]*%)$") or line:match("^|[-| ]*|$") then return line, "" end
    local first, text = line:match("^(%s*[->] )(.*)$")
    if not first then first, text = line:match("^(%d+%. )(.*)$") end
    return first or "", text or line
end

local function row(line, where)
    return (line:gsub("| ([^|]-) %f[|]", function(cell)
        return "| " .. german.say(cell, where) .. " "
    end))
end

local function picture(line, where)
    local words, target = line:match("^!%[(.-)%](%(.*%))$")
    return words and "![" .. german.say(words, where) .. "]" .. target
end

-- The lines of a slide's Markdown in German. where is its title.
local function slide(lines, where)
    local out, open, n = {}, nil, 1
    -- A paragraph that goes on for some lines becomes one line.
    local function close()
        if open then out[#out + 1] = open.first .. german.say(open.text, where) end
        open = nil
    end
    -- The lines from n on, up to the one before which stops() is true, as one text.
    local function block(margin, stops)
        local from = n
        while n <= #lines and not stops(lines[n]) do n = n + 1 end
        local text = table.concat(lines, "\n", from, n - 1):sub(#margin + 1)
        text = text:gsub("\n" .. margin, "\n")
        out[#out + 1] = margin .. german.say(text, where):gsub("\n", "\n" .. margin)
    end
    while n <= #lines do
        local line = lines[n]
        local first, text = parts(line)
        if line:match("^```") then
            close()
            out[#out + 1] = line
            n = n + 1
            block("", function(other) return other == "```" end)
            out[#out + 1] = lines[n]
        elseif line:match("^    ") and not open then
            block(line:match("^ *"), function(other) return not other:match("^    ") end)
            n = n - 1
        elseif line:match("^|") or line:match("^!") then
            close()
            out[#out + 1] = picture(line, where) or row(line, where)
        elseif text == "" or text == ">" then
            close()
            out[#out + 1] = line
        elseif open and (first == "" or first == "> ") then
            open.text = open.text .. " " .. text:match("^%s*(.*)$")
        else
            close()
            open = {first = first, text = text}
        end
        n = n + 1
    end
    close()
    return out
end

-- A chapter's Markdown with its slides in German; what is not on a slide stays.
function german.chapter(text)
    if not entries then return text end
    local out, lines, title = {}, nil, nil
    for line in (text .. "\n"):gmatch("([^\n]*)\n") do
        local before, head, behind =
            line:match("^(<details><summary>Slide, %d+ min: )(.-)(</summary>)$")
        if line:match("^# ") then
            out[#out + 1] = "# " .. german.say(line:sub(3), "title")
        elseif head then
            out[#out + 1] = before .. german.say(head, "title") .. behind
            lines, title = {}, head
        elseif lines and line == "</details>" then
            for _, one in ipairs(slide(lines, title)) do out[#out + 1] = one end
            out[#out + 1], lines = line, nil
        elseif lines then
            lines[#lines + 1] = line
        else
            out[#out + 1] = line
        end
    end
    return table.concat(out, "\n") .. "\n"
end

-- ---- What a page looked up ----------------------------------------------------------------------

-- Say on stderr what of source is not in German yet; append all that was looked up to the file at
-- template, if not nil, as `make german` needs it.
function german.report(source, template)
    if not entries then return end
    for _, text in ipairs(missing) do
        io.stderr:write(source, ": not in German yet: ", (text:gsub("\n", " ")), "\n")
    end
    if not template then return end
    local file = assert(io.open(template, "a"))
    for _, one in ipairs(asked) do
        file:write("#. ", one.where, "\n#: ", source, "\n")
        file:write("msgid ", quoted(one.text), "\nmsgstr \"\"\n\n")
    end
    file:close()
end

return german
