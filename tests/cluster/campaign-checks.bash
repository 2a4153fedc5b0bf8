# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of campaigns in shards have in common. To be sourced.

# fail SENTENCE FILE...: says it, shows the ends of the files and ends the test.
fail() {
  echo "FAILED: $1"
  shift
  [ $# -eq 0 ] || tail -n 20 -- "$@"
  exit 1
}

footer_sha256() { tail -n 1 -- "$1" | grep -oE '"sha256": ?"[0-9a-f]{64}"'; }
case_ids() { grep -oE '^\{"id": ?"[^"]+"' -- "$1"; }

# journal_lines FOLDER SHARD: how many lines the journals of its attempts have.
journal_lines() { cat "$1/attempts/shard-$2".*/results.jsonl.part 2>/dev/null | wc -l; }
# starts FOLDER: how often a shard was begun from nothing.
starts() { cat "$1"/logs/shard-*.log | grep -c ': starts$'; }

# The case lines without what differs from run to run.
without_timing() {
  sed -E 's/,"us":[0-9]+,"attempts":[0-9]+(,"notes":"([^"\\]|\\.)*")?//' -- "$1" | grep '^{"id"'
}

# same_results WHOLE MERGED: the same hash over all case lines, and no case lost or counted twice.
same_results() {
  [ "$(case_ids "$1" | wc -l)" -gt 100 ] || fail "$1 has hardly any cases"
  [ -z "$(case_ids "$2" | sort | uniq -d)" ] || fail "a case is counted twice in $2"
  diff <(case_ids "$1") <(case_ids "$2") >/dev/null || fail "cases are lost or counted twice in $2"
  footer_sha256 "$1" >/dev/null || fail "$1 has no hash"
  [ "$(footer_sha256 "$1")" = "$(footer_sha256 "$2")" ] || {
    diff <(without_timing "$1") <(without_timing "$2")
    fail "the hashes of $1 and $2 differ"
  }
}
