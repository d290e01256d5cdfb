# Installs the program, the libraries as components of a package, input files with their schemas, documents and examples.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/coilwright)
set(data_folder ${CMAKE_INSTALL_DATADIR}/coilwright)

# What a component links, from the link list of its library: other components, and packages.
function(coilwright_links component components_out packages_out)
  set(components)
  set(packages)
  get_target_property(kind coilwright_${component} TYPE)
  set(property LINK_LIBRARIES)
  if(kind STREQUAL INTERFACE_LIBRARY)
    set(property INTERFACE_LINK_LIBRARIES)
  endif()
  get_target_property(links coilwright_${component} ${property})
  foreach(link IN LISTS links)
    if(NOT link MATCHES "::")
      continue()  # nothing: the property is not set
    elseif(link MATCHES "^coilwright::(.+)")
      list(APPEND components ${CMAKE_MATCH_1})
    else()
      coilwright_package_of(${link} package)
      list(APPEND packages ${package})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES packages)
  set(${components_out} ${components} PARENT_SCOPE)
  set(${packages_out} ${packages} PARENT_SCOPE)
endfunction()

# The tables of coilwright-config.cmake. Components are in the order in which they were added: each after what it links.
get_property(components GLOBAL PROPERTY COILWRIGHT_COMPONENTS)
set(component_tables "set(coilwright_components ${components})\n")
set(used_packages)
foreach(component IN LISTS components)
  coilwright_links(${component} linked packages)
  set(needs_${component} ${component})
  foreach(other IN LISTS linked)
    list(APPEND needs_${component} ${needs_${other}})
  endforeach()
  list(REMOVE_DUPLICATES needs_${component})
  string(APPEND component_tables "set(coilwright_needs_${component} ${needs_${component}})\n"
                                 "set(coilwright_packages_of_${component} ${packages})\n")
  list(APPEND used_packages ${packages})
  install(EXPORT coilwright-${component} NAMESPACE coilwright:: FILE coilwright-${component}-targets.cmake
          DESTINATION ${package_folder} COMPONENT development)
endforeach()
list(REMOVE_DUPLICATES used_packages)
foreach(package IN LISTS used_packages)
  string(APPEND component_tables "set(coilwright_find_${package} ${coilwright_find_${package}})\n")
endforeach()
string(REPLACE ";" " " component_tables "${component_tables}")

configure_package_config_file(cmake/coilwright-config.cmake.in coilwright-config.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS data_folder)
write_basic_package_version_file(coilwright-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/coilwright-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/coilwright-config-version.cmake
              cmake/FindLibCsv.cmake cmake/FindSQLiteCpp.cmake
        DESTINATION ${package_folder} COMPONENT development)

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
# Input files to copy and change; no command looks for them. One study names a result of this repository.
install(DIRECTORY configs/ DESTINATION ${data_folder} PATTERN undeclared_after.json EXCLUDE)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Everything that is installed but the Python package, which pip builds: neither tests nor examples.
add_custom_target(installable DEPENDS programs)
list(TRANSFORM components PREPEND coilwright_)
foreach(target IN LISTS components ITEMS coilwright_opencv shell_files)
  if(TARGET ${target})
    add_dependencies(installable ${target})
  endif()
endforeach()
