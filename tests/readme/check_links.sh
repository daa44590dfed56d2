#!/usr/bin/env bash
# Checks that every relative link of the Markdown pages under a directory leads to a file, and its #anchor to a heading.
# usage: tests/readme/check_links.sh DIRECTORY
set -euo pipefail
cd "$1"
links=0
broken=0

anchors() {  # of a page's headings, as GitHub and GitLab make them
  sed -n 's/^##* //p' "$1" | tr '[:upper:]' '[:lower:]' | sed -E 's/[^a-z0-9 _-]//g; s/ /-/g'
}

while IFS=: read -r page line link; do
  target=${link#*](}
  target=${target%)}
  [[ $target != *://* ]] || continue
  links=$((links + 1))
  file=${target%%#*}
  [ -n "$file" ] && file=$(dirname "$page")/$file || file=$page
  if [ -e "$file" ]; then
    [[ $target == *'#'* ]] || continue
    anchors "$file" | grep -qxF -- "${target#*#}" && continue
  fi
  echo "$page:$line: $target leads nowhere"
  broken=$((broken + 1))
done < <(find . -name '*.md' -not -path '*/node_modules/*' -not -path './build/*' -not -path './tests/*' -not -path './.git/*' -print0 |
  sort -z | xargs -0 grep -noE '\]\([^) ]+\)' /dev/null)

[ $links -gt 0 ] || { echo "no links found"; exit 1; }
echo "$broken of $links links lead nowhere"
[ $broken -eq 0 ]
