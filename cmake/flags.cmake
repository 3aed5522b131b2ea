# One INTERFACE target carries every flag: croquis_flags.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CROQUIS_CCACHE ccache)
if(CROQUIS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # The sloppiness is what ccache asks for to work with precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=1
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${CROQUIS_CCACHE})
endif()

add_library(croquis_flags INTERFACE)
target_include_directories(croquis_flags INTERFACE ${PROJECT_SOURCE_DIR}/engine)
# One rounding on every machine: no fused multiply-add unless a file asks for it.
target_compile_options(croquis_flags INTERFACE -ffp-contract=off)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(croquis_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Eigen's fixed-size code, and the string operator+ of g++ 12 itself, trip these at -O2 and above.
    target_compile_options(croquis_flags INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overread
                           -Wno-stringop-overflow -Wno-restrict)
  endif()
endif()

# On for the fuzzers' sake in the whole build: instrumenting twice would mean compiling twice.
if(CROQUIS_FUZZERS)
  target_compile_options(croquis_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

set(CROQUIS_SANITIZE "" CACHE STRING "Sanitizers, such as address,undefined")
if(CROQUIS_SANITIZE)
  target_compile_options(croquis_flags INTERFACE -fsanitize=${CROQUIS_SANITIZE} -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(croquis_flags INTERFACE -fsanitize=${CROQUIS_SANITIZE})
endif()

if(EMSCRIPTEN)
  # Wasm exceptions must be on at every compile and link step. SSE intrinsics map to wasm SIMD; the shim makes Eigen
  # take that road (it knows no wasm of its own).
  add_compile_options(-fwasm-exceptions -msimd128 -msse -msse2 -msse3 -mssse3 -msse4.1
                      -I${PROJECT_SOURCE_DIR}/cmake/wasm "SHELL:-isystem ${PROJECT_BINARY_DIR}/host-headers/eigen3"
                      "SHELL:-include ${PROJECT_SOURCE_DIR}/cmake/wasm/eigen_simd.h")
  add_link_options(-fwasm-exceptions -sALLOW_MEMORY_GROWTH)
  # Debian's emcc looks for acorn where only Debian's own node looks by itself.
  set(CMAKE_CXX_LINKER_LAUNCHER env NODE_PATH=/usr/share/nodejs)
  # /usr/include holds glibc's headers and may never be on a wasm include path: link the header-only libraries alone.
  set(host_headers ${PROJECT_BINARY_DIR}/host-headers)
  file(MAKE_DIRECTORY ${host_headers})
  foreach(library IN ITEMS nlohmann stb eigen3)
    file(CREATE_LINK /usr/include/${library} ${host_headers}/${library} SYMBOLIC)
  endforeach()
  add_library(Eigen3::Eigen INTERFACE IMPORTED)
  target_include_directories(Eigen3::Eigen SYSTEM INTERFACE ${host_headers}/eigen3)
  add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
  target_include_directories(nlohmann_json::nlohmann_json SYSTEM INTERFACE ${host_headers})
else()
  find_package(Eigen3 3.4 REQUIRED NO_MODULE)
  find_package(nlohmann_json 3.11 REQUIRED)
endif()

# Eigen takes two seconds to read: every target reads it precompiled (the standard library's heavy headers with it).
file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
add_library(croquis_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(croquis_precompiled PRIVATE croquis_flags Eigen3::Eigen)
target_precompile_headers(croquis_precompiled PRIVATE
                          <Eigen/Core> <Eigen/Geometry> <algorithm> <functional> <map> <memory> <optional> <span>
                          <string> <string_view> <vector>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(croquis_flags INTERFACE -fpch-preprocess)
else()
  target_compile_options(croquis_flags INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
endif()
