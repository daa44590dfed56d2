#!/usr/bin/env bash
# The page's tests, as ctest runs them. Exit code 77: Node or Chromium is missing.
#   web/tests/run.sh build | functions | browser NAME      NAME: of browser/NAME.test.mjs
set -euo pipefail
cd "$(dirname "$0")/.."

skip() {
  echo "$1 is missing: the live page is not tested (scripts/install --tests)"
  exit 77
}
{ command -v node && command -v npm; } >/dev/null || skip "node or npm"

case $1 in
  build) ../scripts/web ;;
  functions) npm run --silent test ;;
  browser)
    AISLE_BROWSER=$(command -v chromium) || skip chromium
    export AISLE_BROWSER
    node --test --test-concurrency=1 "tests/browser/$2.test.mjs"
    ;;
esac
