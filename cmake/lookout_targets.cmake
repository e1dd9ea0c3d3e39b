# The warnings, the language standard and the sanitizers of every target, in one place.
add_library(lookout_warnings INTERFACE)
target_compile_features(lookout_warnings INTERFACE cxx_std_20)
target_compile_options(lookout_warnings INTERFACE -Wall -Wextra -Wconversion -Wpedantic)
# No product and sum in one rounding on a processor that can (arm64, amd64 with -march=native): it then computes what one
# that cannot does (amd64 as Debian builds for it), and a replay ashore is what the vehicle did.
include(CheckCXXSourceCompiles)
check_cxx_source_compiles("
#if !defined(__FMA__) && !defined(__FMA4__) && !defined(__ARM_FEATURE_FMA)
#error
#endif
int main() {}" LOOKOUT_FUSES_PRODUCT_AND_SUM)
if(LOOKOUT_FUSES_PRODUCT_AND_SUM)
  target_compile_options(lookout_warnings INTERFACE -ffp-contract=off)
endif()
if(LOOKOUT_WERROR)
  target_compile_options(lookout_warnings INTERFACE -Werror)
endif()
if(LOOKOUT_SANITIZE)
  # g++'s vptr check crashes inside LCM's member-function subscribe.
  target_compile_options(lookout_warnings INTERFACE -fsanitize=${LOOKOUT_SANITIZE} -fno-sanitize=vptr
                         -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(lookout_warnings INTERFACE -fsanitize=${LOOKOUT_SANITIZE})
endif()
if(LOOKOUT_FUZZERS)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "LOOKOUT_FUZZERS: libFuzzer comes with clang, expected CMAKE_CXX_COMPILER clang++ (preset fuzz)")
  endif()
  # clang's check of function types sees types of other libraries twice, and cries.
  target_compile_options(lookout_warnings INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize=function)
endif()
if(LOOKOUT_COVERAGE)
  target_compile_options(lookout_warnings INTERFACE --coverage)
  target_link_options(lookout_warnings INTERFACE --coverage)
endif()

# What was compiled before is taken from ccache where it is installed and no other launcher was named. Paths below the
# checkout count as relative, so that two checkouts share; the two leniencies are what precompiled headers need.
find_program(LOOKOUT_CCACHE ccache)
mark_as_advanced(LOOKOUT_CCACHE)
if(LOOKOUT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
      CCACHE_SLOPPINESS=pch_defines,time_macros ${LOOKOUT_CCACHE})
endif()

# lookout_precompile(TARGET OWNER [HEADER...]) parses the headers that nearly every source includes once for all
# targets with the same flags: OWNER, the first of them, holds them and the others take them from it.
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, and so shows a source that forgets an include.
set(LOOKOUT_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numbers>
    <optional> <span> <stdexcept> <string> <string_view> <utility> <vector> <Eigen/Cholesky> <Eigen/Core> <Eigen/LU>)
function(lookout_precompile target owner)
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${LOOKOUT_COMMON_HEADERS} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()

# lookout_shareable(TARGET): the Python module, a shared library, may be linked of it. Calls within a source are still bound
# when it is compiled, so that the program is as fast as without.
function(lookout_shareable target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# lookout_library(NAME SOURCES... ) declares the folder's library target lookout_NAME with alias lookout::NAME.
function(lookout_library name)
  add_library(lookout_${name} STATIC ${ARGN})
  add_library(lookout::${name} ALIAS lookout_${name})
  set_target_properties(lookout_${name} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(lookout_${name} PRIVATE $<BUILD_INTERFACE:lookout_warnings>)
  target_compile_features(lookout_${name} PUBLIC cxx_std_20)
  target_include_directories(lookout_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/lookout>)
  lookout_shareable(lookout_${name})
  lookout_precompile(lookout_${name} lookout_core)
  set_property(GLOBAL APPEND PROPERTY LOOKOUT_LIBRARIES lookout_${name})
endfunction()

# lookout_parameter_fields(NAME HEADER USER STRUCTS...) makes NAME/HEADER of library lookout_NAME for its source USER: the
# fields of structs of parameters by name. See cmake/parameter_fields.py for STRUCTS.
find_program(LOOKOUT_PYTHON_PROGRAM NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
mark_as_advanced(LOOKOUT_PYTHON_PROGRAM)
function(lookout_parameter_fields name header user)
  set(headers ${ARGN})
  list(FILTER headers INCLUDE REGEX ":")
  list(TRANSFORM headers REPLACE ":.*" "")
  list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/)
  set(generated ${PROJECT_BINARY_DIR}/generated)
  file(MAKE_DIRECTORY ${generated}/${name})
  add_custom_command(OUTPUT ${generated}/${name}/${header}
    COMMAND ${LOOKOUT_PYTHON_PROGRAM} ${PROJECT_SOURCE_DIR}/cmake/parameter_fields.py ${PROJECT_SOURCE_DIR}
            ${generated}/${name}/${header} ${ARGN}
    DEPENDS ${headers} ${PROJECT_SOURCE_DIR}/cmake/parameter_fields.py VERBATIM)
  add_custom_target(lookout_${name}_fields DEPENDS ${generated}/${name}/${header})
  add_dependencies(lookout_${name} lookout_${name}_fields)
  target_sources(lookout_${name} PRIVATE ${generated}/${name}/${header})
  set_source_files_properties(${user} PROPERTIES INCLUDE_DIRECTORIES ${generated})
endfunction()

# lookout_tests(NAME SOURCES...) declares the test program of one folder.
function(lookout_tests name)
  add_executable(${name}_tests ${ARGN})
  target_link_libraries(${name}_tests PRIVATE lookout_warnings GTest::gtest_main)
  target_include_directories(${name}_tests PRIVATE ${PROJECT_SOURCE_DIR})
  # Test code is compiled for quick builds; the libraries that it exercises keep the build type's optimisation.
  target_compile_options(${name}_tests PRIVATE $<$<CONFIG:Release>:-O1>)
  lookout_precompile(${name}_tests core_tests <gtest/gtest.h>)
  # Tests run in the source folder and name its files relative to it, so that no object depends on where it lies.
  target_compile_definitions(${name}_tests PRIVATE LOOKOUT_SOURCE_DIR=".")
  gtest_discover_tests(${name}_tests TEST_PREFIX "${name}/" DISCOVERY_TIMEOUT 60
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} PROPERTIES TIMEOUT 240)
endfunction()
