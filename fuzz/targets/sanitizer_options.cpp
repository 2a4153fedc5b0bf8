// SPDX-License-Identifier: GPL-3.0-or-later
//
// Defaults of the address sanitizer in the fuzz targets; ASAN_OPTIONS goes before them. The
// grammars throw where a line cannot be read, and with fake stacks each throw costs a sweep over
// all of them, three quarters of the time of fuzz_parse. The tests under the sanitizers keep that
// check.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "detect_stack_use_after_return=0";
}
