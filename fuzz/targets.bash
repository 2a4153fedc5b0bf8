# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the scripts of this folder know of the fuzz targets; for `source`. BUILD is a configured build
# folder, in which the list of the targets stands.

fuzz_folder=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)

# target_names BUILD: every target, one a line.
target_names() { cut -d ' ' -f 1 "$1/fuzz/targets.txt"; }

# target_dialect TARGET BUILD: the dialect of NC text ("any": of all of them); nothing where the input
# is no text.
target_dialect() { sed -n "s/^$1 \([^ -]*\) .*/\1/p" "$2/fuzz/targets.txt"; }

# Where an input is a generator's decisions, so many bytes at most: some five blocks. Long programs are
# the soak's; here many short ones find more in the same time.
most_decisions=128

# reads_decisions TARGET BUILD: whether its input is decisions.
reads_decisions() { grep -qx "$1" "$2/fuzz/targets.txt"; }

# target_most_bytes TARGET BUILD: of its inputs.
target_most_bytes() {
  if reads_decisions "$1" "$2"; then
    echo "$most_decisions"
  else
    sed -n "s/^$1 [^ ]* //p" "$2/fuzz/targets.txt"
  fi
}

# write_dictionary TARGET BUILD FILE: of a target that reads NC text, as the target itself writes it.
write_dictionary() { GONOGO_FUZZ_DICTIONARY=1 "$2/fuzz/$1" >"$3"; }

# engine_options TARGET BUILD FOLDER: libFuzzer's options of the target, one a line; its dictionary is
# written into FOLDER. Where an input is decisions, it is long from the beginning (a program of four bytes is
# a head alone), and the entropic schedule is off, which goes over all rare features at each execution
# and takes longer than a short program.
engine_options() {
  local dialect
  printf '%s\n' "-max_len=$(target_most_bytes "$1" "$2")"
  if reads_decisions "$1" "$2"; then
    printf '%s\n' -len_control=0 -entropic=0
    return
  fi
  dialect=$(target_dialect "$1" "$2")
  [ -n "$dialect" ] || return 0
  mkdir -p "$3"
  write_dictionary "$1" "$2" "$3/$1.dict"
  printf '%s\n' "-dict=$3/$1.dict"
}

# copy_seeds TARGET BUILD FOLDER: the target's seeds, and for NC text the short programs of the corpus.
copy_seeds() {
  local dialect
  mkdir -p "$3"
  cp -R "$fuzz_folder/seeds/$1/." "$3"
  dialect=$(target_dialect "$1" "$2")
  [ -z "$dialect" ] ||
    "$fuzz_folder/seed-programs" "$dialect" "$3" "$(target_most_bytes "$1" "$2")" 20
}

# run_stream TARGET BUILD SEED INPUTS FOLDER...: the files of the folders, then so many inputs of a fixed
# stream made of them: the same on every machine and under any load, which an engine that explores is not.
# Where the target stops, the input is in the file GONOGO_FUZZ_INPUT.
run_stream() {
  GONOGO_FUZZ_STREAM="$3 $4 $(target_most_bytes "$1" "$2")" "$2/fuzz/$1" "${@:5}"
}

# pack_target TARGET BUILD OUT: the target as services that fuzz want it: OUT/TARGET with its libraries in OUT/lib,
# for where it runs there may be none but the C library, its seeds, its options, and its dictionary if it has one.
pack_target() {
  local target=$1 build=$2 out=$3 dialect seeds
  mkdir -p "$out/lib"
  cp "$build/fuzz/$target" "$out/$target"
  ldd "$out/$target" | awk -v own="$out/lib/" '$2 == "=>" && $3 ~ /^\// && index($3, own) != 1 {print $3}' |
    { grep -vE '/(libc|libm|libpthread|libdl|librt|libresolv)\.so' || true; } | xargs -r cp -Lt "$out/lib"
  dialect=$(target_dialect "$target" "$build")
  {
    printf '[libfuzzer]\ntimeout = 20\nrss_limit_mb = 2048\nmax_len = %s\n' "$(target_most_bytes "$target" "$build")"
    [ -z "$dialect" ] || printf 'dict = %s.dict\n' "$target"
    printf '\n[asan]\ndetect_stack_use_after_return = 0\n'
  } >"$out/$target.options"
  [ -z "$dialect" ] || write_dictionary "$target" "$build" "$out/$target.dict"
  seeds=$build/seeds/$target
  rm -rf "$seeds" "$out/${target}_seed_corpus.zip"
  copy_seeds "$target" "$build" "$seeds"
  (cd "$seeds" && find . -type f | LC_ALL=C sort | zip -q -X "$out/${target}_seed_corpus.zip" -@)
}
