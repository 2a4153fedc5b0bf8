# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of the installed package share. Usage: . shared.sh; start BUILD_FOLDER
set -u

# A folder of its own in $work, removed at the end; nothing of the caller's environment counts.
start() {
  build=$1
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  failed=0
  count=0
}

# vendor PREFIX COMMAND...: as on a vendor's machine, with the package under PREFIX, whose headers
# the compiler finds as it finds those of /usr.
vendor() {
  local prefix=$1
  shift
  env -i PATH="$prefix/bin:/usr/local/bin:/usr/bin:/bin" HOME="$work" LANG=C.UTF-8 \
    CMAKE_PREFIX_PATH="$prefix" GONOGO_SEED="${GONOGO_SEED-}" \
    C_INCLUDE_PATH="$prefix/include" CPLUS_INCLUDE_PATH="$prefix/include" "$@"
}

# expect CODE WORD COMMAND...: the exit code, and a word of the output (both streams).
expect() {
  local code=$1 word=$2
  shift 2
  "$@" >"$work/out.txt" 2>&1
  local got=$?
  count=$((count + 1))
  if [ "$got" -ne "$code" ] || { [ -n "$word" ] && ! grep -qF -- "$word" "$work/out.txt"; }; then
    echo "FAILED: $* gave $got, must give $code with \"$word\":"
    tail -n 40 "$work/out.txt" | cut -c 1-400
    failed=$((failed + 1))
  fi
}

# judged_at_least N RESULTS: so many cases are GO by a comparison, not by a skip.
judged_at_least() {
  local passed
  passed=$(grep -c '"verdict":"pass' "$2") || passed=0
  [ "$passed" -ge "$1" ] || { echo "only $passed cases were judged"; return 1; }
  echo "judged $passed"
}

# failed_cases RESULTS: the id and the verdict of every case that failed.
failed_cases() {
  sed -n 's/.*"id":"\([^"]*\)".*"verdict":"\(fail[^"]*\)".*/\1 \2/p' "$1"
}

finish() {
  echo "$((count - failed)) passed, $failed failed"
  [ "$failed" -eq 0 ]
}
