# libcsv has no package configuration of its own: LibCsv::LibCsv
find_path(LibCsv_INCLUDE_DIR csv.h)
find_library(LibCsv_LIBRARY csv)
if(LibCsv_INCLUDE_DIR)
  file(READ "${LibCsv_INCLUDE_DIR}/csv.h" LibCsv_VERSION)
  string(REGEX REPLACE ".*CSV_MAJOR ([0-9]+).*CSV_MINOR ([0-9]+).*CSV_RELEASE ([0-9]+).*" "\\1.\\2.\\3" LibCsv_VERSION
         "${LibCsv_VERSION}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LibCsv REQUIRED_VARS LibCsv_LIBRARY LibCsv_INCLUDE_DIR VERSION_VAR LibCsv_VERSION)
if(LibCsv_FOUND AND NOT TARGET LibCsv::LibCsv)
  add_library(LibCsv::LibCsv UNKNOWN IMPORTED)
  set_target_properties(LibCsv::LibCsv PROPERTIES
    IMPORTED_LOCATION "${LibCsv_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${LibCsv_INCLUDE_DIR}")
endif()
mark_as_advanced(LibCsv_INCLUDE_DIR LibCsv_LIBRARY)
