-- A pandoc filter: from a Markdown file of the course to a page of the site. See README.md in this folder for
-- what stands in the files, and build.sh for what calls this. Metadata that it reads:
--   source    the file, from the course's top folder
--   form      "notes", "slides" or "page"
--   language  "en", or "de" for slides
--   edition   "student" or "instructor"
--   pages     all Markdown files of the site, one a blank
--   up        the way from the page to the site's top folder: "../../"
--   runs      the folder with the JSON files of the programs' runs

package.path = PANDOC_SCRIPT_FILE:gsub("[^/]*$", "") .. "?.lua;" .. package.path
local formula = require "formula"
local questions = require "questions"
local german = require "german"
local listing = require "listing"

local List = pandoc.List
local say = german.say
local source, folder, form, language, edition, up, runs
local pages = {}
local hall, exercises

-- ---- Small things --------------------------------------------------------------------------------

local function read(path)
    local file = assert(io.open(path, "r"), source .. " needs " .. path .. ", which cannot be read")
    local text = file:read("a")
    file:close()
    return text
end

local function html(text) return pandoc.RawBlock("html", text) end

-- Markdown as blocks, and as inlines.
local function blocks(text) return pandoc.read(text, "gfm").blocks end
local function inlines(text)
    local first = blocks(text)[1]
    return first and first.content or List()
end

local function div(class, content) return pandoc.Div(content, pandoc.Attr("", {class})) end

