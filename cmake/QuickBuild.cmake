# GONOGO_QUICK_BUILD: what makes a build from clean quicker and nothing else better, for the preset `dev`.
# The other presets compile without it, so that a header that a test forgets is missed there.
if(GONOGO_QUICK_BUILD)
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=gold GONOGO_HAS_GOLD)
  if(GONOGO_HAS_GOLD)
    add_link_options(-fuse-ld=gold)
  endif()
  # g++ looks for what it no longer needs whenever it has grown by a third, a tenth of its time; up to
  # this many kB it does not.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options("SHELL:--param ggc-min-heapsize=1500000")
  endif()
endif()

# Of a test program; what it tests is optimised as ever. g++ 12 sees those warnings in the standard
# library, and behind precompiled headers no longer knows where.
function(gonogo_quick_test name)
  target_compile_options(${name} PRIVATE
    -O0 -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
  if(NOT TARGET gonogo_test_headers)
    file(WRITE ${CMAKE_BINARY_DIR}/precompiled.cpp "int main() {}\n")
    add_executable(gonogo_test_headers ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(gonogo_test_headers PRIVATE
      gonogo_build_settings fmt::fmt GTest::gtest_main rapidcheck)
    target_compile_options(gonogo_test_headers PRIVATE -O0)
    target_precompile_headers(gonogo_test_headers PRIVATE
      <algorithm> <array> <cmath> <cstdint> <cstdio> <cstdlib> <deque> <filesystem> <fstream> <functional>
      <map> <memory> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility>
      <variant> <vector> <fmt/format.h> <gmpxx.h> <gtest/gtest.h> <rapidcheck/gtest.h>)
  endif()
  # Its macro stands in the headers.
  target_link_libraries(${name} PRIVATE fmt::fmt)
  target_precompile_headers(${name} REUSE_FROM gonogo_test_headers)
endfunction()
