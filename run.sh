#!/usr/bin/env bash
# Builds Viscera, installing what the build needs on Debian 12 or Ubuntu 24.04, and starts it.
#   ./run.sh                opens the window; with no display, plays the sample heart and says where the result is
#   ./run.sh --build-only   stops after the build
#   ./run.sh ARGUMENT...    hands the arguments on: ./run.sh info liver.vtk
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
readonly root
# shellcheck source=resources/scripts/prepare.sh
source "$root/resources/scripts/prepare.sh"

readonly build=$root/build/release
mapfile -t packages < <(packages_to_build)
install_packages "${packages[@]}"
mapfile -t packages < <(packages_to_run_if_there)
install_if_there "${packages[@]}"
configure_and_build "$root" "$build" viscera_program -DVISCERA_BUILD_TESTS=OFF -DVISCERA_BUILD_BENCHMARKS=OFF

readonly viscera=$build/bin/viscera
if [ "${1:-}" = --build-only ]; then
  say "Built: $viscera"
  exit 0
fi
if [ "$#" -gt 0 ] || [ -n "${DISPLAY:-}" ]; then
  exec "$viscera" "$@"
fi

readonly out=$root/build/headless
mkdir -p "$out/frames"
say "There is no display (DISPLAY is not set), so the sample heart beats headless."
"$viscera" play heartbeat --frames "$out/frames" --movie "$out/heartbeat.ogv" --csv "$out/heartbeat.csv"
say "Frames:       $out/frames"
say "Movie:        $out/heartbeat.ogv"
say "Volume table: $out/heartbeat.csv"
