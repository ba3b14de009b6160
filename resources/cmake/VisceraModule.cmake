# How every Viscera module is built: one shared library, the same warnings, headers under include/viscera/<name>.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_SCAN_FOR_MODULES OFF) # There are none, and files that are scanned for them are not compiled as one.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}:$ORIGIN")
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Protections against memory errors, in everything that is built (docs/SECURITY.md). Sanitisers bring their own.
option(VISCERA_HARDEN "Guard stacks, calls of the C library and tables of addresses" ON)
set(VISCERA_HARDENED OFF)
if(VISCERA_HARDEN AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(VISCERA_HARDENED ON)
  add_compile_options(-fstack-protector-strong -fstack-clash-protection)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    add_compile_options(-fcf-protection)
  endif()
  # It needs the optimiser; some distributions' compilers define it already.
  add_compile_options($<$<CONFIG:Release,RelWithDebInfo>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release,RelWithDebInfo>:-D_FORTIFY_SOURCE=2>)
  add_link_options(LINKER:-z,relro LINKER:-z,now LINKER:-z,noexecstack)
endif()

# What is built needs the libraries that it uses, not all that VTK's targets name. GCC may ask the linker for that by itself,
# clang does not.
add_link_options(LINKER:--as-needed)

find_program(VISCERA_CCACHE ccache)
if(VISCERA_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER "${VISCERA_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${VISCERA_CCACHE}")
endif()

# Warnings of our own code; third-party headers come in as SYSTEM.
function(viscera_warnings target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual>
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${VISCERA_WERROR}>>:-Werror>)
  # GCC 12 takes `"a" + std::string` for overlapping memory (GCC bug 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict>)
  endif()
endfunction()

# viscera_unity(<target>): with VISCERA_UNITY the compiler takes several files of the target as one, which reads Eigen, VTK
# and Qt once for all of them. What a file keeps for itself then needs a name that no other file of the target has
# (docs/developer_guide.md).
function(viscera_unity target)
  if(VISCERA_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 28)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # The files are included then, and GCC takes what is in an unnamed namespace of an included file for a mistake.
      target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>)
      # It clears its memory less often: 4 % faster, with some 1.2 GB at most.
      target_compile_options(${target} PRIVATE
        "$<$<COMPILE_LANGUAGE:CXX>:SHELL:--param ggc-min-expand=400 --param ggc-min-heapsize=1000000>")
    endif()
  endif()
endfunction()

# viscera_optimise_lightly(<target> <level>): for code that waits for people and files, where -O3 costs up to a quarter of the
# compiler's time and gains nothing.
function(viscera_optimise_lightly target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O${level}>)
endfunction()

# Flags of a target whose files begin with a precompiled header.
function(viscera_with_precompiled target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # So that ccache sees what the header holds.
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
    if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # GCC 12 forgets that warnings were switched off inside a precompiled system header.
      target_compile_options(${target} PRIVATE
        $<$<COMPILE_LANGUAGE:CXX>:-Wno-stringop-overflow -Wno-array-bounds>)
    endif()
  endif()
endfunction()

# viscera_precompile(<target> <header>): the header is compiled once and comes first in every file of the target.
function(viscera_precompile target header)
  if(VISCERA_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${header}>")
    viscera_with_precompiled(${target})
  endif()
endfunction()

# The floors of the house, from the lowest: a module may use those of its own stratum and of lower ones.
set(VISCERA_STRATA numbers content work faces)

# viscera_describe_module(<name> STRATUM stratum ABOUT text [FOLDER folder] [USES targets...] [PRIVATELY targets...])
# notes a folder of modules/ (of the CMakeLists.txt that calls it, unless given): its stratum, what it contains, and what it
# may include, public headers only what is in USES. The tests of tests/contract/house and the table in docs/architecture.md
# are made of these notes.
function(viscera_describe_module name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "STRATUM;ABOUT;FOLDER" "USES;PRIVATELY")
  if(NOT ARG_STRATUM IN_LIST VISCERA_STRATA OR NOT ARG_ABOUT)
    message(FATAL_ERROR "Module ${name} needs ABOUT and a STRATUM of: ${VISCERA_STRATA}.")
  endif()
  if(NOT ARG_FOLDER)
    file(RELATIVE_PATH ARG_FOLDER "${PROJECT_SOURCE_DIR}/modules" "${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  list(JOIN ARG_USES " " uses)
  list(JOIN ARG_PRIVATELY " " privately)
  set_property(GLOBAL APPEND_STRING PROPERTY VISCERA_MODULE_NOTES
    "module ${name}\nfolder ${ARG_FOLDER}\nstratum ${ARG_STRATUM}\nuses ${uses}\nprivately ${privately}\nabout ${ARG_ABOUT}\n")
endfunction()

# viscera_module(<name> STRATUM stratum ABOUT text SOURCES a.cpp ... [USES targets-in-public-headers...] [PRIVATELY targets...])
# makes the shared library viscera_<name> (alias Viscera::<name>) from files under src/,
# whose public headers are in include/viscera/<name>/.
function(viscera_module name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "STRATUM;ABOUT" "SOURCES;USES;PRIVATELY")
  viscera_describe_module(${name} STRATUM "${ARG_STRATUM}" ABOUT "${ARG_ABOUT}" USES ${ARG_USES} PRIVATELY ${ARG_PRIVATELY})
  list(TRANSFORM ARG_SOURCES PREPEND "src/")
  add_library(viscera_${name} SHARED ${ARG_SOURCES})
  add_library(Viscera::${name} ALIAS viscera_${name})
  set_target_properties(viscera_${name} PROPERTIES
    EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  target_compile_features(viscera_${name} PUBLIC cxx_std_20)
  target_include_directories(viscera_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE src)
  target_link_libraries(viscera_${name} PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATELY})
  # A symbol that nobody defines is found when the library is linked, not when it is used.
  if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_link_options(viscera_${name} PRIVATE LINKER:--no-undefined)
  endif()
  if("${name}" IN_LIST VISCERA_NOT_SANITISED)
    target_compile_options(viscera_${name} PRIVATE -fno-sanitize=all)
  endif()
  viscera_warnings(viscera_${name})
  viscera_unity(viscera_${name})
  install(TARGETS viscera_${name} EXPORT VisceraTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Library NAMELINK_COMPONENT Development)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT Development)
endfunction()
