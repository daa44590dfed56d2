#!/usr/bin/env bash
# Fails unless a program is position independent, its relocations are read only from the start, its stack is no code,
# and functions with arrays and calls with known sizes are checked.
# usage: check.sh PROGRAM CONFIGURATION     calls are checked in Release only
set -uo pipefail
program=$1
facts=$(readelf --wide --file-header --program-headers --dynamic --dyn-syms "$program") || exit 1
failed=0
expect() { # NAME PATTERN
  grep -qE "$2" <<<"$facts" || { echo "$program: $1 is missing"; failed=1; }
}
expect "position independence (PIE)" 'Type: +DYN'
expect "read-only relocations (RELRO)" 'GNU_RELRO'
expect "immediate binding (BIND_NOW)" 'FLAGS.*NOW'
expect "the stack protector" '__stack_chk_fail'
[ "$2" != Release ] || expect "checked calls (FORTIFY_SOURCE)" '__(memcpy|memmove|snprintf|printf|fprintf|read|vsnprintf)_chk'
if grep -E 'GNU_STACK' <<<"$facts" | grep -q 'E  *0x'; then
  echo "$program: its stack can be executed"
  failed=1
fi
exit $failed
