# viscera_coordinate_plugin(<name> SOURCES a.cpp manifest.json [USES targets...])
# makes a plugin with coordinate systems that viscera finds: in this build, or, from a project that said
# find_package(Viscera), in the folder that `--plugin-path` or VISCERA_PLUGIN_PATH names.
function(viscera_coordinate_plugin name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  find_package(Qt5 5.15 REQUIRED COMPONENTS Core)
  add_library(${name} MODULE ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES AUTOMOC ON PREFIX ""
    LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib/viscera/plugins"
    INSTALL_RPATH "$ORIGIN/../..")
  target_link_libraries(${name} PRIVATE Viscera::plugin Qt5::Core ${ARG_USES})
  if(COMMAND viscera_warnings)
    viscera_warnings(${name})
    install(TARGETS ${name} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/viscera/plugins" COMPONENT Library)
  endif()
endfunction()
