-- Runs a script for FEMM with stand-ins of FEMM's functions, each of which prints its name and its arguments, a line each
-- with tabs between them. usage: lua5.4 record_femm.lua SCRIPT
-- Any other function is an error, and so is a wrong number of arguments: FEMM's manual, "Lua scripting".

local arguments = {
  newdocument = 1, showconsole = 0,
  mi_probdef = 6, mi_addnode = 2, mi_addsegment = 4, mi_addarc = 6, mi_addblocklabel = 2, mi_selectlabel = 2,
  mi_selectarcsegment = 2, mi_clearselected = 0, mi_setblockprop = 7, mi_setarcsegmentprop = 4, mi_addmaterial = 12,
  mi_addboundprop = 10, mi_addcircprop = 3, mi_zoomnatural = 0, mi_saveas = 1, mi_analyze = 0, mi_loadsolution = 0,
  mo_groupselectblock = 1, mo_blockintegral = 1, mo_clearblock = 0,
}

local environment = { print = function(...) print("print", ...) end }
for name, count in pairs(arguments) do
  environment[name] = function(...)
    assert(select("#", ...) == count, name .. " takes " .. count .. " arguments")
    local words = { name }
    for i = 1, count do
      local value = select(i, ...)
      assert(value ~= nil, name .. ": argument " .. i .. " is nil")
      words[#words + 1] = type(value) == "number" and string.format("%.17g", value) or value
    end
    print(table.concat(words, "\t"))
    return 1.5
  end
end

-- Reading a variable that is not there is an error as well.
setmetatable(environment, { __index = function(_, name) error("no " .. name) end })
assert(loadfile(arg[1], "t", environment))()
