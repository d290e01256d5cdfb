# Everything comes from the system's packages; scripts/setup.sh installs it.
include(CoilwrightPackages)
foreach(package IN LISTS coilwright_packages)
  find_package(${coilwright_find_${package}} REQUIRED)
endforeach()

# Of the program and the tests alone.
find_package(CLI11 2.1 REQUIRED)
find_package(glog 0.4 REQUIRED)
find_package(HttpLib 0.11 REQUIRED)
if(COILWRIGHT_TESTS)
  find_package(GTest 1.12 REQUIRED)
endif()
if(COILWRIGHT_BENCHMARKS)
  find_package(benchmark 1.7 REQUIRED)
endif()
