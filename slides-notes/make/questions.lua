-- The questions and exercises of questions.md by their numbers, "03.1" and "7", with their keys. A chapter names
-- a number where it belongs; the instructor's edition shows the key with it.

local questions = {}

-- The items of the lists in text, each on one line, by what pattern takes as their numbers.
local function items(text, pattern)
    local found, n = {}, nil
    for line in text:gmatch("[^\n]*") do
        local number, rest = line:match(pattern)
        if number then
            n = number
            found[n] = rest
        elseif n and line:match("^  ") then
            found[n] = found[n] .. " " .. line:match("^%s*(.*)$")
        elseif line ~= "" then
            n = nil
        end
    end
    return found
end

-- What stands in text behind the words first, up to the words last or to the end.
local function between(text, first, last)
    local _, before = text:find(first, 1, true)
    assert(before, "questions.md: found no \"" .. first .. "\"")
    local behind = last and text:find(last, before, true)
    return text:sub(before + 1, (behind or #text + 1) - 1)
end

-- "Where? (a) here (b) there" as the question and its options, in order.
function questions.question(item)
    local text, rest = item:match("^(.-)%s*(%(a%) .*)$")
    local options = {}
    for option in (rest:gsub("%(([a-d])%) ", "\0%1")):gmatch("[^%z]+") do
        options[#options + 1] = {letter = option:sub(1, 1), text = option:sub(2):match("^(.-)%s*$")}
    end
    return {item = item, text = text, options = options}
end

-- Read questions.md, given as text. Returns hall["03.1"] = {item, text, options[] = {letter, text}, letter, why} and
-- exercises[7] = {text, key}.
function questions.read(text)
    local hall, exercises = {}, {}
    local asked = between(text, "## Questions for the hall", "\n## Exercises")
    for number, item in pairs(items(asked, "^%- %*%*(%d%d%.%d)%*%* (.*)$")) do
        hall[number] = questions.question(item)
    end
    local key = between(text, "## Answers")
    for lab, letters in key:gmatch("\n| (%d%d) (|[^\n]*)") do
        local number = 0
        for letter in letters:gmatch("| ([a-d]) %f[|]") do
            number = number + 1
            hall[lab .. "." .. number].letter = letter
        end
    end
    local reasons = between(key, "|\n\n- ", "**Exercises.**"):gsub("\n%- ", " "):gsub("\n%s*", " ")
    for reason in (reasons:gsub("%*%*(%d%d%.%d)%*%* ", "\0%1")):gmatch("[^%z]+") do
        local number, why = reason:match("^(%d%d%.%d)(.-)%s*$")
        if number then hall[number].why = why end
    end
    local exercise = "^(%d+)%. (.*)$"
    local keys = items(between(key, "**Exercises.**", "\n---"), exercise)
    for number, item in pairs(items(between(text, "\n## Exercises", "\n---"), exercise)) do
        exercises[tonumber(number)] = {text = item, key = keys[number]}
    end
    return hall, exercises
end

return questions
