#!/usr/bin/env bash
# Makes the packages of a build and unpacks them: fails unless they hold what they promise, their program runs from there,
# the service is hardened and off, and lintian (if it is here) finds no error.
# usage: check.sh CPACK CPACK_CONFIG [PYTHON]     PYTHON: that the package python3-aisle is for; without it, there is none
set -euo pipefail
checker=$(realpath "$(dirname "$0")/../readme/check_links.sh")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
umask 022
"$1" --config "$2" -B "$work/packages" >"$work/cpack.log" 2>&1 || { cat "$work/cpack.log"; exit 1; }
for package in aisle libaisle-dev aisle-doc; do
  dpkg-deb --extract "$work"/packages/"$package"_*.deb "$work/root"
done
root=$work/root/usr

for file in bin/aisle share/aisle/worlds/crossings.yaml share/man/man1/aisle.1.gz share/man/man1/aisle-explore.1.gz \
  lib/systemd/system/aisle.service share/bash-completion/completions/aisle share/zsh/vendor-completions/_aisle \
  share/fish/vendor_completions.d/aisle.fish lib/libaisle_core.a include/aisle/core/result.hpp \
  lib/cmake/aisle/aisleConfig.cmake share/doc/aisle-doc/docs/how-to/install.md share/doc/aisle/copyright; do
  [ -s "$root/$file" ] || { echo "no package holds $file"; exit 1; }
done
[ -z "$(find "$root" -name '*.wants')" ] || { echo "the service is on"; exit 1; }

dpkg-deb --field "$work"/packages/aisle_*.deb Depends | grep -q 'libembree3' || { echo "aisle: dependencies are missing"; exit 1; }
dpkg-deb --field "$work"/packages/libaisle-dev_*.deb Depends | grep -q 'libeigen3-dev' ||
  { echo "libaisle-dev: dependencies are missing"; exit 1; }

here=$(realpath "$(dirname "$0")")
if command -v python3 >/dev/null; then
  "$here/../../scripts/sbom" "$root/bin/aisle" "$work/aisle.spdx.json"
  "$here/check_sbom.py" "$work/aisle.spdx.json" "$(dpkg-deb --field "$work"/packages/aisle_*.deb Depends)"
fi
"$root/bin/aisle" doctor --quiet
"$root/bin/aisle" sim show crossings >/dev/null
"$checker" "$root/share/doc/aisle-doc"

if [ -n "${3:-}" ]; then
  dpkg-deb --extract "$work"/packages/python3-aisle_*.deb "$work/root"
  for depends in 'aisle (=' python3-numpy 'python3 (<<' libembree3; do
    dpkg-deb --field "$work"/packages/python3-aisle_*.deb Depends | grep -qF "$depends" ||
      { echo "python3-aisle does not depend on $depends"; exit 1; }
  done
  [ -s "$root/lib/python3/dist-packages/aisle/_aisle.pyi" ] || { echo "python3-aisle: type stubs are missing"; exit 1; }
  (cd "$work" && PYTHONPATH="$root/lib/python3/dist-packages" "$3" -B -c "
import aisle
assert aisle.__file__.startswith('$root/'), aisle.__file__
assert 'crossings' in aisle.shipped('worlds')
aisle.Environment('crossings').reset(seed=1)")
fi
if command -v systemd-analyze >/dev/null; then
  systemd-analyze security --offline=yes --threshold=25 "$root/lib/systemd/system/aisle.service" >"$work/security" ||
    { cat "$work/security"; exit 1; }
fi
# The figure that docs/how-to/install.md gives.
if apt-cache show libembree3-3 >/dev/null 2>&1; then
  "$here/../../scripts/installed-size" "$work"/packages/aisle_*.deb 250
fi
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error "$work"/packages/*.deb
fi
echo "packages hold what they promise"
