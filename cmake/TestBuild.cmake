# How a test program is built: what it tests is optimised as ever, its own text hardly (under the sanitizers, whose
# checks are most of it, not at all: two fifths of the compiler's time), and the headers that nearly every test has are
# compiled once. clang-tidy reads the tests without them (GONOGO_TEST_HEADERS=OFF), so that a header that a test
# forgets is missed there.
option(GONOGO_TEST_HEADERS "Precompiled headers for the tests" ON)

include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold GONOGO_HAS_MOLD)
if(GONOGO_HAS_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

set(GONOGO_TEST_OPTIONS $<IF:$<CONFIG:Fuzz>,-O0,-Og>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # g++ 12 sees these in the standard library, and behind precompiled headers no longer knows where.
  list(APPEND GONOGO_TEST_OPTIONS
    -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
endif()

function(gonogo_test_program name)
  target_compile_options(${name} PRIVATE ${GONOGO_TEST_OPTIONS})
  if(NOT GONOGO_TEST_HEADERS)
    return()
  endif()
  if(NOT TARGET gonogo_test_headers)
    file(WRITE ${CMAKE_BINARY_DIR}/precompiled.cpp "int main() {}\n")
    add_executable(gonogo_test_headers ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(gonogo_test_headers PRIVATE
      gonogo_build_settings fmt::fmt GTest::gtest_main rapidcheck)
    target_compile_options(gonogo_test_headers PRIVATE ${GONOGO_TEST_OPTIONS})
    if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
      # The time of a header's file is no part of it, else no cache knows it again.
      target_compile_options(gonogo_test_headers PUBLIC "SHELL:-Xclang -fno-pch-timestamp")
    endif()
    target_precompile_headers(gonogo_test_headers PRIVATE
      <algorithm> <array> <cmath> <cstdint> <cstdio> <cstdlib> <deque> <filesystem> <fstream> <functional>
      <map> <memory> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility>
      <variant> <vector> <fmt/format.h> <gmpxx.h> <gtest/gtest.h> <rapidcheck/gtest.h>)
  endif()
  # Its macro stands in the headers.
  target_link_libraries(${name} PRIVATE fmt::fmt)
  target_precompile_headers(${name} REUSE_FROM gonogo_test_headers)
endfunction()
