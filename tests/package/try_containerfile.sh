#!/usr/bin/env bash
# Takes the steps of the Containerfile in bare roots that mmdebstrap makes, where no builder of containers is to be had, and runs
# what came out. As root; needs the network and some GB. Not part of the test suite.
# usage: try_containerfile.sh WORK [PACKAGES]     PACKAGES: with them the first stage, which builds, is left out
set -euo pipefail
sources=$(realpath "$(dirname "$0")/../..")
work=$(realpath -m "$1")
built=${2:+$(realpath "$2")}
stage=0
root=""
directory=/
user=root

inside() { chroot "$root" su -s /bin/sh "$user" -c "cd '$directory' && $1"; }

begin_stage() {
  stage=$((stage + 1))
  root=$work/stage-$stage
  directory=/
  user=root
  [ -n "$built" ] && [ $stage -eq 1 ] && return
  mkdir -p "$root"
  mmdebstrap --quiet --variant=minbase --include=ca-certificates bookworm "$root"
  cp /etc/resolv.conf "$root/etc/"
}

copy() {
  case $1 in
    --from=build)
      if [ -n "$built" ]; then cp "$built"/${2##*/} "$root$3"; else cp "$work"/stage-1$2 "$root$3"; fi
      ;;
    .) tar -C "$sources" --exclude-from="$sources/.containerignore" -cf - . | tar -C "$root$directory" -xf - ;;
    *) echo "a COPY that is not known here: $*"; exit 1 ;;
  esac
}

step() {
  local word=$1 rest=$2
  [ "$word" = FROM ] || [ -z "$built" ] || [ $stage -ne 1 ] || return 0
  echo "== $word $rest"
  case $word in
    FROM) begin_stage ;;
    WORKDIR) directory=$rest && mkdir -p "$root$rest" ;;
    COPY) copy $rest ;;
    RUN) inside "$rest" ;;
    USER) user=$rest ;;
    EXPOSE | ENTRYPOINT | CMD) ;;
    *) echo "a step that is not known here: $word"; exit 1 ;;
  esac
}

line=""
while IFS= read -r row; do
  [[ -n $row && $row != '#'* ]] || continue
  line+=${row%\\}
  [[ $row == *\\ ]] && continue
  step "${line%% *}" "${line#* }"
  line=""
done <"$sources/Containerfile"

inside "aisle --version && aisle doctor --quiet && aisle explore crossings --out explored --quiet"
[ -s "$root/home/aisle/explored/report.html" ] || { echo "nothing was explored"; exit 1; }
echo "the container's steps work"
