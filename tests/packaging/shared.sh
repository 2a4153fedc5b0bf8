# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of the packages share. Usage: . shared.sh BUILD_FOLDER
. "$(dirname "${BASH_SOURCE[0]}")/../vendor/shared.sh"
start "$1"
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
packages=$build/packaging/packages
mkdir "$work/home"
[ -d "$packages" ] || { echo "SKIPPED: packaging.build has made no packages"; exit 0; }

# package PATTERN: the one file of the packages that matches.
package() {
  local found=("$packages"/$1)
  [ ${#found[@]} -eq 1 ] && [ -f "${found[0]}" ] || { echo "FAILED: no $1 in $packages"; exit 1; }
  echo "${found[0]}"
}

# stranger COMMAND...: with nothing of the caller's environment, and no network where that can be had.
stranger() {
  env -i PATH="${extra_path:-}/usr/local/bin:/usr/bin:/bin" HOME="$work/home" LANG=C.UTF-8 "$@"
}
