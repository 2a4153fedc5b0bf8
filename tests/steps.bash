# SPDX-License-Identifier: GPL-3.0-or-later
#
# The steps of a test run and what each took; for `source` by run-all, whose folder `times` it writes.
# build/test-times/steps has a line a step: its name, seconds on the clock, seconds of the processors.

# What starts whole programs or goes through the corpus; by the labels of ctest.
whole_runs='browser|peers|packaging|playground|cluster|end-to-end|e2e|faults-injected|documents|vendor|helpers|fuzz-build|fuzz-replay|corpus'

mkdir -p "$times"
rm -f "$times"/*
step_name=

end_step() {
  [ -n "$step_name" ] || return 0
  # Not in a subshell: what it waited for is no part of a subshell's times.
  times >"$times/clock"
  local processors
  processors=$(awk -F '[ms ]+' 'NR <= 2 {sum += 60 * $1 + $2 + 60 * $3 + $4} END {print sum}' "$times/clock")
  rm "$times/clock"
  printf '%s\t%d\t%.0f\n' "$step_name" $((SECONDS - step_began)) \
    "$(awk "BEGIN {print $processors - $step_processors}")" >>"$times/steps"
  step_processors=$processors
  step_name=
}
step_processors=0

# step NAME: ends the step before and begins this one.
step() {
  end_step
  step_name=$1
  step_began=$SECONDS
  printf '\n== %s (%d:%02d)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60))
}

# beside NAME COMMAND...: begins what a later step will `take`, on what the steps before it leave of the processors.
beside() {
  setsid nice -n 19 "${@:2}" >"$times/$1.log" 2>&1 &
  beside_ids[$1]=$!
}
declare -A beside_ids=()
# Each is a group of its own, so that what it started ends with it.
trap 'for id in "${beside_ids[@]}"; do kill -- "-$id" 2>/dev/null || true; done' EXIT

# take NAME: waits for it, prints what it said, and answers as it did.
take() {
  local answer=0
  wait "${beside_ids[$1]}" || answer=$?
  unset "beside_ids[$1]"
  cat "$times/$1.log"
  return $answer
}

# Ends the last step and prints the table.
end_steps() {
  end_step
  printf '\n== all done (%d:%02d)\n' $((SECONDS / 60)) $((SECONDS % 60))
  tests/times "$times" | tee "$times/table"
}
