# Installation and export, so that another project can say find_package(Viscera).
include(CMakePackageConfigHelpers)

# The parts of VTK that our libraries name; whoever uses them has to find the same.
set(viscera_vtk_components)
foreach(module IN ITEMS medical_io scene)
  if(TARGET viscera_${module})
    get_target_property(libraries viscera_${module} LINK_LIBRARIES)
    list(FILTER libraries INCLUDE REGEX "^VTK::")
    list(TRANSFORM libraries REPLACE "^VTK::" "")
    list(APPEND viscera_vtk_components ${libraries})
  endif()
endforeach()
list(REMOVE_DUPLICATES viscera_vtk_components)
list(SORT viscera_vtk_components)
list(JOIN viscera_vtk_components " " viscera_vtk_components)

set(viscera_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Viscera")
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/resources/cmake/VisceraConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/VisceraConfig.cmake"
  INSTALL_DESTINATION "${viscera_config_dir}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/VisceraConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/VisceraConfig.cmake"
  "${PROJECT_BINARY_DIR}/VisceraConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/resources/cmake/VisceraPlugin.cmake"
  DESTINATION "${viscera_config_dir}" COMPONENT Development)
install(EXPORT VisceraTargets NAMESPACE Viscera:: DESTINATION "${viscera_config_dir}" COMPONENT Development)
# Another project may also take the build as it is, by -DViscera_DIR=: the plugin of ParaView does in the tests.
export(EXPORT VisceraTargets NAMESPACE Viscera:: FILE "${PROJECT_BINARY_DIR}/VisceraTargets.cmake")
file(COPY "${PROJECT_SOURCE_DIR}/resources/cmake/VisceraPlugin.cmake" DESTINATION "${PROJECT_BINARY_DIR}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT Development)

# What a desktop needs to know the program.
if(VISCERA_WITH_APP)
  set(viscera_desktop_dir "${PROJECT_SOURCE_DIR}/resources/desktop")
  install(FILES "${viscera_desktop_dir}/org.viscera.Viscera.desktop"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT Program)
  install(FILES "${viscera_desktop_dir}/org.viscera.Viscera.svg"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps" COMPONENT Program)
  install(FILES "${viscera_desktop_dir}/org.viscera.Viscera.mime.xml"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" COMPONENT Program RENAME org.viscera.Viscera.xml)
  install(FILES "${viscera_desktop_dir}/org.viscera.Viscera.metainfo.xml"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo" COMPONENT Program)
endif()
