# SPDX-License-Identifier: GPL-3.0-or-later
# Flags and the two functions that every folder's CMakeLists.txt uses.

# -ffp-contract=off: the same result with and without fused multiply-add, so one state hash for every x86-64 build.
# g++ tells of what is doubtful, and its warnings are errors; clang++ is for sanitizers, and keeps quiet. What sanitizers
# put in makes g++ warn of values that are set on every way there is: no -Werror there.
add_library(rhexis_flags INTERFACE)
target_compile_options(rhexis_flags INTERFACE -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  target_compile_options(rhexis_flags INTERFACE -w)
else()
  target_compile_options(rhexis_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
    -Wnon-virtual-dtor -Wold-style-cast $<IF:$<CONFIG:Sanitize,Thread>,-Wno-maybe-uninitialized,-Werror>)
endif()
# What is installed may become part of a shared library, and nobody replaces its functions there.
target_compile_options(rhexis_flags INTERFACE -fPIC -fno-semantic-interposition)
# In a batch a local name may hide a constant of another source, a class kept to one source looks like one that two
# could define differently, and g++ 12 warns of its own std::string.
if(CMAKE_UNITY_BUILD)
  target_compile_options(rhexis_flags INTERFACE -Wshadow=local -Wno-subobject-linkage -Wno-array-bounds -Wno-restrict
    -Wno-stringop-overflow)
else()
  target_compile_options(rhexis_flags INTERFACE -Wshadow)
endif()

target_sources(rhexis_flags INTERFACE
  $<$<AND:$<CONFIG:Sanitize>,$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>>:${CMAKE_CURRENT_LIST_DIR}/sanitizer_defaults.cpp>)

# What most sources read first; three precompiled headers hold it: kernel, bindings and tests.
set(rhexis_headers <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <functional> <memory> <optional> <string>
  <vector>)

# rhexis_alone(SOURCE...): never in a batch, since another source of the folder gives the same name to another thing.
function(rhexis_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# rhexis_kernel_folder(NAME [OURS] [DEPENDS other...] [LIBRARIES external...]): all .cpp of kernel/NAME and below as one
# static library; OURS: only our own commands use it, it is not installed.
function(rhexis_kernel_folder name)
  cmake_parse_arguments(ARG "OURS" "" "DEPENDS;LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(rhexis_${name} STATIC ${sources})
    target_include_directories(rhexis_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/kernel>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rhexis>)
    target_link_libraries(rhexis_${name} PRIVATE $<BUILD_INTERFACE:rhexis_flags>)
    target_link_libraries(rhexis_${name} PUBLIC ${ARG_LIBRARIES})
    foreach(other ${ARG_DEPENDS})
      target_link_libraries(rhexis_${name} PUBLIC rhexis_${other})
    endforeach()
    if(NOT name STREQUAL base AND NOT name STREQUAL math)
      target_precompile_headers(rhexis_${name} REUSE_FROM rhexis_math)
    endif()
  else()
    add_library(rhexis_${name} INTERFACE)
    target_include_directories(rhexis_${name} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/kernel>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rhexis>)
    foreach(other ${ARG_DEPENDS})
      target_link_libraries(rhexis_${name} INTERFACE rhexis_${other})
    endforeach()
  endif()
  if(NOT ARG_OURS)
    set_property(GLOBAL APPEND PROPERTY RHEXIS_KERNEL_TARGETS rhexis_${name})
  endif()
endfunction()

# rhexis_loaded(TARGET NAME): a module that load_library("NAME.so") finds beside the program, and where it is installed. Of
# all that is linked into it only the entries are seen: it shares nothing with the program but the C++ library.
function(rhexis_loaded target name)
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME ${name}
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bindings/cli)
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL -Wl,-Bsymbolic)
  set_property(GLOBAL APPEND PROPERTY RHEXIS_LOADED ${target})
endfunction()

# rhexis_embed(NAME FOLDER FUNCTION): the files of assets/FOLDER travel inside kernel folder NAME, as the function that
# NAME/FUNCTION.hpp declares.
function(rhexis_embed name folder function)
  file(GLOB texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/assets/${folder}/*)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${texts}" -DHEADER=${name}/${function}.hpp -DFUNCTION=${function} -DOUT=${out}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_texts.cmake
    DEPENDS ${texts} ${PROJECT_SOURCE_DIR}/cmake/embed_texts.cmake VERBATIM)
  target_sources(rhexis_${name} PRIVATE ${out})
endfunction()

# rhexis_test_folder(NAME [LIBRARIES ...] [LABELS ...] [TIMEOUT s] [COST c]): all test_*.cpp here as one doctest program.
# Of several that are left, CTest begins with the one of the highest cost.
function(rhexis_test_folder name)
  cmake_parse_arguments(ARG "" "TIMEOUT;COST" "LIBRARIES;LABELS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/test_*.cpp)
  if(NOT sources)
    return()
  endif()
  if(CMAKE_BUILD_TYPE STREQUAL "Sanitize" AND ARG_LABELS MATCHES "slow|long")
    return()  # only the quick ones run sanitized
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE rhexis_flags rhexis_test_support rhexis_test_main ${ARG_LIBRARIES})
  target_precompile_headers(test_${name} REUSE_FROM rhexis_test_main)
  add_test(NAME ${name} COMMAND test_${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 900)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
  if(ARG_COST)
    set_tests_properties(${name} PROPERTIES COST ${ARG_COST})
  endif()
endfunction()
