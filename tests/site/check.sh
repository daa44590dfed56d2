#!/usr/bin/env bash
# Builds the site of a build: fails unless every page is in its menu, every verb is described, and every link leads somewhere.
# usage: check.sh BUILD CHECKER
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$root/scripts/docs" "$1" "$work/site"
"$2" "$work/site"

for page in "$root"/docs/*.md "$root"/docs/*/*.md; do
  grep -qF -- " ${page#"$root"/}" "$root/docs/site/mkdocs.yml" || { echo "the menu lacks ${page#"$root"/}"; exit 1; }
done
for verb in $("$1/bin/aisle" complete "" | cut -f 1); do
  grep -q "id=\"aisle-$verb\"" "$work/site/docs/reference/verbs.html" || { echo "no description of $verb"; exit 1; }
done
[ -s "$work/site/docs/reference/cpp/classaisle_1_1Navigator.html" ] || { echo "no C++ interface"; exit 1; }
echo "the site is whole"
