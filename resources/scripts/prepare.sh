# shellcheck shell=bash
# What run.sh and test.sh share: the packages a machine needs, and the one build directory. Sourced, not run.
# Everything said here goes to stderr, so that the output of `./run.sh info FILE --json` stays one JSON object.


packages_to_build() {
  printf '%s\n' cmake ninja-build g++ ccache \
    libeigen3-dev libboost-dev libqhull-dev libtet1.5-dev nlohmann-json3-dev libcli11-dev zlib1g-dev libbz2-dev liblz4-dev liblzma-dev libexpat1-dev \
    libssl-dev libcurl4-openssl-dev libdcmtk-dev libopenjp2-7-dev \
    libvtk9-dev libvtk9-qt-dev qtbase5-dev libqt5svg5-dev qttools5-dev-tools \
    libegl-dev libgl-dev libegl1 libgl1-mesa-dri libfontconfig-dev fonts-dejavu-core \
    pybind11-dev python3-dev python3-numpy
}

# Packages that the program does without: what Qt says itself (buttons such as Cancel, keys in menus) in other languages.
packages_to_run_if_there() {
  printf '%s\n' qttranslations5-l10n
}

packages_to_test() {
  printf '%s\n' libgtest-dev libgmock-dev libbenchmark-dev libcgal-dev libavcodec-dev \
    calculix-ccx dicom3tools orthanc orthanc-dicomweb openssl xvfb xauth xdotool poppler-utils python3 python3-jsonschema chromium \
    python3-scipy python3-matplotlib python3-meshio python3-pydicom python3-vtk9 python3-mpi4py openmpi-bin libopenmpi-dev
}

# Packages that tests do without where there are none: they say so and are skipped.
packages_to_test_if_there() {
  printf '%s\n' clang-format-14 python3-trimesh desktop-file-utils appstream shared-mime-info groff zsh doxygen
}

say() { printf '%s\n' "$*" >&2; }

fail() {
  say "$1"
  exit "${2:-1}"
}

# Sets `missing` to those of the packages named that are not installed.
find_missing() {
  local package status
  missing=()
  for package in "$@"; do
    status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) || status=absent
    [ "$status" = installed ] || missing+=("$package")
  done
}

# Whether apt-get's lists are there and name every package asked for.
lists_know() {
  local package
  for package in "$@"; do
    [ -n "$(apt-cache show --no-all-versions "$package" 2>/dev/null)" ] || return 1
  done
}

# Runs apt-get without questions, through sudo when not root.
apt() {
  local -a as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes "$@" >&2
}

# install_packages NAME...: says which of the packages are missing and installs them.
install_packages() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    say "This is not Debian or Ubuntu, so nothing is installed. The build needs what these packages hold: $*"
    return 0
  fi
  local -a missing
  find_missing "$@"
  [ "${#missing[@]}" -gt 0 ] || return 0
  say "Installing the packages that are missing: ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "Only root can install them and there is no sudo. As root: apt-get install ${missing[*]}" 69
    say "(with sudo, which may ask for your password)"
  fi
  if ! lists_know "${missing[@]}"; then
    say "apt-get's package lists are missing or old: apt-get update"
    apt update
  fi
  # Lists from another day may name versions that the mirror no longer has; fresh ones mend that.
  if ! apt install --no-install-recommends "${missing[@]}"; then
    say "Once more, with fresh package lists"
    apt update
    apt install --no-install-recommends "${missing[@]}" || fail "apt-get could not install: ${missing[*]}" 69
  fi
}

# The tests start an archive (Orthanc) of their own on free ports. That of the package, on the standard ones, is not started
# on a machine that gets it only for them: `systemctl unmask orthanc` gives it back.
keep_orthanc_still() {
  [ -d /run/systemd/system ] || return 0
  local -a missing as_root=()
  find_missing orthanc
  [ "${#missing[@]}" -gt 0 ] || return 0
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" systemctl mask orthanc.service >&2 || say "Going on; the archive of the package may start."
}

# Those of the packages named that apt-get's lists know.
known_of() {
  local package
  for package in "$@"; do
    ! lists_know "$package" || printf '%s\n' "$package"
  done
}

# install_if_there NAME...: installs those that apt-get's lists know, where that needs no password of its own, and goes on
# without them where it cannot.
install_if_there() {
  local -a missing known
  find_missing "$@"
  [ "${#missing[@]}" -gt 0 ] || return 0
  mapfile -t known < <(known_of "${missing[@]}")
  [ "${#known[@]}" -gt 0 ] || return 0
  [ "$(id -u)" -eq 0 ] || sudo -n true 2>/dev/null || return 0
  (install_packages "${known[@]}") || say "Going on without: ${known[*]}"
}

# The libraries that a package file depends on.
libraries_of() {
  dpkg-deb --field "$1" Depends | tr ',' '\n' | sed 's/|.*//; s/(.*//; s/ //g' | grep '^lib' | sort --unique
}

# unpack_paraview DIRECTORY: ParaView beside the system's VTK. Its packages conflict with python3-vtk9, so they are not
# installed but unpacked, into one folder; about 83 MB to download and ten seconds. Says so and goes on where they cannot be
# had: the tests that want them are skipped.
unpack_paraview() {
  local prefix=$1 downloads package
  [ ! -x "$prefix/usr/bin/pvbatch" ] || return 0
  command -v apt-get >/dev/null || return 0
  downloads=$(mktemp -d)
  if (cd "$downloads" && apt-get --quiet download paraview paraview-dev python3-paraview >&2); then
    local -a libraries
    mapfile -t libraries < <(libraries_of "$downloads"/paraview_*.deb)
    install_packages "${libraries[@]}"
    mkdir -p "$prefix"
    for package in "$downloads"/*.deb; do
      dpkg-deb --extract "$package" "$prefix"
    done
  else
    say "ParaView's packages cannot be had, so its tests will be skipped."
  fi
  rm -rf -- "$downloads"
}

# use_shared_cache SOURCE_DIRECTORY: ccache finds the same source again in another build directory and wherever the project lies.
use_shared_cache() {
  export CCACHE_BASEDIR=$1 CCACHE_NOHASHDIR=1
  # Files that begin with a precompiled header are cached too.
  export CCACHE_SLOPPINESS=pch_defines,time_macros
}

# configure_and_build SOURCE_DIRECTORY BUILD_DIRECTORY TARGET [CMAKE_OPTION...]
# Builds from nothing are what this is for, so several files are compiled as one.
configure_and_build() {
  local source_directory=$1 build_directory=$2 target=$3
  shift 3
  use_shared_cache "$source_directory"
  cmake -S "$source_directory" -B "$build_directory" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVISCERA_UNITY=ON "$@" >&2
  cmake --build "$build_directory" --target "$target" >&2
}
