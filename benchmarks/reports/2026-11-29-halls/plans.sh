#!/usr/bin/env bash
# Draws the plans of this report, as PGM of 0.1 m a pixel. usage: plans.sh FOLDER
set -euo pipefail
folder=$1
mkdir -p "$folder"

# plan NAME WIDTH_m HEIGHT_m [X0 Y0 X1 Y1 of a box, metres]...
plan() {
  local name=$1 width=$2 height=$3
  shift 3
  printf '%s %s %s %s\n' "$@" | awk -v width="$width" -v height="$height" '
    { for (y = int($2 * 10); y < int($4 * 10); ++y) for (x = int($1 * 10); x < int($3 * 10); ++x) solid[x, y] = 1 }
    END {
      columns = width * 10; rows = height * 10
      printf "P2\n%d %d\n255\n", columns + 2, rows + 2
      for (y = -1; y <= rows; ++y) {
        line = ""
        for (x = -1; x <= columns; ++x)
          line = line ((x < 0 || y < 0 || x == columns || y == rows || (x, y) in solid) ? "0 " : "255 ")
        print line
      }
    }' >"$folder/$name.pgm"
}

# boxes WIDTH_m DEPTH_m "X..." "Y...": the corners of boxes at all these places
boxes() {
  local x y
  for x in $3; do
    for y in $4; do awk -v x="$x" -v y="$y" -v w="$1" -v d="$2" 'BEGIN { print x, y, x + w, y + d }'; done
  done
}

plan empty30 30 30
plan empty46 46 46
# shellcheck disable=SC2046  # each number is a word
{
  plan pillars 46 46 $(boxes 0.6 0.6 "$(seq 6 8 45)" "$(seq 6 8 45)")
  plan racks_small 40 30 $(boxes 12 1.2 "5 23" "$(seq 4.5 4.2 25.5)")
  plan racks 100 60 $(boxes 20 1.2 "8 34 68" "$(seq 5 4.2 51.2)")
}
