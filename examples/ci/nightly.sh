#!/bin/sh
# SPDX-License-Identifier: MIT-0
#
# nightly.sh SUBJECT DIALECT...: what runs in the night. A hunt of each dialect goes on in its folder below
# $GONOGO_CAMPAIGNS (gonogo-campaigns), which the service keeps from night to night, for $GONOGO_TIME (1h), or
# for $GONOGO_PROGRAMS programs a night.
# What is new since the last night stands in $GONOGO_REPORTS (gonogo-reports): DIALECT/issue.md, the text of an
# issue, and DIALECT/results.sarif, junit.xml and index.html. Exits with 1 for a new finding, with 0 when the
# night found none; further options of `gonogo ci batch` may stand in $GONOGO_OPTIONS.
set -u
[ $# -ge 2 ] && [ -n "$1" ] || { echo "usage: nightly.sh SUBJECT DIALECT..." >&2; exit 2; }
subject=$1
shift
campaigns=${GONOGO_CAMPAIGNS:-gonogo-campaigns}
reports=${GONOGO_REPORTS:-gonogo-reports}
bound="--time ${GONOGO_TIME:-1h}"
[ -z "${GONOGO_PROGRAMS-}" ] || bound="--programs $GONOGO_PROGRAMS"
worst=0

# findings CAMPAIGN: their folders.
findings() { for folder in "$1"/*/findings/*/; do [ ! -d "$folder" ] || echo "${folder%/}"; done; }

# tell DIALECT FOLDER...: the issue, and a report of the new findings as cases.
tell() {
  dialect=$1
  shift
  mkdir -p "$reports/$dialect"
  only=
  {
    echo "# $# new in the night: $subject, $dialect"
    for folder; do
      only="$only --only ${folder##*/}"
      printf '\n## %s\n\n```\n' "${folder##*/}"
      cat "$folder/verdict.txt"
      printf '\n```\n\nThe program, under the profile `%s`:\n\n```\n' "$(cat "$folder/profile.json")"
      cat "$folder/program.nc"
      printf '```\n'
    done
  } >"$reports/$dialect/issue.md"
  # shellcheck disable=SC2086 # the options are words
  gonogo certify --subject "$subject" --dialect "$dialect" --corpus "${1%/findings/*}" $only \
    --report "$reports/$dialect" >/dev/null
  [ -z "${GITHUB_STEP_SUMMARY-}" ] || cat "$reports/$dialect/issue.md" >>"$GITHUB_STEP_SUMMARY"
}

for dialect; do
  campaign=$campaigns/$dialect
  before=$(findings "$campaign")
  # shellcheck disable=SC2086 # the options are words
  gonogo ci batch --subject "$subject" --dialect "$dialect" --campaign "$campaign" $bound ${GONOGO_OPTIONS-}
  code=$?
  # 1: findings stand, of this night or one before; anything else is no answer.
  [ "$code" -le 1 ] || { [ "$worst" -eq 1 ] || worst=$code; }
  rm -rf "${reports:?}/$dialect"
  new=$(findings "$campaign" | while read -r folder; do
    case "
$before
" in *"
$folder
"*) ;; *) echo "$folder" ;; esac
  done)
  if [ -n "$new" ]; then
    # shellcheck disable=SC2086 # a folder a word: ids have no blanks
    tell "$dialect" $new
    worst=1
  fi
done
exit "$worst"
