# Language, warnings, sanitizers and the folder-to-target helper.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Dev: optimised enough to be quick, with every check on, and lines for backtraces: what a debugger wants
# beyond them (-g) is a third of the compiler's time. Release keeps assertions too
# (no NDEBUG): CGAL's own checks are part of the oracle's answer.
set(CMAKE_CXX_FLAGS_DEV "-O1 -g1" CACHE STRING "Flags of the Dev build type" FORCE)
set(CMAKE_C_FLAGS_DEV "-O1 -g1" CACHE STRING "Flags of the Dev build type" FORCE)
set(CMAKE_CXX_FLAGS_RELEASE "-O2" CACHE STRING "Flags of the Release build type" FORCE)
set(CMAKE_C_FLAGS_RELEASE "-O2" CACHE STRING "Flags of the Release build type" FORCE)
# Fuzz: the sanitizers' checks of optimised code cost half; line tables are what their reports need.
set(CMAKE_CXX_FLAGS_FUZZ "-O2 -gline-tables-only" CACHE STRING "Flags of the Fuzz build type" FORCE)
set(CMAKE_C_FLAGS_FUZZ "-O2 -gline-tables-only" CACHE STRING "Flags of the Fuzz build type" FORCE)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)

# The headers of the standard library, of Boost and of CGAL cost far more than our own text. Names in
# anonymous namespaces are therefore distinct within a target. A file that is changed costs those with
# which it is compiled: fewer where people work, more where all is built from clean.
set(CMAKE_UNITY_BUILD ${GONOGO_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE ${GONOGO_UNITY_FILES})

# g++ looks for what it no longer needs whenever it has grown by a third, a tenth of its time; up to
# this many kB it does not.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options("SHELL:$<$<COMPILE_LANGUAGE:CXX>:--param ggc-min-heapsize=600000>")
endif()

find_program(GONOGO_CCACHE ccache)
if(GONOGO_CCACHE)
  # ccache takes the list of a source's headers from the compiler: to preprocess every source first costs a tenth of
  # a build from clean. Nothing in the precompiled headers of the tests hangs on the time of day.
  set(GONOGO_LAUNCHER env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
    CCACHE_SLOPPINESS=pch_defines,time_macros ${GONOGO_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${GONOGO_LAUNCHER})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GONOGO_LAUNCHER})
endif()

add_library(gonogo_build_settings INTERFACE)
target_compile_options(gonogo_build_settings INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion
  $<$<BOOL:${GONOGO_WERROR}>:-Werror>
  # One value of an expression on every machine: no fused multiply-add.
  -ffp-contract=off)
if(GONOGO_SANITIZE)
  target_compile_options(gonogo_build_settings INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gonogo_build_settings INTERFACE -fsanitize=address,undefined)
endif()

# What a fuzzer sees: which branches the grammar, the reference and the expanders take, and in the
# grammar, whose input is the fuzzer's text, what they compare with. The judge only follows the two
# sides; what it takes of the counters says nothing new and costs as much again. So do the branches of
# the exact numbers, which are taken hundreds of times a program.
function(gonogo_instrument_for_fuzzing name folder)
  if(NOT (GONOGO_FUZZ AND GONOGO_FUZZ_INSTRUMENTATION))
    return()
  endif()
  if(folder MATCHES "^grammar(/|$)")
    target_compile_options(gonogo_${name} PRIVATE -fsanitize=fuzzer-no-link)
  elseif(folder MATCHES "^(reference|expanders)(/|$)" AND NOT name STREQUAL "exact")
    target_compile_options(gonogo_${name} PRIVATE
      -fsanitize-coverage=inline-8bit-counters,pc-table)
  endif()
endfunction()

# What a fuzz build takes from the release build beside it (GONOGO_FUZZ_RELEASED): target TARGET there makes ARCHIVE.
function(gonogo_take_released target archive)
  set_property(GLOBAL APPEND PROPERTY GONOGO_RELEASED_TARGETS ${target})
  set_property(GLOBAL APPEND PROPERTY GONOGO_RELEASED_ARCHIVES ${archive})
endfunction()
# That build brings them up to date itself, so that nothing here is linked with older ones.
function(gonogo_build_released)
  get_property(targets GLOBAL PROPERTY GONOGO_RELEASED_TARGETS)
  get_property(archives GLOBAL PROPERTY GONOGO_RELEASED_ARCHIVES)
  add_custom_target(gonogo_released_archives
    COMMAND ${CMAKE_COMMAND} --build ${GONOGO_FUZZ_RELEASED} --target ${targets} -- --quiet
    BYPRODUCTS ${archives} VERBATIM)
endfunction()

# Rooms that decide no verdict spend their time in the rooms below and in the subject: to optimise them less saves a
# quarter of their compiler's time. Under the sanitizers, whose checks are most of the code, those in which the tests
# spend next to no time are not optimised at all, which saves three fifths.
function(gonogo_optimise_less name folder)
  if(folder MATCHES "^(cli|publish|campaign|capture|checker|corpus|subjects|fuzz/(hunt|identify))(/|$)")
    target_compile_options(gonogo_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(folder MATCHES "^(cli|publish|capture|fuzz/(hunt|identify))(/|$)")
    target_compile_options(gonogo_${name} PRIVATE $<$<CONFIG:Fuzz>:-O0>)
  endif()
endfunction()

# gonogo_folder(NAME SOURCES...): the static library of one folder of the house. Those of grammar
# and reference up to what is published are what `gonogo::oracle` of the installed package consists of.
# With GONOGO_FUZZ_RELEASED, what reads nothing of a stranger's and is no target's subject is that build's library. None
# of it may use nlohmann's ordered JSON: g++ and clang give its objects another size.
function(gonogo_folder name)
  file(RELATIVE_PATH folder ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  if(GONOGO_FUZZ_RELEASED AND folder MATCHES "^(fuzz/(generate|relations)|publish/manual)(/|$)")
    file(WRITE ${CMAKE_BINARY_DIR}/released.cpp "")
    add_library(gonogo_${name} STATIC ${CMAKE_BINARY_DIR}/released.cpp)
    set(archive ${GONOGO_FUZZ_RELEASED}/${folder}/libgonogo_${name}.a)
    target_link_libraries(gonogo_${name} PUBLIC ${archive})
    gonogo_take_released(gonogo_${name} ${archive})
  else()
    add_library(gonogo_${name} STATIC ${ARGN})
  endif()
  add_library(gonogo::${name} ALIAS gonogo_${name})
  target_link_libraries(gonogo_${name} PUBLIC $<BUILD_INTERFACE:gonogo_build_settings>)
  target_include_directories(gonogo_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}> $<INSTALL_INTERFACE:include/gonogo-oracle>)
  gonogo_instrument_for_fuzzing(${name} ${folder})
  gonogo_optimise_less(${name} ${folder})
  if(folder MATCHES "^((grammar|reference|oracle|subjects|campaign|capture|publish|corpus/io)(/|$)|fuzz/program$)")
    set_property(GLOBAL APPEND PROPERTY GONOGO_ORACLE_FOLDERS ${name})
  endif()
endfunction()
