# Run by CTest with -P; the variables in capitals come from CMakeLists.txt. Builds the plugin against this build and ParaView,
# and runs paraview_test.py.
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/../support/run.cmake")

set(paraview "$ENV{VISCERA_PARAVIEW_PREFIX}")
if(NOT paraview)
  set(paraview "${SOURCE_DIR}/build/paraview")
endif()
file(GLOB config "${paraview}/usr/lib/*/cmake/paraview-*")
if(NOT config OR NOT EXISTS "${paraview}/usr/bin/pvbatch")
  message("skipped: there is no ParaView in ${paraview} (packages paraview, paraview-dev, python3-paraview; test.sh unpacks them)")
  return()
endif()

find_program(ccache ccache)
set(launcher)
if(ccache)
  set(launcher -D "CMAKE_CXX_COMPILER_LAUNCHER=${ccache}")
endif()
run("Configuring the plugin" COMMAND ${CMAKE_COMMAND} -S "${SOURCE_DIR}/modules/bindings/paraview" -B "${WORK_DIR}/plugin"
  -G "${GENERATOR}" -D "CMAKE_CXX_COMPILER=${CXX_COMPILER}" -D CMAKE_BUILD_TYPE=Release ${launcher}
  -D "ParaView_DIR=${config}" -D "Viscera_DIR=${BUILD_DIR}" -D "Python3_EXECUTABLE=${PYTHON}")
set(ENV{LD_LIBRARY_PATH} "${paraview}/usr/lib/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu")
run("Building the plugin" COMMAND ${CMAKE_COMMAND} --build "${WORK_DIR}/plugin")
set(ENV{LD_LIBRARY_PATH})
file(GLOB_RECURSE plugin "${WORK_DIR}/plugin/lib/*/Viscera.so")
if(NOT plugin)
  message(FATAL_ERROR "the plugin was not built")
endif()
# What the package viscera-paraview holds.
set(installed "${WORK_DIR}/installed")
file(REMOVE_RECURSE "${installed}")
run("Installing the plugin" COMMAND ${CMAKE_COMMAND} --install "${WORK_DIR}/plugin" --component Paraview --prefix "${installed}")
file(GLOB_RECURSE package RELATIVE "${installed}" "${installed}/*")
foreach(file IN LISTS package)
  if(NOT file MATCHES "^lib/.*paraview-[0-9.]+/plugins/(viscera\\.xml|Viscera/(Viscera\\.so|libvtkVisceraFilters-pv[0-9.]+\\.so[0-9.]*))$")
    message(SEND_ERROR "viscera-paraview should not hold ${file}")
  endif()
endforeach()
if(NOT package MATCHES "/plugins/Viscera/Viscera\\.so")
  message(SEND_ERROR "viscera-paraview has no plugin: ${package}")
endif()

set(ENV{PYTHONPATH} "${PYTHON_PATH}")
run("The tests in ParaView" COMMAND "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/paraview_test.py"
  "${paraview}" "${WORK_DIR}/files" "${plugin}" OUTPUT said)
message("${said}")
