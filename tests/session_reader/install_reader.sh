#!/bin/sh
# Installs the independent reader into a directory, unless it is there already. Exit code 77: there is no Node.
#   tests/session_reader/install_reader.sh DIRECTORY
set -eu

directory=${1:?usage: install_reader.sh DIRECTORY}
here=$(cd "$(dirname "$0")" && pwd)

if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  echo "node or npm is not here: sessions are not checked with an independent reader (scripts/install --checks)"
  exit 77
fi
mkdir -p "$directory"
cp "$here/dump.mjs" "$directory"
cmp -s "$here/package-lock.json" "$directory/installed-lock.json" && exit 0
cp "$here/package.json" "$here/package-lock.json" "$here/.npmrc" "$directory"
(cd "$directory" && npm ci)
cp "$here/package-lock.json" "$directory/installed-lock.json"
