# shellcheck shell=bash
# Runs the fuzzers of tests/fuzz. Sourced by test.sh, after prepare.sh.

packages_to_fuzz() {
  printf '%s\n' clang libclang-rt-dev libomp-dev
}

# fuzz_one TARGET SECONDS: runs it on a copy of its seeds and on its findings; one line with what was done. What it finds
# is left in build/fuzz/found.
fuzz_one() {
  local target=$1 seconds=$2 folder=$root/build/fuzz status=0 scratch=${TMPDIR:-/tmp}
  mkdir -p "$folder/corpus/$target" "$folder/seeds/$target" "$folder/found" "$root/tests/fuzz/findings/$target"
  # OpenMP's threads would be leaks at the end; a reader may take 2 GiB and 10 s. DCMTK asks for what a length promises
  # without throwing and without touching it, so that single requests have no limit of their own.
  # What is read at once and never kept: in memory, where that can be.
  [ ! -d /dev/shm ] || scratch=/dev/shm
  TMPDIR=$scratch VISCERA_FUZZ_SEEDS=$folder/seeds/$target OMP_NUM_THREADS=1 ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1 \
    LSAN_OPTIONS=suppressions=$root/tests/support/leaks.supp:print_suppressions=0 \
    "$folder/bin/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1000000 -max_len=65536 -print_final_stats=1 \
    -artifact_prefix="$folder/found/$target-" \
    "$folder/corpus/$target" "$folder/seeds/$target" "$root/tests/fuzz/findings/$target" \
    >"$folder/$target.log" 2>&1 || status=$?
  rmdir --ignore-fail-on-non-empty "$root/tests/fuzz/findings/$target"
  awk -v target="$target" -v status="$status" '
    /number_of_executed_units/ {runs = $2}
    /average_exec_per_sec/ {speed = $2}
    / cov: / {for (i = 1; i < NF; ++i) if ($i == "cov:") covered = $(i + 1)}
    END {printf "%-18s %10d runs %7d a second, %6d edges%s\n", target, runs, speed, covered, status ? "  FOUND SOMETHING" : ""}
  ' "$folder/$target.log"
  return "$status"
}

# fuzz SECONDS [TARGET...]: all targets, or those named, for so long each. Fails when one of them found something.
fuzz() {
  local seconds=$1 failed=0 target
  shift
  mapfile -t packages < <(packages_to_fuzz)
  install_packages "${packages[@]}"
  use_shared_cache "$root"
  (cd "$root" && cmake --preset fuzz && cmake --build --preset fuzz) >&2
  local -a names=("$@")
  [ "$#" -gt 0 ] || mapfile -t names < <(cd "$root/build/fuzz/bin" && printf '%s\n' fuzz_* | sed 's/^fuzz_//')
  for target in "${names[@]}"; do
    fuzz_one "$target" "$seconds" || failed=1
  done
  [ "$failed" -eq 0 ] || fail "The inputs are in build/fuzz/found, what happened in build/fuzz/TARGET.log. Mend it, then add the input to tests/fuzz/findings/TARGET."
}
