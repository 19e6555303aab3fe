-- Listings: a piece of a source, cut by its name when the page is made, so that it cannot be out of date.
--
-- The name is a task's (// TASK name ... // END name) or a function's. A listing names a file in labs/, where tasks
-- hold placeholders; the instructor's edition cuts the same from solutions/.

local listing = {}

local function lines_of(path)
    local lines = {}
    local file = assert(io.open(path, "r"), "a listing names " .. path .. ", which cannot be read")
    for line in file:lines() do
        -- What is a placeholder in the skeleton is the author's comment in the solution.
        if not line:match("^%s*//>") then lines[#lines + 1] = line end
    end
    file:close()
    return lines
end

-- The first and last line of the task called name, without its markers; nil where there is none.
local function task(lines, name)
    local first
    for n, line in ipairs(lines) do
        if line:match("^%s*// TASK " .. name .. ":") then first = n + 1 end
        if first and line:match("^%s*// END " .. name .. "$") then return first, n - 1 end
    end
end

-- The first and last line of the function called name; nil where it is not defined here.
local function func(lines, name)
    local first
    for n, line in ipairs(lines) do
        if not first and line:match("^%a") and line:match("%f[%w_]" .. name .. "%(") then first = n end
        if first and line == "}" then return first, n end
    end
end

-- The lines called name in the file at path, moved to the left margin. Ends with an error where there are none.
function listing.cut(path, name)
    local lines = lines_of(path)
    local first, last = task(lines, name)
    if not first then first, last = func(lines, name) end
    assert(first, path .. ": found neither a task nor a function " .. name)
    local margin = lines[first]:match("^ *")
    local cut = {}
    for n = first, last do cut[#cut + 1] = (lines[n]:gsub("^" .. margin, "", 1)) end
    return table.concat(cut, "\n")
end

return listing
