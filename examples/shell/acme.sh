#!/bin/sh
# SPDX-License-Identifier: MIT-0
#
# A subject in one awk program: lines such as `G1 X10 Y-2.5 F100` in millimetres, absolute, the words
# in this order, until one is M2. Without M2 the last line alarms: exit 1. Any other line, or a profile
# that is not the default one, is not supported: exit 3.
# It is called as: acme.sh --dialect rs274 --profile FILE.json
[ "$(cat "$4")" = "{}" ] || exit 3
exec awk '
BEGIN { n = "-?[0-9]+([.][0-9]+)?"; word = "^(G0|G1)( X" n ")?( Y" n ")?( Z" n ")?( F[1-9][0-9]*)?$" }
NF == 0 { next }
$0 == "M2" { printf "{\"k\":\"m\",\"b\":%d,\"m\":2}\n", NR; ended = 1; exit 0 }
NF == 1 || $0 !~ word || /^G0/ == /F/ || $2 ~ /F/ { ended = 1; exit 3 }
{ to = ""; feed = ""
  for (i = 2; i <= NF; i++) {
    value = "\"" substr($i, 2) "\""
    if ($i ~ /F/) feed = ",\"f\":" value
    else to = to (to == "" ? "" : ",") "\"" tolower(substr($i, 1, 1)) "\":" value }
  printf "{\"k\":\"%s\",\"b\":%d,\"to\":{%s}%s}\n", feed == "" ? "rapid" : "feed", NR, to, feed }
END {
  if (ended) exit  # with the status that it has
  printf "{\"k\":\"alarm\",\"class\":\"program-end\",\"b\":%d}\n", (NR > 0 ? NR : 1)
  exit 1 }'
