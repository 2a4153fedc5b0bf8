// SPDX-License-Identifier: GPL-3.0-or-later
//
// Defaults of the address sanitizer in the fuzz targets; ASAN_OPTIONS goes before them. The
// grammars throw where a line cannot be read, and with fake stacks each throw costs a sweep over
// all of them, three quarters of the time of fuzz_parse. The tests under the sanitizers keep that
// check. One caller of an allocation is kept, which saves a quarter of the differential targets'
// time; ASAN_OPTIONS=malloc_context_size=30 shows the others when an input is run again.
// Freed memory waits until 1 MiB more is freed, that of some ten executions, which stays in the
// processor's caches as the default of 256 would not; and of a new block the first 256 bytes are
// filled.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "detect_stack_use_after_return=0:malloc_context_size=1:quarantine_size_mb=1:thread_local_"
         "quarantine_size_kb=256:"
         "max_malloc_fill_size=256";
}
