# What `coilwright report` packs into its pages beside our own script: Vega, Vega-Lite and vega-embed, installed by npm at
# the versions of cmake/vega/package-lock.json when the build is configured. Nothing of theirs is in this repository.
#
# AUTO: taken where npm is found and can install them; otherwise the program is built without, and `report` says so.
set(COILWRIGHT_REPORT_ASSETS AUTO CACHE STRING "Pack Vega into the program, for reports: AUTO, ON or OFF")
set_property(CACHE COILWRIGHT_REPORT_ASSETS PROPERTY STRINGS AUTO ON OFF)

set(report_sources ${PROJECT_SOURCE_DIR}/cmake/vega)
set(report_folder ${PROJECT_BINARY_DIR}/report_assets)
set(COILWRIGHT_REPORT_FILES)  # of ${report_folder}/packed; empty: there are none

# coilwright_report_install(<why>): installs into ${report_folder}; what went wrong, or nothing.
function(coilwright_report_install why)
  set(${why} "" PARENT_SCOPE)
  find_program(COILWRIGHT_NPM npm)
  find_program(COILWRIGHT_NODE NAMES node nodejs)
  mark_as_advanced(COILWRIGHT_NPM COILWRIGHT_NODE)
  if(NOT COILWRIGHT_NPM OR NOT COILWRIGHT_NODE)
    set(${why} "npm was not found" PARENT_SCOPE)
    return()
  endif()
  # Once for a lock file and the script that packs.
  file(SHA256 ${report_sources}/package-lock.json lock)
  file(SHA256 ${report_sources}/pack.mjs pack)
  set(stamp ${report_folder}/packed/stamp.txt)
  if(EXISTS ${stamp})
    file(READ ${stamp} done)
    if(done STREQUAL "${lock} ${pack}")
      return()
    endif()
  endif()
  file(MAKE_DIRECTORY ${report_folder})
  file(COPY ${report_sources}/package.json ${report_sources}/package-lock.json ${report_sources}/.npmrc
       DESTINATION ${report_folder})
  message(STATUS "Installing what reports are drawn with (npm ci)")
  execute_process(COMMAND ${COILWRIGHT_NPM} ci --no-audit --no-fund --ignore-scripts --loglevel=error
    WORKING_DIRECTORY ${report_folder} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE message TIMEOUT 300)
  if(failed)
    string(REGEX REPLACE "\n.*" "" message "${message}")
    set(${why} "npm ci failed: ${message}" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND ${COILWRIGHT_NODE} ${report_sources}/pack.mjs ${report_folder} ${report_folder}/packed
    RESULT_VARIABLE failed ERROR_VARIABLE message)
  if(failed)
    set(${why} "pack.mjs failed: ${message}" PARENT_SCOPE)
    return()
  endif()
  file(WRITE ${stamp} "${lock} ${pack}")
endfunction()

if(COILWRIGHT_REPORT_ASSETS)
  coilwright_report_install(report_missing)
  if(report_missing STREQUAL "")
    set(COILWRIGHT_REPORT_FILES vega.js vega-lite.js vega-embed.js licences.txt)
  elseif(COILWRIGHT_REPORT_ASSETS STREQUAL "AUTO")
    message(STATUS "Built without what reports are drawn with: ${report_missing}")
  else()
    message(FATAL_ERROR "COILWRIGHT_REPORT_ASSETS is ON, and ${report_missing}")
  endif()
endif()
