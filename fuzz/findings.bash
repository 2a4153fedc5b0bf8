# SPDX-License-Identifier: GPL-3.0-or-later
#
# What becomes of an input on which a fuzz target stopped; for `source` by nightly, whose variables
# it reads: root, build, out, scratch, options.

# The expander and the dialect that a target of two sides tries: "gsk gsk988ta". Nothing for others.
tried_by() {
  case $1 in
    fuzz_*_gsk) echo gsk gsk988ta ;;
    fuzz_*_hnc) echo hnc hnc21t ;;
    fuzz_*_ngc) echo ngc rs274 ;;
    fuzz_*_sinumerik) echo sinumerik sinumerik840d ;;
    fuzz_*_sinumerik802s) echo sinumerik sinumerik802s ;;
  esac
}

# A smaller input on which the target stops, too, when 20,000 inputs show none that is smaller yet.
minimise() {
  local target=$1 input=$2 small=$3
  "$build/fuzz/$target" "${options[@]}" -minimize_crash=1 -runs=20000 -timeout=20 \
    -exact_artifact_path="$small" "$input" >"$small.log" 2>&1 || true
  [ -s "$small" ] || cp "$input" "$small"
}

# The program of the input, reduced by its blocks, as a vector below OUT.
reduce_to_vector() {
  local target=$1 input=$2 expander dialect folder=$scratch/finding
  read -r expander dialect < <(tried_by "$target") || return 0
  rm -rf "$folder"
  mkdir "$folder"
  GONOGO_FUZZ_FINDING=$folder "$build/fuzz/$target" "$input" >/dev/null 2>&1 || true
  [ -s "$folder/program.nc" ] || return 0  # it stopped for another reason
  local subject=${GONOGO_FUZZ_SUBJECT:-builtin:$expander${GONOGO_FUZZ_FAULT:++$GONOGO_FUZZ_FAULT}}
  "${GONOGO:-$root/gonogo}" reduce "$folder/program.nc" --subject "$subject" --dialect "$dialect" \
    --profile "$folder/profile.json" --out "$out/vectors" >"$folder/reduced.nc" 2>"$folder/verdict" ||
    true
  cat "$folder/verdict" "$folder/reduced.nc"
  [ -s "$folder/reduced.nc" ] || return 0
  printf 'the vector again: ./gonogo certify --subject %q --corpus %q\n' "$subject" "$out/vectors"
}

# The input itself stands in the line: a build machine's files are gone when somebody reads it.
report_finding() {
  local target=$1 input=$2 small=$2.small tried=
  minimise "$target" "$input" "$small"
  [ -z "${GONOGO_FUZZ_FAULT:-}" ] || tried="GONOGO_FUZZ_FAULT=$GONOGO_FUZZ_FAULT "
  [ -z "${GONOGO_FUZZ_SUBJECT:-}" ] || tried="GONOGO_FUZZ_SUBJECT=$(printf %q "$GONOGO_FUZZ_SUBJECT") "
  printf '\n%s stops, on %s bytes instead of %s:\n' "$target" "$(stat -c %s "$small")" \
    "$(stat -c %s "$input")"
  reduce_to_vector "$target" "$small"
  printf 'the input again: base64 -d <<<%s >input && %sbuild/fuzz/fuzz/%s input\n\n' \
    "$(base64 -w 0 "$small")" "$tried" "$target"
}
