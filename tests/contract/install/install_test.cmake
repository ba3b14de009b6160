# Run by CTest with -P; the variables in capitals come from CMakeLists.txt.
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/../../support/run.cmake")

file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/a prefix with spaces")
run("Installing" COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${prefix}")

foreach(file IN ITEMS
    bin/viscera
    include/viscera/core/arrays.h
    include/viscera/coordinates/coordinate_system.h
    share/viscera/sample_organs/heart.json
    share/applications/org.viscera.Viscera.desktop
    share/mime/packages/org.viscera.Viscera.xml
    share/metainfo/org.viscera.Viscera.metainfo.xml
    share/icons/hicolor/scalable/apps/org.viscera.Viscera.svg
    "${LIBDIR}/cmake/Viscera/VisceraConfig.cmake")
  if(NOT EXISTS "${prefix}/${file}")
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()

# A stranger's project.
run("Configuring the other project" COMMAND ${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${WORK_DIR}/consumer"
  -G "${GENERATOR}" -D "CMAKE_CXX_COMPILER=${CXX_COMPILER}" -D CMAKE_BUILD_TYPE=Release
  -D "CMAKE_PREFIX_PATH=${prefix}")
run("Building the other project" COMMAND ${CMAKE_COMMAND} --build "${WORK_DIR}/consumer")
run("The other project" COMMAND "${WORK_DIR}/consumer/consumer" OUTPUT said)
message(STATUS "${said}")

# A stranger's pipeline of VTK.
if(EXISTS "${prefix}/${LIBDIR}/cmake/Viscera/VisceraVtk-targets.cmake")
  run("Configuring the pipeline" COMMAND ${CMAKE_COMMAND} -S "${CMAKE_CURRENT_LIST_DIR}/vtk_pipeline"
    -B "${WORK_DIR}/vtk_pipeline" -G "${GENERATOR}" -D "CMAKE_CXX_COMPILER=${CXX_COMPILER}" -D CMAKE_BUILD_TYPE=Release
    -D "CMAKE_PREFIX_PATH=${prefix}")
  run("Building the pipeline" COMMAND ${CMAKE_COMMAND} --build "${WORK_DIR}/vtk_pipeline")
  run("The pipeline" COMMAND "${WORK_DIR}/vtk_pipeline/vtk_pipeline" OUTPUT said)
  message(STATUS "${said}")
endif()

# The installed packages of Python find their libraries.
if(EXISTS "${prefix}/lib/python3/dist-packages/viscera/__init__.py")
  set(ENV{PYTHONPATH} "${prefix}/lib/python3/dist-packages")
  run("import viscera" COMMAND "${PYTHON}" -c "import viscera, viscera._files, viscera._motion; print(viscera.sample_names())"
    OUTPUT said)
  if(EXISTS "${prefix}/lib/python3/dist-packages/viscera_vtk")
    run("import viscera_vtk" COMMAND "${PYTHON}" -c "from viscera_vtk.vtkVisceraFilters import vtkVisceraDeformFilter")
  endif()
  unset(ENV{PYTHONPATH})
endif()

# The installed program finds its libraries and its organs without help, and without the build's.
unset(ENV{LD_LIBRARY_PATH})
unset(ENV{VISCERA_SAMPLE_ORGANS})
unset(ENV{DISPLAY})
run("viscera sample --list" COMMAND "${prefix}/bin/viscera" sample --list OUTPUT organs)
if(NOT organs MATCHES "heart")
  message(FATAL_ERROR "the installed program lists no heart:\n${organs}")
endif()
run("ldd" COMMAND ldd "${prefix}/bin/viscera" OUTPUT libraries)
string(FIND "${libraries}" "${BUILD_DIR}/lib/" from_build)
if(libraries MATCHES "not found" OR NOT from_build EQUAL -1)
  message(FATAL_ERROR "the installed program does not load the installed libraries:\n${libraries}")
endif()
run("viscera systems" COMMAND "${prefix}/bin/viscera" systems OUTPUT systems)
if(NOT systems MATCHES "s-celestial")
  message(FATAL_ERROR "the installed program knows no S-Celestial:\n${systems}")
endif()
file(REMOVE_RECURSE "${WORK_DIR}")
