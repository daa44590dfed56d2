#!/usr/bin/env bash
# Runs the example scripts, each of which must end well and say what it is there for.
# usage: run_examples.sh "PYTHON -OPTION" PROGRAM SCRIPTS
set -euo pipefail
read -ra python <<<"$1"
program=$2
scripts=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

try() {
  local expected=$1
  shift
  "${python[@]}" "$scripts/$1" "${@:2}" | tee "$work/said"
  grep -qE "$expected" "$work/said" || { echo "$1 did not say: $expected"; exit 1; }
}

"$program" sim log l-corridor --seed 1 --out "$work/log" --quiet
try 'trust: good' map_a_recording.py "$work/log/simulated-trip.log" "$work/building.json"
[ -s "$work/building.json" ]
try 'done: there .* 0 collisions' write_a_navigator.py
try 'arrived: True' learn_in_the_simulator.py
for script in "$scripts"/*.py; do
  grep -q "$(basename "$script")" "$0" || { echo "$script is not run"; exit 1; }
done
