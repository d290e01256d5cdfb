# Where the targets of other projects that Coilwright links come from: the arguments of find_package, one row a package.
# The build finds them by this table, and the installed package finds those of the components that are asked for.
# scripts/setup.sh installs all of them from the system's packages.
set(coilwright_packages NLopt Eigen3 Boost nlohmann_json TBB fmt hwy Ceres LibCsv muparser pugixml SQLiteCpp OpenSSL)
set(coilwright_find_NLopt NLopt 2.7 CONFIG)
set(coilwright_find_Eigen3 Eigen3 3.4 NO_MODULE)
set(coilwright_find_Boost Boost 1.74 CONFIG)
set(coilwright_find_nlohmann_json nlohmann_json 3.11)
set(coilwright_find_TBB TBB 2021)
set(coilwright_find_fmt fmt 9)
set(coilwright_find_hwy hwy 1.0.3 CONFIG)
set(coilwright_find_Ceres Ceres 2.1 CONFIG)
set(coilwright_find_LibCsv LibCsv)
set(coilwright_find_muparser muparser 2.3 CONFIG)
set(coilwright_find_pugixml pugixml 1.12 CONFIG)
set(coilwright_find_SQLiteCpp SQLiteCpp 3.2 MODULE)
set(coilwright_find_OpenSSL OpenSSL 3.0 COMPONENTS Crypto)
# Where they are in Debian.
set(coilwright_debian_packages libnlopt-dev libeigen3-dev libboost-dev nlohmann-json3-dev libtbb-dev libfmt-dev libhwy-dev
  libceres-dev libcsv-dev libmuparser-dev libpugixml-dev libsqlitecpp-dev libssl-dev)

# coilwright_package_of(<target> <out>): the package that has a target, which is the part of its name before "::".
function(coilwright_package_of target out)
  string(REGEX REPLACE "::.*" "" package "${target}")
  if(NOT package IN_LIST coilwright_packages)
    message(FATAL_ERROR "${target} is linked and of no package in cmake/CoilwrightPackages.cmake")
  endif()
  set(${out} ${package} PARENT_SCOPE)
endfunction()
