#!/usr/bin/env bash
# Makes Viscera's packages of Debian 12, looks at them with lintian, and tries them in a Debian 12 that debootstrap makes anew:
# installs them, runs the program, its window and the Python package, and removes them. Needs root, debootstrap and a mirror.
#   resources/scripts/try_packages.sh [PACKAGE_FOLDER]   PACKAGE_FOLDER: packages that are there already
# shellcheck disable=SC2016 # What stands in single quotes is for the shell inside.
# Environment: MIRROR (http://deb.debian.org/debian), WORK (a folder for the fresh system; made and removed otherwise)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
readonly root
readonly mirror=${MIRROR:-http://deb.debian.org/debian}
# shellcheck source=resources/scripts/prepare.sh
source "$root/resources/scripts/prepare.sh"

[ "$(id -u)" -eq 0 ] || fail "A fresh system needs root. Run it as root." 77
command -v debootstrap >/dev/null || fail "debootstrap is missing. As root: apt-get install debootstrap" 69

packages=${1:-}
if [ -z "$packages" ]; then
  mapfile -t needed < <(packages_to_build)
  install_packages "${needed[@]}" file dpkg-dev
  use_shared_cache "$root"
  (cd "$root" && cmake --preset package && cmake --build --preset package && cd build/package && rm -rf packages && cpack) >&2
  packages=$root/build/package/packages
fi
debs=("$packages"/*.deb)
[ -e "${debs[0]}" ] || fail "There is no package in $packages" 66

say "== Sizes"
for deb in "${debs[@]}"; do
  printf '%-45s %8s kB to download, %8s kB installed\n' "$(basename "$deb")" \
    "$(($(stat -c %s "$deb") / 1024))" "$(dpkg-deb --field "$deb" Installed-Size)"
done
if command -v lintian >/dev/null; then
  say "== Lintian"
  lintian --allow-root --fail-on error --tag-display-limit 0 "${debs[@]}"
else
  say "== Lintian is not installed and looks at nothing."
fi

work=${WORK:-}
if [ -z "$work" ]; then
  work=$(mktemp -d)
fi
readonly fresh=$work/fresh
mounted=()
clean_up() {
  local at
  for at in "${mounted[@]}"; do
    umount -l "$at" || true
  done
  [ -n "${WORK:-}" ] || rm -rf --one-file-system -- "$work"
}
trap clean_up EXIT

say "== A fresh Debian 12 in $fresh"
debootstrap --variant=minbase bookworm "$fresh" "$mirror" >"$work/debootstrap.log" 2>&1 ||
  fail "debootstrap failed; it says: $(tail -n 3 "$work/debootstrap.log")"
mount --bind /proc "$fresh/proc"
mounted+=("$fresh/proc")
# The mirrors, and how to reach them, are this system's.
: >"$fresh/etc/apt/sources.list"
for file in /etc/apt/sources.list /etc/resolv.conf; do
  [ ! -s "$file" ] || cp "$file" "$fresh$file"
done
for folder in sources.list.d apt.conf.d; do
  cp -r "/etc/apt/$folder/." "$fresh/etc/apt/$folder/"
done
mkdir "$fresh/packages"
cp "${debs[@]}" "$fresh/packages/"

# Runs in the fresh system, without this one's environment.
inside() {
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    LIBGL_ALWAYS_SOFTWARE=1 chroot "$fresh" bash -euo pipefail -c "$1"
}

say "== Install"
inside 'apt-get --quiet update' >"$work/apt.log" 2>&1
inside 'dpkg-query --show --showformat "\${Package}\n" | sort >/before'
inside 'apt-get --quiet --yes install --no-install-recommends /packages/*.deb qttranslations5-l10n xvfb xauth' >>"$work/apt.log" 2>&1 ||
  fail "The packages do not install; apt-get says: $(tail -n 20 "$work/apt.log")"
say "$(inside 'dpkg-query --show --showformat "\${Package}\n" | sort | comm -13 /before - | wc -l') packages were installed"

say "== The program"
inside 'viscera --version'
inside 'cd /tmp && viscera play heartbeat --csv heartbeat.csv && wc -l heartbeat.csv && head -n 2 heartbeat.csv'
inside 'cd /tmp && viscera handles sample:liver@low -o h.mrk.json --enclosing && viscera stress sample:liver@low --handles h.mrk.json --pose h.mrk.json --witnesses 500'
inside 'viscera systems | grep localised-s-celestial'
inside 'test -s /usr/share/man/man1/viscera-play.1.gz -o -n "$(grep -rl path-exclude /etc/dpkg/dpkg.cfg.d)"'

say "== The window, under Xvfb"
for language in en de es fr ca; do
  inside 'cd /tmp && xvfb-run -s "-screen 0 1600x1000x24" viscera --fresh-settings --language '"$language"' \
    --window-size 1280x800 --mode play --screenshot window.png && test "$(stat -c %s window.png)" -gt 50000'
  cp "$fresh/tmp/window.png" "$packages/window_$language.png"
  say "$packages/window_$language.png"
done

say "== Python"
inside 'python3 -c "
import viscera
print(len(viscera.systems()), \"coordinate systems,\", viscera.sample_names())
import viscera._files, viscera._motion
"'

say "== Remove"
inside 'apt-get --quiet --yes purge viscera libviscera0 libviscera-dev python3-viscera viscera-common viscera-tetgen' >>"$work/apt.log" 2>&1
left=$(inside 'find / -xdev -path /packages -prune -o -path /proc -prune -o -path /root -prune -o -path "/var/log" -prune -o -iname "*viscera*" -print')
[ -z "$left" ] || fail "This is left after removal: $left"
say "Installed, run and removed; nothing is left."
