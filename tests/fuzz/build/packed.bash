# SPDX-License-Identifier: GPL-3.0-or-later
#
# For `source` by what has a function `fail`.

# check_packed TARGET OUT SEEDS: what pack_target of fuzz/targets.bash leaves is whole, and needs no library outside.
check_packed() {
  local target=$1 out=$2 seeds=$3 file outside
  for file in "$target" "$target.dict" "$target.options" "${target}_seed_corpus.zip"; do
    [ -s "$out/$file" ] || fail "$file is missing"
  done
  grep -q "^dict = $target.dict$" "$out/$target.options" || fail "the options name no dictionary"
  outside=$(ldd "$out/$target" | awk '$2 == "=>" {print $3}' |
    grep -vE "^$(realpath "$out")/lib/|/lib(c|m|pthread|dl|rt|resolv)\.so" || true)
  [ -z "$outside" ] || fail "libraries outside the folder: $outside"
  rm -rf "$seeds"
  unzip -q "$out/${target}_seed_corpus.zip" -d "$seeds" || fail "the seeds cannot be unpacked"
  [ "$(find "$seeds" -type f | wc -l)" -gt 100 ] || fail "there are hardly any seeds"
}
