# `cpack` makes the packages of Debian 12: one for each component of the installation. The preset `package` configures for
# them; resources/scripts/try_packages.sh makes them and tries them in a fresh Debian (docs/developer_guide.md).
#   Program viscera · Library libviscera0 · Development libviscera-dev · Python python3-viscera · Common viscera-common
#   Tetgen viscera-tetgen: the one program that falls under TetGen's AGPL
#   Paraview viscera-paraview: of a project of its own, where that was built into the folder paraview_plugin of the build

# As Debian's own tools have it; else an address that can belong to nobody (RFC 2606).
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(maintainer "Viscera developers <packages@viscera.invalid>")
endif()
set(VISCERA_PACKAGE_MAINTAINER "${maintainer}" CACHE STRING "Who answers for the packages, as NAME <ADDRESS>")
set(VISCERA_PARAVIEW_PREFIX "${PROJECT_SOURCE_DIR}/build/paraview" CACHE PATH
  "Where ParaView was unpacked that the packed plugin was built against")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "Viscera developers")
set(CPACK_PACKAGE_CONTACT "${VISCERA_PACKAGE_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL Library Development Common Tetgen)
if(VISCERA_WITH_APP)
  list(APPEND CPACK_COMPONENTS_ALL Program)
endif()
if(VISCERA_PYTHON_FOUND)
  list(APPEND CPACK_COMPONENTS_ALL Python)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE viscera)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Our own libraries belong to no package yet when dpkg-shlibdeps asks; those of others are found by it.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/lib")
file(GLOB paraview_libraries "${VISCERA_PARAVIEW_PREFIX}/usr/lib/*-linux-gnu")
list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${paraview_libraries})
set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(packages "${PROJECT_SOURCE_DIR}/resources/packages")

# Descriptions have at most 80 characters a line.
function(viscera_wrap text out)
  string(REPLACE " " ";" words "${text}")
  set(line "")
  set(lines "")
  foreach(word IN LISTS words)
    string(LENGTH "${line} ${word}" length)
    if(length GREATER 76)
      string(APPEND lines "${line}\n")
      set(line "${word}")
    else()
      string(STRIP "${line} ${word}" line)
    endif()
  endforeach()
  set(${out} "${lines}${line}" PARENT_SCOPE)
endfunction()

# viscera_package(<COMPONENT> <package> SECTION s DEPENDS d SUMMARY s TEXT t [RECOMMENDS r] [CONTROL files...] [ALL])
# ALL: of every architecture, without binaries.
macro(viscera_package component package)
  cmake_parse_arguments(ARG "ALL" "SECTION;DEPENDS;RECOMMENDS;SUMMARY;TEXT" "CONTROL" ${ARGN})
  set(CPACK_DEBIAN_${component}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${component}_PACKAGE_SECTION "${ARG_SECTION}")
  set(CPACK_DEBIAN_${component}_PACKAGE_DEPENDS "${ARG_DEPENDS}")
  set(CPACK_DEBIAN_${component}_PACKAGE_RECOMMENDS "${ARG_RECOMMENDS}")
  viscera_wrap("${ARG_TEXT}" wrapped)
  set(CPACK_DEBIAN_${component}_DESCRIPTION "${ARG_SUMMARY}\n${wrapped}")
  set(CPACK_DEBIAN_${component}_PACKAGE_CONTROL_EXTRA "${ARG_CONTROL}")
  set(CPACK_DEBIAN_${component}_PACKAGE_SHLIBDEPS ON)
  if(ARG_ALL)
    set(CPACK_DEBIAN_${component}_PACKAGE_ARCHITECTURE all)
    set(CPACK_DEBIAN_${component}_PACKAGE_SHLIBDEPS OFF)
  endif()
endmacro()

viscera_package(PROGRAM viscera SECTION science
  DEPENDS "libviscera0 (= ${version}), viscera-common (= ${version}), viscera-tetgen (= ${version}), libgl1-mesa-dri, libqt5svg5"
  RECOMMENDS "qttranslations5-l10n, libsecret-tools" # Qt's own words in the window's languages; the key ring.
  SUMMARY "organs deformed by handles, without a cage"
  TEXT "Viscera shows segmented organs, puts handles around them and deforms them, while it measures their volume. It plays a beating heart, peristalsis and breathing, reads scans and label maps, and does on the command line what its window does.")
viscera_package(LIBRARY libviscera0 SECTION libs CONTROL "${packages}/triggers" "${PROJECT_BINARY_DIR}/shlibs"
  DEPENDS "viscera-common (>= ${version})" RECOMMENDS "viscera-tetgen (= ${version})"
  SUMMARY "coordinates, volumes and stress of deformed organs - libraries"
  TEXT "Coordinate systems for deformations by handles (S-Celestial, mean value, harmonic and others), volumes and their gradients, rotational stress, sequences of motion, circulation, medical files. This package has the shared libraries.")
viscera_package(DEVELOPMENT libviscera-dev SECTION libdevel
  DEPENDS "libviscera0 (= ${version}), libeigen3-dev, nlohmann-json3-dev" RECOMMENDS "libvtk9-dev, qtbase5-dev"
  SUMMARY "coordinates, volumes and stress of deformed organs - headers"
  TEXT "Headers of the libraries of Viscera, and what find_package(Viscera) of CMake needs. The numerical modules need Eigen alone, those that draw need VTK and Qt.")
viscera_package(PYTHON python3-viscera SECTION python CONTROL "${packages}/python/postinst" "${packages}/python/prerm"
  DEPENDS "libviscera0 (= ${version}), viscera-common (= ${version}), python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3-numpy"
  RECOMMENDS "python3-vtk9"
  SUMMARY "coordinates, volumes and stress of deformed organs - Python"
  TEXT "The package viscera binds, poses and measures organs on arrays of NumPy. The package viscera_vtk has the same as filters for pipelines of VTK, and needs python3-vtk9.")
viscera_package(COMMON viscera-common ALL SECTION science
  SUMMARY "definitions of the sample organs of Viscera"
  TEXT "Heart, liver, stomach, bowel and kidneys as definitions of a few kilobytes, of which the program and the libraries make surfaces.")
viscera_package(TETGEN viscera-tetgen SECTION science
  SUMMARY "worker of Viscera that fills organs with tetrahedra"
  TEXT "A program that the libraries of Viscera start and never link. It is linked with TetGen and falls under the GNU Affero General Public License, version 3. Nothing else of Viscera does.")
# ParaView's libraries have no stable interface; each minor version wants a plugin of its own.
viscera_package(PARAVIEW viscera-paraview SECTION science
  DEPENDS "libviscera0 (= ${version}), paraview (>= 5.11), paraview (<< 5.12~)" RECOMMENDS "python3-paraview"
  SUMMARY "coordinates, volumes and stress of deformed organs - ParaView"
  TEXT "A plugin that poses organs by handles, keeps their volume and shows their stress in the window of ParaView, in pvpython, and in pvbatch and pvserver on any number of processes.")

# What Debian wants beside the installed files: copyright, changelog, compressed manual pages.
set(VISCERA_PACKAGE_VERSION "${version}")
configure_file("${packages}/finish_packages.cmake.in" "${PROJECT_BINARY_DIR}/finish_packages.cmake" @ONLY)
configure_file("${packages}/package_config.cmake.in" "${PROJECT_BINARY_DIR}/package_config.cmake" @ONLY)
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_BINARY_DIR}/finish_packages.cmake")
set(CPACK_POST_BUILD_SCRIPTS "${packages}/drop_ldconfig.cmake")
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_BINARY_DIR}/package_config.cmake")
include(CPack)
