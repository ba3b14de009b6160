# Installation and export, so that another project can say find_package(Viscera).
include(CMakePackageConfigHelpers)
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
  DESTINATION "${viscera_config_dir}")
install(EXPORT VisceraTargets NAMESPACE Viscera:: DESTINATION "${viscera_config_dir}")
