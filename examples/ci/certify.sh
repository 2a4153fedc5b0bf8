#!/bin/sh
# SPDX-License-Identifier: MIT-0
#
# certify.sh SUBJECT DIALECT...: what a continuous integration runs. The report of each dialect goes
# to $GONOGO_REPORTS (gonogo-reports), the summary to the job's page where there is one. Exits with 0
# only when every dialect is GO; further options of `gonogo certify` may stand in $GONOGO_OPTIONS.
set -u
[ $# -ge 2 ] && [ -n "$1" ] || { echo "usage: certify.sh SUBJECT DIALECT..." >&2; exit 2; }
subject=$1
shift
reports=${GONOGO_REPORTS:-gonogo-reports}
worst=0
for dialect; do
  # shellcheck disable=SC2086 # the options are words
  gonogo certify --subject "$subject" --dialect "$dialect" --report "$reports/$dialect" ${GONOGO_OPTIONS-}
  code=$?
  [ "$code" -eq 0 ] || [ "$worst" -eq 1 ] || worst=$code
  if [ -n "${GITHUB_STEP_SUMMARY-}" ] && [ -f "$reports/$dialect/summary.md" ]; then
    cat "$reports/$dialect/summary.md" >>"$GITHUB_STEP_SUMMARY"
  fi
done
exit "$worst"
