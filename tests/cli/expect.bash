# SPDX-License-Identifier: GPL-3.0-or-later
#
# For `source` by the scripts of this folder: `gonogo` is the program, $1 of the script; it goes on in a
# folder of its own, `work`, which is removed in the end.
set -u
gonogo=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0
count=0

# expect CODE WORD COMMAND...: runs it; the output (both streams) must hold WORD.
expect() {
  local code=$1 word=$2
  shift 2
  "$@" >out.txt 2>&1
  local got=$?
  count=$((count + 1))
  if [ "$got" -ne "$code" ] || ! grep -qF -- "$word" out.txt; then
    echo "FAILED: $* gave $got, must give $code with \"$word\":"
    tail -c 1500 out.txt
    failed=$((failed + 1))
  fi
}

# The last line of a script.
finish() {
  echo "$((count - failed)) passed, $failed failed"
  [ "$failed" -eq 0 ]
}
