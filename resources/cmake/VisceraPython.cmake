# Which Python the package is built for: the one that the system's pybind11, numpy and VTK belong to, also where another
# `python3` comes first in the PATH. VISCERA_PYTHON_FOUND says whether the package is built.
set(VISCERA_PYTHON_FOUND OFF)
if(NOT VISCERA_WITH_PYTHON OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  # A sanitiser's runtime would have to be loaded before the interpreter.
  return()
endif()
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.10 QUIET COMPONENTS Interpreter Development.Module NumPy)
find_package(pybind11 2.10 QUIET CONFIG)
if(Python_FOUND AND pybind11_FOUND)
  set(VISCERA_PYTHON_FOUND ON)
else()
  message(STATUS "The Python package is not built: it needs pybind11-dev, python3-dev and python3-numpy")
endif()
