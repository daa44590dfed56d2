#!/usr/bin/env bash
# Runs the commands of a text's ```sh blocks, in their order, from the root of the repository. Of a block with lines that
# begin with "$ " only these are commands (the others show output), else all lines are. build/release/bin/aisle stands for
# the program under test, out/ for a temporary directory that all blocks share. A block after <!-- not run: REASON --> is
# not run.
# usage: tests/readme/run_readme.sh PROGRAM TEXT
set -euo pipefail
program=$(realpath "$1")
text=$(realpath "$2")
cd "$(dirname "$0")/../.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
commands=0

run() {
  local line=$1 command=$2 here
  here=${command//build\/release\/bin\/aisle/"$program"}
  here=$(sed -E "s#(^|[[:space:]=\"'(])(\./)?out(/|[[:space:]]|\$)#\1$out\3#g" <<<"$here")
  echo "== $command"
  commands=$((commands + 1))
  bash -euo pipefail -c "$here" </dev/null || { echo "$text:$line: failed: $command"; exit 1; }
}

run_block() {
  local first=$1 block=$2 prompted=no line=$1 command="" start
  grep -q '^\$ ' <<<"$block" && prompted=yes
  while IFS= read -r row; do
    line=$((line + 1))
    if [ -z "$command" ]; then
      start=$line
      [ $prompted = no ] || [[ $row == '$ '* ]] || continue
      row=${row#'$ '}
      [[ -n $row && $row != '#'* ]] || continue
    fi
    command+=$row
    if [[ $command == *\\ ]]; then
      command+=$'\n'
    else
      run "$start" "$command"
      command=""
    fi
  done <<<"$block"
}

number=0
first=0
block=""
reason=""
while IFS= read -r row || [ -n "$row" ]; do
  number=$((number + 1))
  if [[ $first -eq 0 && $row =~ ^\<!--\ not\ run:\ (.*)\ --\>$ ]]; then
    reason=${BASH_REMATCH[1]}
  elif [[ $first -eq 0 && $row == '```sh' ]]; then
    first=$number
    block=""
  elif [[ $first -gt 0 && $row == '```' ]]; then
    if [ -n "$reason" ]; then
      echo "== $text:$first: not run: $reason"
    else
      run_block "$first" "${block%$'\n'}"
    fi
    first=0
    reason=""
  elif [ "$first" -gt 0 ]; then
    block+=$row$'\n'
  elif [ -n "$row" ]; then
    reason=""
  fi
done <"$text"

[ $commands -gt 0 ] || { echo "$text: no command found"; exit 1; }
echo "== $commands commands of $text work"
