# Debian's cpp-httplib is compiled, and has a pkg-config file alone: HttpLib::HttpLib. Whoever includes its header must
# say what it was compiled with, as its classes have further members then.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(HttpLib QUIET IMPORTED_TARGET cpp-httplib)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HttpLib REQUIRED_VARS HttpLib_LINK_LIBRARIES VERSION_VAR HttpLib_VERSION)
if(HttpLib_FOUND AND NOT TARGET HttpLib::HttpLib)
  add_library(HttpLib::HttpLib ALIAS PkgConfig::HttpLib)
endif()
