#!/usr/bin/env bash
# Releases a small repository: fails unless what is wrong is refused, the checksums and the signature hold, and the same commit
# gives the same archives.
# usage: check.sh RELEASE_SCRIPT
set -euo pipefail
work=$(mktemp -d)
export GNUPGHOME=$work/keys
trap 'gpgconf --kill all; rm -rf "$work"' EXIT
mkdir -m 700 "$GNUPGHOME"
mkdir -p "$work/sources/scripts"
cp "$1" "$work/sources/scripts/release"
cd "$work/sources"
printf '#!/bin/sh\nmkdir -p out/packages && echo package >out/packages/aisle_1.2.3.deb && echo {} >out/packages/aisle.spdx.json\n' >scripts/package
printf '#!/bin/sh\nmkdir -p out/site && echo page >out/site/index.html\n' >scripts/docs
chmod +x scripts/*
echo 1.2.3 >VERSION
echo /out/ >.gitignore
commit() { git add -A && git -c user.name=x -c user.email=x@example.org -c commit.gpgsign=false commit -qm x; }
refused() { ! scripts/release "${@:2}" >"$work/said" 2>&1 && grep -qF -- "$1" "$work/said" || { echo "not refused: $1"; cat "$work/said"; exit 1; }; }
git init -q

echo "## 1.2.3 (unreleased)" >CHANGELOG.md && commit
refused "1.2.3 is unreleased"
echo "## 1.2.2 (2026-01-01)" >CHANGELOG.md && commit
refused "has no entry for 1.2.3"
echo "## 1.2.3 (2026-01-02)" >CHANGELOG.md
refused "not committed"
commit
refused "no secret key" nobody@example.org
[ ! -e out ] || { echo "something was written though it was refused"; exit 1; }

gpg --batch --quiet --passphrase '' --quick-generate-key releaser@example.org ed25519 sign never
scripts/release releaser@example.org
cd out/release
for file in aisle-1.2.3.tar.gz aisle-1.2.3-site.tar.gz aisle_1.2.3.deb aisle.spdx.json; do
  grep -q " $file\$" SHA256SUMS || { echo "SHA256SUMS lacks $file"; exit 1; }
done
sha256sum --check --quiet SHA256SUMS
gpg --verify SHA256SUMS.asc SHA256SUMS
tar -tzf aisle-1.2.3-site.tar.gz | grep -qx aisle-1.2.3-site/index.html
cp SHA256SUMS "$work/first"
cd ../..
touch -d 2001-01-01 VERSION scripts/docs
scripts/release
cmp "$work/first" out/release/SHA256SUMS
[ ! -e out/release/SHA256SUMS.asc ] || { echo "signed without a key"; exit 1; }
echo "releases are whole"
