# Debian packages of an install, by `cpack` (scripts/package.sh): coilwright, with programs, manual pages, completion,
# libraries and headers; and coilwright-films, the module that reads films, since it brings OpenCV. What they depend on is
# read from what they link.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The maintainers of Coilwright")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME coilwright)
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "Sizes soft electromagnetic bending actuators
 and identifies, from measured motion, which physical effect a model lacks.")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS "coilwright-films, nodejs")
if(TARGET coilwright_opencv)
  list(APPEND CPACK_COMPONENTS_ALL films)
  set(CPACK_DEBIAN_FILMS_PACKAGE_NAME coilwright-films)
  set(CPACK_DEBIAN_FILMS_PACKAGE_DEPENDS coilwright)
  set(CPACK_COMPONENT_FILMS_DESCRIPTION "Reads films of a finger for Coilwright
 with the libraries of OpenCV.")
endif()
include(CPack)
