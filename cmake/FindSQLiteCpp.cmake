# The target SQLiteCpp::SQLiteCpp: the package of SQLiteCpp 3.2 calls its own SQLiteCpp, which a linker's flag may be too.
find_package(SQLiteCpp ${SQLiteCpp_FIND_VERSION} CONFIG QUIET)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SQLiteCpp REQUIRED_VARS SQLiteCpp_DIR VERSION_VAR SQLiteCpp_VERSION)
if(SQLiteCpp_FOUND AND NOT TARGET SQLiteCpp::SQLiteCpp)
  add_library(SQLiteCpp::SQLiteCpp INTERFACE IMPORTED)
  set_target_properties(SQLiteCpp::SQLiteCpp PROPERTIES INTERFACE_LINK_LIBRARIES SQLiteCpp)
endif()