-- "../labs/x/README.md", written in the source's folder, from the course's top folder.
local function resolve(path)
    local parts = {}
    for part in (folder .. path):gmatch("[^/]+") do
        if part == ".." then table.remove(parts) elseif part ~= "." then parts[#parts + 1] = part end
    end
    return table.concat(parts, "/")
end

-- ---- Links, pictures, numbers ---------------------------------------------------------------------

-- A link to a Markdown file leads to its page; the word "slides" in it, to a chapter's slides, which on a forge
-- stand in its notes; the word "Folien", to those in German. What is not on the site loses its link and keeps its words.
local function link(element)
    local target, anchor = element.target:match("^([^#]*)(#?.*)$")
    if element.target:match("^%a+:") or target == "" then return nil end
    if target:match("/$") then target = target .. "README.md" end
    local wanted = resolve(target)
    if not pages[wanted] then return element.content end
    local words = pandoc.utils.stringify(element.content):lower()
    local suffix = words:match("^folien") and ".de.html" or ".html"
    if words:match("^slides") or words:match("^folien") then wanted = wanted:gsub("/notes%-", "/slides-") end
    element.target = up .. wanted:gsub("%.md$", suffix) .. anchor
    return element
end

-- A paragraph that is a picture becomes a figure. By its name slides-notes/touch finds those that can be touched.
-- In German slides its labels are German.
local function figure(image)
    if language == "de" and image.src:match("%.svg$") then
        local drawing = "de/" .. image.src
        pandoc.mediabag.insert(drawing, "image/svg+xml", german.drawing(read(folder .. image.src), image.src))
        image.src = drawing
    end
    local caption = pandoc.utils.stringify(image.caption)
    local name = image.src:match("([^/]*)%.%w+$")
    local shown = List{pandoc.RawInline("html", '<figure data-name="' .. name .. '">'), pandoc.Image(image.caption, image.src)}
    shown:insert(pandoc.RawInline("html", "<figcaption>"))
    shown:extend(image.caption)
    shown:insert(pandoc.RawInline("html", "</figcaption></figure>"))
    assert(caption ~= "", source .. ": " .. image.src .. " has no text in its place")
    return pandoc.Plain(shown)
end

-- "10.4" before <!-- 07-sphereflake: sphere_tests.mean_per_pixel --> becomes what the run counted, with as many
-- decimals, in groups of three where the text has no-break spaces; a difference is reported on stderr.
local no_break = "\u{a0}"
local function counted(text, run, field)
    local json = read(runs .. "/" .. run .. ".json")
    local value = json:match('"' .. field:gsub("%.", "%%.") .. '": ([%d.eE+-]+)')
    assert(value, source .. ": the run " .. run .. " has no " .. field)
    local decimals = text:match("%.(%d+)$") or ""
    local now = string.format("%." .. #decimals .. "f", tonumber(value))
    if text:find(no_break, 1, true) then
        now = now:reverse():gsub("%d%d%d", "%0 "):reverse():gsub("^ ", ""):gsub(" ", no_break)
    end
    if now ~= text then
        io.stderr:write(source, ": ", field, " of ", run, " is ", now, ", the text says ", text, "\n")
    end
    return now
end

local function numbers(content)
    for n = 2, #content do
        local run, field = (content[n].tag == "RawInline" and content[n].text or ""):match("^<!%-%- (%d%d%-[%w-]+): ([%w_.]+) %-%->$")
        if run and content[n - 1].tag == "Str" then
            -- Marks before the number, as of emphasis or a bracket, stay.
            local before, number = content[n - 1].text:match("^(.-)([%d.\u{a0}]+)$")
            content[n - 1].text = before .. counted(number, run, field)
        end
    end
    return content
end

-- A block of code behind <!-- 06-lattice: printed -->: each of its lines must be one that the run printed, in this order; a
-- difference is reported on stderr.
local function printed(content)
    for n = 2, #content do
        local run = (content[n - 1].tag == "RawBlock" and content[n - 1].text or ""):match("^<!%-%- ([%w-]+): printed %-%->%s*$")
        if run and content[n].tag == "CodeBlock" then
            local said, at = "\n" .. read(runs .. "/" .. run .. ".txt"), 1
            for line in content[n].text:gmatch("[^\n]+") do
                local _, last = said:find("\n" .. line .. "\n", at, true)
                if not last then
                    io.stderr:write(source, ": the output of ", run, " is without a line, the text says ", line, "\n")
                    break
                end
                at = last
            end
        end
    end
end

-- What stays on one line: points and intervals as "(2.5, 7)" and "[0, 10]", of short pieces from an opening bracket to a
-- closing one; the groups of "16 777 216"; an option's "(a)" and its first word.
local function unbroken(content)
    local from
    for n = 1, #content do
        local text = content[n].tag == "Str" and #content[n].text <= 12 and content[n].text
        local before = n > 2 and content[n - 1].tag ~= "Str" and content[n - 2].tag == "Str" and content[n - 2].text or ""
        if text and (before:match("^%([a-d]%)$") or before:match("%f[%d]%d%d?%d?$") and text:match("^%d%d%d%f[%D]")) then
            content[n - 1] = pandoc.Str(no_break)
        end
        if text and text:match("^[%[(][^%s()%[%]]+,$") then
            from = n
        elseif from and text and text:match("^[^%s()%[%]]+[%])]") then
            for m = from, n do
                if content[m].tag == "Space" or content[m].tag == "SoftBreak" then content[m] = pandoc.Str(no_break) end
            end
            from = nil
        elseif content[n].tag ~= "Space" and content[n].tag ~= "SoftBreak" and not (text and text:match("^[^%s()%[%]]+,$")) then
            from = nil
        end
    end
    return content
end

-- An option as "--size" is not broken behind its first hyphen, nor is one in a longer command.
local function code_words(element)
    if #element.text <= 24 then
        element.classes:insert("short")
        return element
    end
    local text = element.text:gsub("[&<>]", {["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;"})
    local words = (" " .. text):gsub("([ \"])(%-%-?%w[%w-]*)", '%1<span class="short">%2</span>'):sub(2)
    return pandoc.RawInline("html", "<code>" .. words .. "</code>")
end

-- ---- What a paragraph may stand for ----------------------------------------------------------------

-- A question for the hall: its words and options.
local function asked(number)
    local item = assert(hall[number], source .. ": questions.md has no question " .. number).item
    local question = questions.question(say(item, "question " .. number))
    local rows = {}
    for _, option in ipairs(question.options) do
        local row = List{pandoc.RawInline("html", "<b>(" .. option.letter .. ")</b> ")}
        row:extend(inlines(option.text))
        rows[#rows + 1] = {pandoc.Plain(row)}
    end
    return List{pandoc.Para(inlines(question.text)), div("options", {pandoc.BulletList(rows)})}
end

-- Its key, in words.
local function answer(number)
    local question = hall[number]
    return blocks(say("Answer:", "speaker notes") .. " **(" .. question.letter .. ")**. " ..
        say(question.why or "", "question " .. number .. ", answer"))
end

-- [Question 03.1](questions.md#...), alone in its paragraph.
local function hall_question(number)
    local box = blocks("**Question " .. number .. "**")
    box:extend(asked(number))
    if edition == "instructor" then box:insert(div("answer", answer(number))) end
    return div("hall", box)
end

-- [Exercise 3](questions.md#exercises).
local function exercise(number)
    local one = assert(exercises[number], source .. ": questions.md has no exercise " .. number)
    local box = blocks("**Exercise " .. number .. "** " .. one.text)
    if edition == "instructor" then box:insert(div("answer", blocks(one.key))) end
    return div("exercise", box)
end

-- [Listing: trace](../labs/07-kdtree-3d-trace/trace.cl).
local function cut(name, target)
    local path = resolve(target)
    if edition == "instructor" then path = path:gsub("^labs/", "solutions/") end
    return List{pandoc.Para{pandoc.Code(path:match("[^/]*$")), pandoc.Str(":")},
                pandoc.CodeBlock(listing.cut(path, name), pandoc.Attr("", {"c"}))}
end

-- The kind and the argument of a paragraph that is one such link, or nil.
local function placed(block)
    if block.tag ~= "Para" or #block.content ~= 1 or block.content[1].tag ~= "Link" then return nil end
    local words = pandoc.utils.stringify(block.content[1])
    local kind, argument = words:match("^(%a+):? ([%w_.]+)$")
    return kind, argument, block.content[1].target
end

local function paragraph(block)
    if #block.content == 1 and block.content[1].tag == "Image" then return figure(block.content[1]) end
    local kind, argument, target = placed(block)
    if kind == "Question" and form ~= "page" then return hall_question(argument) end
    if kind == "Exercise" then return exercise(tonumber(argument)) end
    if kind == "Listing" then return cut(argument, target) end
end

local function code(block)
    if form ~= "page" and #block.classes == 0 and formula.is(block.text) then
        return html('<div class="formula">' .. formula.mathml(block.text) .. "</div>")
    end
end

-- ---- Slides ---------------------------------------------------------------------------------------

-- The minutes and the title of a block that begins a slide, or nil.
local function slide_head(block)
    if block.tag ~= "RawBlock" then return nil end
    return block.text:match("<summary>Slide, (%d+) min: (.-)</summary>")
end

-- The content of a slide in two columns, what is said and what is shown.
local function columns(content)
    local said, shown = List(), List()
    for _, block in ipairs(content) do
        local image = block.tag == "Para" and #block.content == 1 and block.content[1].tag == "Image"
        if image then shown:insert(block) else said:insert(block) end
    end
    local parts = List()
    if #said > 0 then parts:insert(div(#shown > 0 and "said beside" or "said", said)) end
    if #shown > 0 then parts:insert(div(#said == 0 and #shown > 1 and "shown beside" or "shown", shown)) end
    return div("columns", parts)
end

-- One slide. It has an id, where it is the first of its section; lab is a link or nil.
local function slide(id, class, title, content, lab, speaker, number)
    local foot = List{pandoc.RawInline("html", "<footer><span>")}
    if lab then foot:insert(lab) end
    foot:insert(pandoc.RawInline("html", "</span><span>" .. number .. "</span></footer>"))
    local stage = div("stage", {pandoc.Header(2, title), columns(content), pandoc.Plain(foot)})
    local parts = List{stage}
    if edition == "instructor" and #speaker > 0 then parts:insert(div("speaker", speaker)) end
    return pandoc.Div(parts, pandoc.Attr(id, {"slide", class}))
end

-- The blocks between <details> and </details>: content, the link to the lab, the speaker notes.
local function slide_parts(found, minutes)
    local content, lab, speaker = List(), nil, blocks("**" .. minutes .. " " .. say("min.", "speaker notes") .. "**")
    for _, block in ipairs(found) do
        local kind, argument = placed(block)
        if block.tag == "BlockQuote" then
            speaker:extend(block.content)
        elseif kind == "Lab" and argument then
            lab = block.content[1]
        else
            content:insert(block)
        end
    end
    return content, lab, speaker
end

-- A link to the lab of the question "03.1", as a slide of its own has one; nil where the site has no such lab.
local function lab_of(number)
    local lab = number:match("^%d+")
    for page in pairs(pages) do
        if page:match("^labs/" .. lab .. "%-[^/]*/README%.md$") then return pandoc.Link("Lab " .. lab, "../" .. page) end
    end
end

-- All slides of a chapter: a title, then one for each <details> and each question, in the text's order.
local question_minutes = 2
local function slides_of(document)
    local deck, at, section, opened = List(), nil, "", nil
    local function add(class, title, content, lab, speaker)
        deck:insert(slide(section, class, title, content, lab, speaker, #deck + 1))
        section = ""
    end
    for n, block in ipairs(document) do
        local minutes, title = slide_head(block)
        local kind, argument = placed(block)
        if minutes then
            opened, at = {minutes = minutes, title = title}, List()
        elseif opened and block.tag == "RawBlock" and block.text:match("^</details>") then
            local content, lab, speaker = slide_parts(at, opened.minutes)
            add("", inlines(opened.title), content, lab, speaker)
            opened, at = nil, nil
        elseif at then
            at:insert(block)
        elseif block.tag == "Header" and block.level == 1 then
            -- "Lecture notes, first half: two dimensions. They follow ..."
            local half = pandoc.utils.stringify(document[n + 1]):match(", ([^.]*)")
            add("first", block.content, List{pandoc.Para{pandoc.Str(say(half, "title"))}}, nil, List())
        elseif block.tag == "Header" and block.level == 2 then
            section = block.identifier
        elseif kind == "Question" then
            local speaker = blocks("**" .. question_minutes .. " " .. say("min.", "speaker notes") .. "** " ..
                say("Read it aloud, let them vote by hand, ask one of each side why.", "speaker notes"))
            speaker:extend(answer(argument))
            add("asks", inlines(say("Question", "title") .. " " .. argument), asked(argument), lab_of(argument), speaker)
        end
    end
    assert(not opened, source .. ": a <details> does not end")
    return deck
end

-- The text without what is for the slides.
local function without_slides(document)
    local kept, inside = List(), false
    for _, block in ipairs(document) do
        if slide_head(block) then inside = true end
        if not inside then kept:insert(block) end
        if inside and block.tag == "RawBlock" and block.text:match("^</details>") then inside = false end
    end
    return kept
end

-- questions.md for students ends before the answers.
local function without_answers(document)
    local kept = List()
    for _, block in ipairs(document) do
        if block.tag == "Header" and block.level == 2 and pandoc.utils.stringify(block) == "Answers" then
            if kept[#kept].tag == "HorizontalRule" then kept[#kept] = nil end
            break
        end
        kept:insert(block)
    end
    return kept
end

-- ---- The filter -----------------------------------------------------------------------------------

local function meta(document, name) return pandoc.utils.stringify(document.meta[name] or "") end

function Pandoc(document)
    source, form, edition = meta(document, "source"), meta(document, "form"), meta(document, "edition")
    folder, up, runs = source:match("^(.*/)") or "", meta(document, "up"), meta(document, "runs")
    language = meta(document, "language")
    for page in meta(document, "pages"):gmatch("%S+") do pages[page] = true end
    hall, exercises = questions.read(read("slides-notes/questions.md"))

    local content = document.blocks
    if language == "de" then
        german.read(read("slides-notes/german.po"))
        content = blocks(german.chapter(read(source)))
        local before, title = meta(document, "pagetitle"):match("^slides(.-: )(.*)$")
        document.meta.pagetitle = "Folien" .. before .. say(title, "title")
    end
    if form == "slides" then content = slides_of(content) else content = without_slides(content) end
    if source:match("questions%.md$") and edition == "student" then content = without_answers(content) end
    document.blocks = pandoc.walk_block(pandoc.Div(content), {Inlines = numbers, Blocks = printed}).content
    document.blocks = pandoc.walk_block(pandoc.Div(document.blocks), {Para = paragraph, CodeBlock = code}).content
    document.blocks = pandoc.walk_block(pandoc.Div(document.blocks), {
        Link = link,
        Code = code_words,
        Inlines = unbroken,
        Table = function(block) return div("scrolls", {block}) end,
    }).content
    german.report(source, os.getenv("GERMAN_TEMPLATE"))
    return document
end
