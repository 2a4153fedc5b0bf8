# SPDX-License-Identifier: GPL-3.0-or-later
#
# What `fuzz/coverage` and `tests/coverage` have in common; for `source` from the root.

# need_tools TOOL...: exits 2 where one is missing.
need_tools() {
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || { echo "coverage: $tool is missing: cmake/install-packages fuzz" >&2; exit 2; }
  done
}

# configure_coverage BUILD [OPTION...]: the preset `coverage`, with options of cmake.
configure_coverage() {
  local build=$1
  shift
  mkdir -p "$build"
  cmake --preset coverage "$@" >"$build/configure.log" 2>&1 || { cat "$build/configure.log" >&2; exit 1; }
}

# report_coverage COUNTS OUT LEFT_OUT [OPTION...] -- BINARY...: adds up COUNTS/*.profraw of these programs,
# but for the folders LEFT_OUT ("build|tests"); prints the table of coverage-summary with its OPTIONs, and leaves
# it in OUT/summary.txt, and index.html line by line. Then the words of llvm-cov are in `view`, and `enough`
# is empty where coverage-summary says so.
report_coverage() {
  local counts=$1 out=$2 left_out=$3 root=$PWD options=()
  shift 3
  while [ "$1" != -- ]; do options+=("$1"); shift; done
  shift
  llvm-profdata-19 merge -sparse -o "$counts/all.profdata" "$counts"/*.profraw
  enough=yes
  # The first program needs no -object before it.
  view=("$1" "-instr-profile=$counts/all.profdata" "-ignore-filename-regex=^/usr/|^$root/($left_out)/")
  shift
  local binary
  for binary in "$@"; do view+=(-object "$binary"); done
  llvm-cov-19 export -summary-only "${view[@]}" >"$counts/summary.json"
  fuzz/coverage-summary "$root" "$counts/summary.json" "${options[@]}" | tee "$out/summary.txt" || enough=''
  llvm-cov-19 show -format=html -output-dir="$out" "${view[@]}" >/dev/null
  echo "line by line: $out/index.html"
}
