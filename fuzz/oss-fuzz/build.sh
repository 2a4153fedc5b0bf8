#!/bin/bash -eu
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the fuzz targets as OSS-Fuzz and ClusterFuzzLite ask for it, and anybody else who sets the
# same variables:
#   CC CXX CFLAGS CXXFLAGS   the compilers, with sanitizer and coverage in the flags
#   LIB_FUZZING_ENGINE       -fsanitize=fuzzer, or the path of a library, or several words
#   OUT                      where the targets go, with NAME_seed_corpus.zip, NAME.dict, NAME.options
#                            and the libraries that they need in OUT/lib
#   SRC                      the folder above the checkout `gonogo`; without it this checkout is built
#   WORK                     for objects; OUT/../work without it
#   FUZZ_TARGETS             which targets to build; all of them without it
# A second run with other flags needs another WORK.
set -o pipefail
: "${CC:?}" "${CXX:?}" "${LIB_FUZZING_ENGINE:?}" "${OUT:?}"
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
[ ! -f "${SRC:-}/gonogo/fuzz/targets.bash" ] || root=$SRC/gonogo
mkdir -p "$OUT/lib"
OUT=$(cd -- "$OUT" && pwd)
work=${WORK:-$OUT/../work}/gonogo-fuzz
mkdir -p "$work"

# The libraries are the distribution's, which are built for libstdc++.
export CFLAGS=${CFLAGS:-} CXXFLAGS=${CXXFLAGS:-}
CXXFLAGS=${CXXFLAGS//-stdlib=libc++/}

cmake -G Ninja -S "$root" -B "$work" -DCMAKE_BUILD_TYPE=None -DGONOGO_TESTS=OFF -DGONOGO_FUZZ=ON \
  -DGONOGO_FUZZ_INSTRUMENTATION=OFF -DGONOGO_FUZZ_ENGINE="$LIB_FUZZING_ENGINE" \
  -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" \
  -DCMAKE_BUILD_RPATH="\$ORIGIN/lib" -DCMAKE_BUILD_RPATH_USE_ORIGIN=ON
source "$root/fuzz/targets.bash"
read -ra targets <<<"${FUZZ_TARGETS:-$(target_names "$work" | tr '\n' ' ')}"
cmake --build "$work" --target "${targets[@]}"

for target in "${targets[@]}"; do pack_target "$target" "$work" "$OUT"; done
