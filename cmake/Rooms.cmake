# One folder at the top is one room is one library, scanchor_<room>.
add_library(scanchor_flags INTERFACE)
target_compile_features(scanchor_flags INTERFACE cxx_std_20)
# No contraction into fused multiply-add: the same bytes on every machine.
target_compile_options(scanchor_flags INTERFACE -ffp-contract=off)
add_library(scanchor_warnings INTERFACE)
# -Wrestrict: GCC 12 warns of std::string's own operator+ (GCC bug 105651).
# -Wmaybe-uninitialized: it takes Eigen's fixed-size storage, which is uninitialised by design, for a fault. The others speak of
# system headers again once those are precompiled.
target_compile_options(scanchor_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized -Wno-stringop-overread -Wno-stringop-overflow
  -Wno-array-bounds>)
target_compile_options(scanchor_warnings INTERFACE -Wall -Wextra
                       $<$<NOT:$<BOOL:$<TARGET_PROPERTY:SCANCHOR_SHARES_HELPERS>>>:-Wshadow> -Wnon-virtual-dtor -Wcast-align
                       $<$<BOOL:${SCANCHOR_WARNINGS_AS_ERRORS}>:-Werror>)
if(SCANCHOR_SANITIZE)
  target_compile_options(scanchor_flags INTERFACE -fsanitize=${SCANCHOR_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  target_link_options(scanchor_flags INTERFACE -fsanitize=${SCANCHOR_SANITIZE})
endif()
set_property(GLOBAL PROPERTY SCANCHOR_ROOMS "")

# Half of the time of a small translation unit is reading Eigen and the standard library. Read them once for all targets of one
# kind (rooms, rooms at -O3, tests). The owner of what is precompiled has no definitions of its own: those would have to be the
# users' as well. OPTIONS are the compiler's, HEADERS come on top of the common ones, LINKS are where they are found.
function(scanchor_precompile target kind)
  cmake_parse_arguments(PRECOMPILE "" "" "OPTIONS;HEADERS;LINKS" ${ARGN})
  target_compile_options(${target} PRIVATE ${PRECOMPILE_OPTIONS})
  if(NOT SCANCHOR_PRECOMPILE)
    return()
  endif()
  set(owner scanchor_precompiled_${kind})
  if(NOT TARGET ${owner})
    file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/precompiled/${kind}.cpp CONTENT "")
    add_library(${owner} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${kind}.cpp)
    target_link_libraries(${owner} PRIVATE Eigen3::Eigen fmt::fmt Threads::Threads scanchor_flags scanchor_warnings
                          ${PRECOMPILE_LINKS})
    target_compile_options(${owner} PRIVATE ${PRECOMPILE_OPTIONS})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      # Position independent as an executable is, which CMake does not give to a library.
      set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
      target_compile_options(${owner} PRIVATE -fPIE)
    endif()
    target_precompile_headers(${owner} PRIVATE
      <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <string> <variant> <vector>
      <Eigen/Core> <Eigen/Geometry> ${PRECOMPILE_HEADERS})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

# Most of the time of a file of this tree is its headers and the templates that it takes from them, many files the same ones.
# COUNT files are one unit: two to four cores stay busy, and no unit needs more than about 2 GB.
function(scanchor_unity target count)
  if(SCANCHOR_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE BATCH UNITY_BUILD_BATCH_SIZE ${count})
  endif()
endfunction()

function(scanchor_room name)
  cmake_parse_arguments(ROOM "" "" "USES;LINKS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.hpp)
  if(name STREQUAL "results")
    # The context is a file, not an #ifdef: gl_context_{osmesa,egl,none}.cpp, of which one is built.
    list(FILTER sources EXCLUDE REGEX "gl_context_(osmesa|egl|none)\\.cpp$")
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/results/gl_context_${SCANCHOR_GL_CONTEXT}.cpp)
      list(APPEND sources ${CMAKE_CURRENT_SOURCE_DIR}/results/gl_context_${SCANCHOR_GL_CONTEXT}.cpp)
    endif()
  endif()
  if(NOT sources)
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}_empty.cpp "")
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/${name}_empty.cpp)
  endif()
  add_library(scanchor_${name} STATIC ${sources})
  add_library(scanchor::${name} ALIAS scanchor_${name})
  set_target_properties(scanchor_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(scanchor_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/scanchor>)
  list(TRANSFORM ROOM_USES PREPEND scanchor_)
  target_link_libraries(scanchor_${name} PUBLIC ${ROOM_USES} Eigen3::Eigen)
  target_link_libraries(scanchor_${name} PRIVATE
    ${ROOM_LINKS} nlohmann_json::nlohmann_json fmt::fmt Threads::Threads $<BUILD_INTERFACE:scanchor_warnings>)
  target_link_libraries(scanchor_${name} PUBLIC $<BUILD_INTERFACE:scanchor_flags>)
  target_compile_features(scanchor_${name} PUBLIC cxx_std_20)
  scanchor_unity(scanchor_${name} 18)
  if(name MATCHES "^(sim|sensors|perception)$")
    scanchor_precompile(scanchor_${name} fast OPTIONS $<$<CONFIG:Release>:-O3>)
  else()
    scanchor_precompile(scanchor_${name} room)
  endif()
  set_property(GLOBAL APPEND PROPERTY SCANCHOR_ROOMS ${name})
endfunction()

function(scanchor_command folder)
  cmake_parse_arguments(ROOM "" "" "USES;LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(scanchor ${sources})
  target_include_directories(scanchor PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  list(TRANSFORM ROOM_USES PREPEND scanchor_)
  target_link_libraries(scanchor PRIVATE ${ROOM_USES} ${ROOM_LINKS} nlohmann_json::nlohmann_json fmt::fmt
                        scanchor_warnings)
  target_compile_definitions(scanchor PRIVATE SCANCHOR_VERSION="${PROJECT_VERSION}")
  scanchor_unity(scanchor 13)
  # Reading arguments is not worth optimising.
  scanchor_precompile(scanchor command OPTIONS $<$<CONFIG:Release>:-O1>
                      HEADERS <CLI/CLI.hpp> <nlohmann/json.hpp> <fmt/format.h>
                      LINKS CLI11::CLI11 nlohmann_json::nlohmann_json)
  set_target_properties(scanchor PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
endfunction()
