#!/usr/bin/env bash
# Makes a bare Debian or Ubuntu in a folder, lays the committed project into it, runs there what a new user runs, and prints
# what came out. Needs root, debootstrap and a mirror.
#   resources/scripts/try_system.sh SUITE              ./run.sh --build-only, the heart played headless, and ./test.sh
#   resources/scripts/try_system.sh SUITE COMMAND...   these commands instead, each an argument
# SUITE: bookworm, trixie, noble
# Environment: MIRROR (the one that this system's packages come from, with the suite's name put in), WORK (a folder for the
# system, build/systems/SUITE otherwise; one that is there is used again, with what is installed and built in it)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
readonly root
# shellcheck source=resources/scripts/prepare.sh
source "$root/resources/scripts/prepare.sh"

[ "$#" -gt 0 ] || fail "Name a suite: $0 bookworm, trixie or noble" 64
readonly suite=$1
shift
[ "$(id -u)" -eq 0 ] || fail "A bare system needs root. Run it as root." 77
command -v debootstrap >/dev/null || fail "debootstrap is missing. As root: apt-get install debootstrap" 69
[ -e "/usr/share/debootstrap/scripts/$suite" ] || fail "This debootstrap does not know the suite $suite" 64

# Any suite of the same distribution lies on the same mirror.
mirror=${MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Component: main' | grep -v security | sort -u | head -n 1)}
[ -n "$mirror" ] || fail "This system has no source of packages. Name a mirror: MIRROR=ADDRESS $0 $suite" 69
readonly mirror
readonly system=${WORK:-$root/build/systems/$suite}
readonly log=$system.log

mounted=()
clean_up() {
  local at
  for at in "${mounted[@]}"; do
    umount -l "$at" || true
  done
}
trap clean_up EXIT

make_bare_system() {
  local components=main
  [ "$suite" != noble ] || components='main universe'
  mkdir -p "$system"
  if [ ! -e "$system/etc/debian_version" ]; then
    say "== A bare $suite in $system"
    debootstrap --variant=minbase "$suite" "$system" "$mirror" >"$log" 2>&1 ||
      fail "debootstrap failed; it says: $(tail -n 3 "$log")"
  fi
  printf 'deb %s %s %s\n' "$mirror" "$suite" "$components" >"$system/etc/apt/sources.list"
  # Of this system only how a mirror is reached.
  apt-config dump Acquire | grep -E '^Acquire::(http|https|ftp|Check-)' >"$system/etc/apt/apt.conf.d/90mirror" || true
  [ ! -s /etc/resolv.conf ] || cp /etc/resolv.conf "$system/etc/resolv.conf"
  echo force-unsafe-io >"$system/etc/dpkg/dpkg.cfg.d/quick"
  mount --bind /proc "$system/proc"
  mounted+=("$system/proc")
}

# The project as it is committed; what was built in the system before stays.
lay_project() {
  mkdir -p "$system/viscera/project"
  git -C "$root" archive HEAD | tar -x -C "$system/viscera/project"
}

# try COMMAND: in the system, without this one's environment; says how long it took and how it ended.
try() {
  local begin=$SECONDS status=0
  say "== $1"
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 LIBGL_ALWAYS_SOFTWARE=1 \
    chroot "$system" bash -c "cd /viscera/project && $1" >>"$log" 2>&1 || status=$?
  printf '%-10s %-50s %5d s  %s\n' "$suite" "$1" "$((SECONDS - begin))" \
    "$([ "$status" -eq 0 ] && echo passed || echo "failed ($status); see $log")"
  return "$status"
}

make_bare_system
lay_project
[ "$#" -gt 0 ] || set -- './run.sh --build-only' './run.sh play heartbeat --csv /tmp/beat.csv' './test.sh'
failed=0
for command in "$@"; do
  try "$command" || failed=1
done
exit "$failed"
