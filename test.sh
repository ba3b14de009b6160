#!/usr/bin/env bash
# Builds and runs every test of Viscera, installing what that needs on Debian 12 or Ubuntu 24.04. Ends with the summary
# of ctest; the exit status is 0 only when everything passed.
#   ./test.sh                 everything
#   ./test.sh CTEST_OPTION... a part: ./test.sh -R geometry, ./test.sh -L gui
#   ./test.sh --fuzz SECONDS [TARGET...]  runs the fuzzers instead (docs/reliability.md), for so long each
#   ./test.sh --sanitise address|thread [CTEST_OPTION...]  everything, or a part, under a sanitiser: an hour or more
#   ./test.sh --sanitise-part address|thread  some programs of tests under it, as continuous integration does: minutes
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
readonly root
# shellcheck source=resources/scripts/prepare.sh
source "$root/resources/scripts/prepare.sh"

# shellcheck source=resources/scripts/fuzz.sh
source "$root/resources/scripts/fuzz.sh"
# shellcheck source=resources/scripts/sanitise.sh
source "$root/resources/scripts/sanitise.sh"

build=$root/build/release
jobs=$(nproc)
# Tests of the window wait for a moment between what a hand does: one more than there are processors keeps these busy.
tests_at_once=$((jobs + 1))
readonly jobs tests_at_once

# Virtual displays for the tests of the window, on numbers that are free; ended with the script. ctest lends each of them
# to one test at a time (tests/gui/lent_display.h).
display_pids=()
stop_displays() {
  kill "${display_pids[@]}" 2>/dev/null || true
  wait "${display_pids[@]}" 2>/dev/null || true
}

# start_display: one more; its number is in `display`.
start_display() {
  local number_file=$build/display log=$build/xvfb-${#display_pids[@]}.log waited
  : >"$number_file"
  Xvfb -displayfd 3 -screen 0 1920x1200x24 -nolisten tcp 3>"$number_file" >"$log" 2>&1 &
  display_pids+=($!)
  trap stop_displays EXIT
  for ((waited = 0; waited < 300; ++waited)); do
    [ ! -s "$number_file" ] || break
    kill -0 "${display_pids[-1]}" 2>/dev/null || break
    sleep 0.1
  done
  [ -s "$number_file" ] || fail "Xvfb did not start; it says: $(cat "$log")"
  display=$(<"$number_file")
}

# start_displays COUNT: so many, listed for ctest in $build/displays.json; $DISPLAY is the first, of whatever else needs one.
start_displays() {
  local display list=
  unset WAYLAND_DISPLAY XAUTHORITY
  while [ "${#display_pids[@]}" -lt "$1" ]; do
    start_display
    [ "${#display_pids[@]}" -gt 1 ] || export DISPLAY=:$display
    list+=${list:+, }"{\"id\": \"$display\"}"
  done
  printf '{"version": {"major": 1, "minor": 0}, "local": [{"displays": [%s]}]}\n' "$list" >"$build/displays.json"
}

# Several tests run at once, each on several threads: one that waits must not keep a processor from one that works. The
# allocator keeps what large arrays have used, which the system would else take back and clear for the next one.
export OMP_WAIT_POLICY=passive MALLOC_MMAP_THRESHOLD_=1073741824 MALLOC_TRIM_THRESHOLD_=4294967296

# Tests neither read nor change the settings of whoever runs them; pictures are drawn by Mesa's software renderer, the
# same on every machine.
use_own_environment() {
  local home=$build/test_home
  rm -rf -- "$home/config" "$home/state"
  mkdir -p "$home"/{config,state,cache,runtime}
  chmod 700 "$home/runtime"
  export XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=$home/cache
  export XDG_RUNTIME_DIR=$home/runtime LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
}

mapfile -t packages < <(packages_to_build && packages_to_test)
keep_orthanc_still
install_packages "${packages[@]}"
if [ "${1:-}" = --fuzz ]; then
  [[ ${2:-} =~ ^[0-9]+$ ]] || fail "Say for how many seconds each fuzzer is to run: ./test.sh --fuzz 60" 64
  fuzz "${@:2}"
  exit
fi
if [ "${1:-}" = --sanitise ]; then
  sanitise "${@:2}"
  exit
fi
if [ "${1:-}" = --sanitise-part ]; then
  sanitise_part "${2:-}"
  exit
fi
mapfile -t packages < <(packages_to_run_if_there && packages_to_test_if_there)
mapfile -t packages < <(known_of "${packages[@]}")
[ "${#packages[@]}" -eq 0 ] || install_packages "${packages[@]}"
unpack_paraview "$root/build/paraview"

if [ "$#" -eq 0 ]; then
  say "== The numerical modules alone, without VTK and Qt"
  use_shared_cache "$root"
  # Compiled as in everything, which takes these objects from the compiler's cache.
  (cd "$root" && cmake --preset core-only -DVISCERA_UNITY=ON && cmake --build --preset core-only) >&2
  ctest --test-dir "$root/build/core-only" --parallel "$jobs" --output-on-failure --no-tests=error
  set -- --label-exclude '^numerical$' # They have run now, of the same objects.
fi

say "== Everything"
configure_and_build "$root" "$build" all \
  -DVISCERA_WERROR=ON -DVISCERA_BUILD_TESTS=ON -DVISCERA_BUILD_BENCHMARKS=ON
use_own_environment
start_displays "$tests_at_once"
status=0
ctest --test-dir "$build" --parallel "$tests_at_once" --resource-spec-file "$build/displays.json" --output-on-failure --no-tests=error "$@" ||
  status=$?
say "== Skipped"
sed -n 's/^\[  SKIPPED \] \([^ ,]*\) (.*/\1/p' "$build/Testing/Temporary/LastTest.log" | sort -u
exit "$status"
