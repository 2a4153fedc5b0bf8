# libFuzzer without a main function, which clang brings along. It is written in C++ on libstdc++, so that g++ links it,
# too. GONOGO_LIBFUZZER: the archive; where there is none, `gonogo fuzz` says so and all else is there.
find_program(GONOGO_CLANG NAMES clang-19 clang)
mark_as_advanced(GONOGO_CLANG)
set(libfuzzer libclang_rt.fuzzer_no_main-${CMAKE_SYSTEM_PROCESSOR}.a)
file(GLOB llvm_folders /usr/lib/llvm-*/lib/clang/*/lib/linux)
list(SORT llvm_folders COMPARE NATURAL ORDER DESCENDING)
find_file(GONOGO_LIBFUZZER ${libfuzzer} PATHS ${llvm_folders} NO_DEFAULT_PATH)
if(NOT GONOGO_LIBFUZZER AND GONOGO_CLANG)
  execute_process(COMMAND ${GONOGO_CLANG} -print-file-name=${libfuzzer}
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  # The bare name where there is none.
  if(IS_ABSOLUTE "${found}" AND EXISTS "${found}")
    set_property(CACHE GONOGO_LIBFUZZER PROPERTY VALUE ${found})
  endif()
endif()

if(GONOGO_LIBFUZZER)
  # Named, since the engine is asked for where it may be missing; and seen by libraries that are loaded.
  set(GONOGO_LIBFUZZER_LINK_OPTIONS -Wl,-u,LLVMFuzzerRunDriver
    "-Wl,--export-dynamic-symbol=__sanitizer_cov_*" -Wl,--export-dynamic-symbol=__sancov_lowest_stack)
  add_library(gonogo_external_libfuzzer INTERFACE)
  target_link_options(gonogo_external_libfuzzer INTERFACE ${GONOGO_LIBFUZZER_LINK_OPTIONS})
  target_link_libraries(gonogo_external_libfuzzer INTERFACE ${GONOGO_LIBFUZZER} Threads::Threads)
else()
  message(STATUS "No gonogo fuzz: there is no libclang_rt.fuzzer_no_main of clang")
endif()
