#!/bin/bash -eu
# SPDX-License-Identifier: GPL-3.0-or-later
exec "$SRC/gonogo/fuzz/oss-fuzz/build.sh"
