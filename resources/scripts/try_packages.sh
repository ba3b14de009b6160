#!/usr/bin/env bash
# Makes Viscera's packages of Debian 12, looks at them with lintian, and tries them in a Debian 12 that debootstrap makes anew:
# installs them, runs the program and its window, reads its manual, has a shell complete its options, validates what a desktop
# reads, builds a project against the libraries, tries the Python package and the plugin of ParaView, and removes everything.
# Needs root, lintian, debootstrap and a mirror.
#   resources/scripts/try_packages.sh [PACKAGE_FOLDER]   PACKAGE_FOLDER: packages that are there already
# shellcheck disable=SC2016 # What stands in single quotes is for the shell inside.
# Environment: MIRROR (the one that this system's packages come from), WORK (a folder for the fresh system; made and removed otherwise),
# WITHOUT_LINTIAN=1 (goes on where there is no lintian)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
readonly root
# shellcheck source=resources/scripts/prepare.sh
source "$root/resources/scripts/prepare.sh"

# Before the long work: packages that lintian has not seen are not tried by mistake.
[ "${WITHOUT_LINTIAN:-}" = 1 ] || command -v lintian >/dev/null ||
  fail "lintian is missing. As root: apt-get install lintian; or go on without: WITHOUT_LINTIAN=1 $0" 69
[ "$(id -u)" -eq 0 ] || fail "A fresh system needs root. Run it as root." 77
command -v debootstrap >/dev/null || fail "debootstrap is missing. As root: apt-get install debootstrap" 69

