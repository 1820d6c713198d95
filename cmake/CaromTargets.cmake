# Compiler options shared by every target, and a library from one or more folders of src/.

function(carom_options target)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  # The same bits everywhere: no contraction into fma behind our back. No errno and no traps, so that sqrt vectorises.
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno -fno-trapping-math
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    # gcc 12 warns of "text" + string (its bug 105329), and of copies of short strings in headers that were precompiled.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>
    $<$<BOOL:${CAROM_WERROR}>:-Werror>)
endfunction()

function(carom_library target)
  set(sources)
  foreach(folder IN LISTS ARGN)
    file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp ${PROJECT_SOURCE_DIR}/src/${folder}/*.hpp)
    list(APPEND sources ${found})
  endforeach()
  if(sources)
    add_library(${target} STATIC ${sources})
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
    carom_options(${target})
  else()
    message(FATAL_ERROR "no sources for ${target}")
  endif()
endfunction()

# For what is built more often than it runs: tests, and the command line. A third less to compile.
function(carom_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Headers that nearly every unit reads, and those given, precompiled: a third less to compile.
function(carom_precompile target)
  target_precompile_headers(${target} PRIVATE <Eigen/Core> <algorithm> <array> <cmath> <functional> <limits> <map>
    <optional> <span> <string> <variant> <vector> ${ARGN})
endfunction()
