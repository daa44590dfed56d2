#!/bin/sh
# Runs every fuzz target for SECONDS, starting from the kept corpus; fails if a reader crashes, hangs, leaks or
# breaks a promise. The input that did it stays in BUILD_DIR/fuzz-findings/.
#
#   tests/fuzz/run.sh SECONDS [BUILD_DIR]
set -eu

seconds=${1:?usage: tests/fuzz/run.sh SECONDS [BUILD_DIR]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/fuzz}

[ -f "$build/build.ninja" ] || (cd "$root" && cmake --preset fuzz -B "$build")
cmake --build "$build" --target fuzz_targets

findings=$build/fuzz-findings
mkdir -p "$findings"
failed=
for corpus in "$root"/tests/fuzz/corpus/*; do
  target=$(basename "$corpus")
  grown=$build/fuzz-corpus/$target
  log=$findings/$target.log
  mkdir -p "$grown"
  printf 'fuzz_%s: ' "$target"
  if "$build/bin/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 \
    -artifact_prefix="$findings/$target-" "$grown" "$corpus" >"$log" 2>&1; then
    grep '^Done' "$log"
  else
    failed="$failed $target"
    echo "failed"
    tail -n 40 "$log"
  fi
done
[ -z "$failed" ] || { echo "failed:$failed; the inputs are in $findings" >&2; exit 1; }
