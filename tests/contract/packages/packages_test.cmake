# Run by CTest with -P: installs each component into a folder of its own and reads the lists of files.
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/../../support/run.cmake")

# The files of a component, relative to the prefix, into `out`.
function(files_of component out)
  set(prefix "${WORK_DIR}/${component}")
  file(MAKE_DIRECTORY "${prefix}")
  run("Installing ${component}" COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --component ${component} --prefix "${prefix}")
  file(GLOB_RECURSE files RELATIVE "${prefix}" "${prefix}/*")
  set(${out} "${files}" PARENT_SCOPE)
endfunction()

# expect(<component> ONLY regex... HAS file...): the component's files all match one of the expressions, and those named are there.
set(seen)
function(expect component)
  cmake_parse_arguments(ARG "" "" "ONLY;HAS" ${ARGN})
  files_of(${component} files)
  list(JOIN ARG_ONLY "|" allowed)
  foreach(file IN LISTS files)
    if(NOT file MATCHES "^(${allowed})$")
      message(SEND_ERROR "${component} should not hold ${file}")
    endif()
    if(file IN_LIST seen)
      message(SEND_ERROR "${file} is in ${component} and in another component")
    endif()
  endforeach()
  foreach(file IN LISTS ARG_HAS)
    if(NOT file IN_LIST files)
      message(SEND_ERROR "${component} has no ${file}")
    endif()
  endforeach()
  list(LENGTH files count)
  message(STATUS "${component}: ${count} files")
  list(APPEND seen ${files})
  set(seen "${seen}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
set(lib "${LIBDIR}")
set(version "[0-9]+(\\.[0-9]+)*")
expect(Program
  ONLY "bin/viscera" "${lib}/viscera/libviscera_app\\.so\\.${version}" "share/(applications|icons|mime|metainfo|man)/.*"
    "share/bash-completion/completions/viscera" "share/zsh/vendor-completions/_viscera"
  HAS bin/viscera share/man/man1/viscera.1 share/man/man1/viscera-play.1 share/man/man1/viscera-deform.1
    share/bash-completion/completions/viscera share/zsh/vendor-completions/_viscera
    share/applications/org.viscera.Viscera.desktop share/mime/packages/org.viscera.Viscera.xml
    share/metainfo/org.viscera.Viscera.metainfo.xml share/icons/hicolor/scalable/apps/org.viscera.Viscera.svg)
expect(Library
  ONLY "${lib}/lib[A-Za-z_]+\\.so\\.${version}" "${lib}/viscera/plugins/[a-z_]+\\.so"
  HAS "${lib}/libviscera_core.so.0" "${lib}/libviscera_deformation.so.0" "${lib}/viscera/plugins/localised_scc_plugin.so")
expect(Development
  ONLY "include/.*\\.h" "${lib}/lib[A-Za-z_]+\\.so" "${lib}/cmake/Viscera/.*" "${lib}/vtk/hierarchy/.*" "share/doc/Viscera/LICENSE"
  HAS include/viscera/core/arrays.h "${lib}/libviscera_core.so" "${lib}/cmake/Viscera/VisceraConfig.cmake")
expect(Common ONLY "share/viscera/sample_organs/.*\\.json" HAS share/viscera/sample_organs/heart.json)
expect(Tetgen ONLY "libexec/viscera/viscera_tetgen_worker" HAS libexec/viscera/viscera_tetgen_worker)
if(PYTHON_PACKAGE)
  expect(Python ONLY "lib/python3/dist-packages/viscera(_vtk)?/.*" "${lib}/lib[A-Za-z_]*Python[A-Za-z_.0-9-]*\\.so.*"
    HAS lib/python3/dist-packages/viscera/__init__.py)
endif()

# What an install rule without a component would hold is in no package.
files_of(Unspecified forgotten)
if(forgotten)
  message(SEND_ERROR "in no package: ${forgotten}")
endif()
file(REMOVE_RECURSE "${WORK_DIR}")
