#!/usr/bin/env bash
# Runs every fuzz target for SECONDS, starting from the kept corpus, as many at once as there are processors; fails if
# a reader crashes, hangs, leaks or breaks a promise. The input that did it stays in BUILD_DIR/fuzz-findings/. The inputs
# are the same every time, so that a change is judged by what it changed; AISLE_FUZZ_SEED=0 tries others each time.
#
#   tests/fuzz/run.sh SECONDS [BUILD_DIR]
set -euo pipefail

seconds=${1:?usage: tests/fuzz/run.sh SECONDS [BUILD_DIR]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/fuzz}
findings=$build/fuzz-findings

fuzz() {
  local target=$1 corpus=$root/tests/fuzz/corpus/$1 grown=$build/fuzz-corpus/$1 log=$findings/$1.log
  mkdir -p "$grown"
  if "$build/bin/fuzz_$target" -seed="${AISLE_FUZZ_SEED:-1}" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 \
    -artifact_prefix="$findings/$target-" "$grown" "$corpus" >"$log" 2>&1; then
    echo "fuzz_$target: $(grep '^Done' "$log")"
  else
    echo "fuzz_$target: failed
$(tail -n 40 "$log")"
    return 1
  fi
}
export -f fuzz
export root build findings seconds

[ -f "$build/build.ninja" ] || (cd "$root" && cmake --preset fuzz -B "$build")
cmake --build "$build" --target fuzz_targets
mkdir -p "$findings"
find "$root/tests/fuzz/corpus" -mindepth 1 -maxdepth 1 -printf '%f\n' | sort |
  xargs -P "$(nproc)" -I{} bash -c 'fuzz {}' || { echo "the inputs are in $findings" >&2; exit 1; }