mirror=${MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Codename: bookworm' | sort -u | head -n 1)}
[ -n "$mirror" ] || fail "This system has no source of Debian 12. Name a mirror: MIRROR=ADDRESS $0" 69
readonly mirror

readonly build=$root/build/package

# The plugin of ParaView, a project of its own, where ParaView can be had; cpack takes it along when it is there.
build_paraview_plugin() {
  install_packages libopenmpi-dev python3-mpi4py
  unpack_paraview "$root/build/paraview"
  local config
  config=$(compgen -G "$root/build/paraview/usr/lib/*/cmake/paraview-*") || {
    say "There is no ParaView to build its plugin against, so there will be no viscera-paraview."
    return 0
  }
  LD_LIBRARY_PATH=${config%/cmake/*} cmake -S "$root/modules/bindings/paraview" -B "$build/paraview_plugin" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DParaView_DIR="$config" -DViscera_DIR="$build" \
    -DPython3_EXECUTABLE=/usr/bin/python3
  LD_LIBRARY_PATH=${config%/cmake/*} cmake --build "$build/paraview_plugin"
}

make_packages() {
  local -a needed
  mapfile -t needed < <(packages_to_build)
  install_packages "${needed[@]}" file dpkg-dev
  use_shared_cache "$root"
  cd "$root"
  cmake --preset package
  cmake --build --preset package
  build_paraview_plugin
  cd "$build"
  rm -rf packages
  cpack
}

show_sizes() {
  local deb
  say "== Sizes"
  for deb in "${debs[@]}"; do
    printf '%-45s %8s kB to download, %8s kB installed\n' "$(basename "$deb")" \
      "$(($(stat -c %s "$deb") / 1024))" "$(dpkg-deb --field "$deb" Installed-Size)"
  done
}

# Warnings that are meant to be have their reason in resources/packages/overrides.
look_with_lintian() {
  if command -v lintian >/dev/null; then
    say "== Lintian"
    lintian --allow-root --fail-on error --fail-on warning --tag-display-limit 0 "${debs[@]}"
  else
    say "== Without lintian, as asked for"
  fi
}

mounted=()
clean_up() {
  local at
  for at in "${mounted[@]}"; do
    umount -l "$at" || true
  done
  [ -n "${WORK:-}" ] || rm -rf --one-file-system -- "$work"
}

make_fresh_system() {
  say "== A fresh Debian 12 in $fresh"
  debootstrap --variant=minbase bookworm "$fresh" "$mirror" >"$work/debootstrap.log" 2>&1 ||
    fail "debootstrap failed; it says: $(tail -n 3 "$work/debootstrap.log")"
  mount --bind /proc "$fresh/proc"
  mounted+=("$fresh/proc")
  # Of this system only how a mirror is reached; its other sources and their keys are none of a fresh system's.
  printf 'deb %s bookworm main\n' "$mirror" >"$fresh/etc/apt/sources.list"
  apt-config dump Acquire | grep -E '^Acquire::(http|https|ftp|Check-)' >"$fresh/etc/apt/apt.conf.d/90mirror" || true
  [ ! -s /etc/resolv.conf ] || cp /etc/resolv.conf "$fresh/etc/resolv.conf"
  # It is thrown away, so nothing waits for the disk.
  echo force-unsafe-io >"$fresh/etc/dpkg/dpkg.cfg.d/quick"
  mkdir -p "$fresh/packages/paraview" "$fresh/var/tmp/tries"
  cp "${debs[@]}" "$fresh/packages/"
  ! compgen -G "$fresh/packages/viscera-paraview_*.deb" >/dev/null ||
    mv "$fresh"/packages/viscera-paraview_*.deb "$fresh/packages/paraview/"
}

# Runs in the fresh system, without this one's environment.
inside() {
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    LIBGL_ALWAYS_SOFTWARE=1 chroot "$fresh" bash -euo pipefail -c "$1"
}

# install_inside WHAT...: packages and files of packages, and nothing that they only recommend.
install_inside() {
  inside "apt-get --quiet --yes install --no-install-recommends $*" >>"$work/apt.log" 2>&1 ||
    fail "The packages do not install; apt-get says: $(tail -n 20 "$work/apt.log")"
}

install_packages_inside() {
  say "== Install"
  inside 'apt-get --quiet update' >"$work/apt.log" 2>&1 || fail "apt-get update fails: $(tail -n 5 "$work/apt.log")"
  inside 'dpkg-query --show --showformat "\${Package}\n" | sort >/before'
  install_inside '/packages/*.deb' qttranslations5-l10n xvfb xauth
  say "$(inside 'dpkg-query --show --showformat "\${Package}\n" | sort | comm -13 /before - | wc -l') packages were installed"
  # What the tries need, at once: the mirror is asked but once more.
  install_inside man-db bash-completion zsh appstream desktop-file-utils shared-mime-info g++ cmake make
}

try_program() {
  say "== The program"
  inside 'viscera --version'
  inside 'cd /tmp && viscera play heartbeat --csv heartbeat.csv && wc -l heartbeat.csv && head -n 2 heartbeat.csv'
  inside 'cd /tmp && viscera handles sample:liver@low -o h.mrk.json --enclosing && viscera stress sample:liver@low --handles h.mrk.json --pose h.mrk.json --witnesses 500'
  inside 'viscera systems | grep localised-s-celestial'
}

# Reads, through man, the page of the program and that of a command, without a warning of what sets them.
try_manual() {
  say "== The manual"
  inside 'cd /var/tmp/tries
    for page in viscera viscera-play; do
      MANWIDTH=100 man --warnings --pager=cat "$page" >page 2>warnings
      [ ! -s warnings ] || { cat warnings; exit 1; }
      grep -q "^ *$page - ." page || { echo "man $page has no NAME"; exit 1; }
      wc -l page
    done
    grep -q -- "--ejection-fraction" page || { echo "man viscera-play does not name an option"; exit 1; }'
}

try_completion() {
  say "== Completion"
  cp "$root/tests/contract/packages/try_completion.sh" "$fresh/var/tmp/tries/"
  inside 'bash --norc /var/tmp/tries/try_completion.sh'
  inside 'found=$(zsh -fc "autoload -U compinit && compinit -u -D && print -r -- \$_comps[viscera]")
    [ "$found" = _viscera ] || { echo "zsh finds no completion: $found"; exit 1; }'
}

# The installed files by their validators, and the system's own database of types.
try_desktop() {
  say "== Desktop entry, AppStream and file types"
  cp "$root/tests/contract/desktop/validate.sh" "$fresh/var/tmp/tries/"
  inside 'mkdir /var/tmp/tries/desktop && cd /var/tmp/tries/desktop
    cp /usr/share/applications/org.viscera.Viscera.desktop /usr/share/metainfo/org.viscera.Viscera.metainfo.xml .
    cp /usr/share/mime/packages/org.viscera.Viscera.xml org.viscera.Viscera.mime.xml
    for kind in desktop metainfo mime translations; do
      bash ../validate.sh "$kind" . || { echo "$kind is not valid"; exit 1; }
    done
    grep -q "x-viscera-session+json:\*\.viscera" /usr/share/mime/globs2'
}

# A project that knows the installed packages alone.
try_development() {
  say "== A project that uses libviscera-dev"
  cp -r "$root/tests/contract/install/consumer" "$fresh/var/tmp/tries/"
  inside 'cd /var/tmp/tries && cmake -S consumer -B consumer/build >configured && cmake --build consumer/build && consumer/build/consumer
    ldd consumer/build/consumer >linked
    grep "libviscera_deformation.so.* => /\(usr/\)\?lib" linked'
}

try_window() {
  local language
  say "== The window, under Xvfb"
  for language in en de es fr ca; do
    inside 'cd /tmp && xvfb-run -s "-screen 0 1600x1000x24" viscera --fresh-settings --language '"$language"' \
      --window-size 1280x800 --mode play --screenshot window.png && test "$(stat -c %s window.png)" -gt 50000'
    cp "$fresh/tmp/window.png" "$packages/window_$language.png"
    say "$packages/window_$language.png"
  done
}

try_python() {
  say "== Python"
  install_inside python3-vtk9
  inside 'python3 -c "
import viscera
print(len(viscera.systems()), \"coordinate systems,\", viscera.sample_names())
import viscera._files, viscera._motion
from viscera_vtk.vtkVisceraFilters import vtkVisceraDeformFilter
"'
}

try_paraview() {
  local program
  compgen -G "$fresh/packages/paraview/*.deb" >/dev/null || return 0
  say "== ParaView"
  # Its Python package cannot be beside python3-vtk9.
  install_inside '/packages/paraview/*.deb' python3-paraview python3-vtk9-
  cp "$root/modules/bindings/python/examples/paraview_trace.py" "$fresh/tmp/"
  for program in pvpython pvbatch; do
    inside 'cd /tmp && VISCERA_PLUGIN=$(dpkg --listfiles viscera-paraview | grep /Viscera.so) '"$program"' paraview_trace.py .'
  done
}

remove_packages_inside() {
  local left
  say "== Remove"
  rm -rf --one-file-system -- "$fresh/var/tmp/tries" # What the tries copied is not the packages'.
  inside 'apt-get --quiet --yes purge "?and(?installed,?name(viscera))"' >>"$work/apt.log" 2>&1
  left=$(inside 'find / -xdev \( -path /packages -o -path /proc -o -path /root -o -path /var/log \) -prune -o -iname "*viscera*" -print
    grep -rls viscera /etc /usr/share/applications /usr/share/icons /usr/share/mime || true')
  [ -z "$left" ] || fail "This is left after removal: $left"
}

packages=${1:-}
if [ -z "$packages" ]; then
  (make_packages) >&2
  packages=$build/packages
fi
debs=("$packages"/*.deb)
[ -e "${debs[0]}" ] || fail "There is no package in $packages" 66
show_sizes
look_with_lintian

work=${WORK:-}
if [ -z "$work" ]; then
  work=$(mktemp -d)
fi
readonly fresh=$work/fresh
trap clean_up EXIT
make_fresh_system
install_packages_inside
try_program
try_manual
try_completion
try_desktop
try_development
try_window
try_python
try_paraview
remove_packages_inside
say "Installed, run and removed; nothing is left."
