# shellcheck shell=bash
# Runs the fuzzers of tests/fuzz. Sourced by test.sh, after prepare.sh.

packages_to_fuzz() {
  printf '%s\n' clang libclang-rt-dev libomp-dev
}

# longest_input TARGET: in bytes; longer ones take longer and reach no more.
longest_input() {
  case $1 in
  surface_soups) echo 320 ;;
  command_lines | volume_curves | plugins) echo 1024 ;;
  surfaces | handles | landmarks | lessons | label_maps | label_series | scans) echo 8192 ;;
  *) echo 16384 ;;
  esac
}

# fuzz_one TARGET SECONDS: runs it on a copy of its seeds and on its findings, for at most VISCERA_FUZZ_RUNS runs; one line
# with what was done. What it finds is left in build/fuzz/found.
fuzz_one() {
  local target=$1 seconds=$2 folder=$root/build/fuzz status=0 scratch=${TMPDIR:-/tmp} findings=$root/tests/fuzz/findings/$1
  mkdir -p "$folder/corpus/$target" "$folder/seeds/$target" "$folder/found"
  # OpenMP's threads would be leaks at the end; a reader may take 2 GiB and 10 s. DCMTK asks for what a length promises
  # without throwing and without touching it, so that single requests have no limit of their own. For dynamic TLS blocks
  # see run_sanitised.
  # What is read at once and never kept: in memory, where that can be.
  [ ! -d /dev/shm ] || scratch=/dev/shm
  local -a inputs=("$folder/corpus/$target" "$folder/seeds/$target")
  [ ! -d "$findings" ] || inputs+=("$findings")
  local -a options=(-timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1000000 -max_len="$(longest_input "$target")"
    -artifact_prefix="$folder/found/$target-" -print_funcs=0 -reload=0)
  run_fuzzer() {
    TMPDIR=$scratch VISCERA_FUZZ_SEEDS=$folder/seeds/$target OMP_NUM_THREADS=1 \
      ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:malloc_context_size=4:quarantine_size_mb=16:intercept_tls_get_addr=0 \
      LSAN_OPTIONS=suppressions=$root/tests/support/leaks.supp:print_suppressions=0 \
      "$folder/bin/fuzz_$target" "${options[@]}" "$@" "${inputs[@]}" >>"$folder/$target.log" 2>&1
  }
  : >"$folder/$target.log"
  # Leaks are looked for once, over all inputs that were kept: to look after each run takes longer than the run.
  run_fuzzer -max_total_time="$seconds" -runs="${VISCERA_FUZZ_RUNS:--1}" -detect_leaks=0 -print_final_stats=1 || status=$?
  [ "$status" -ne 0 ] || run_fuzzer -runs=0 -detect_leaks=1 || status=$?
  awk -v target="$target" -v status="$status" '
    /number_of_executed_units/ {runs = $2}
    /average_exec_per_sec/ {speed = $2}
    /slowest_unit_time_sec/ {slowest = $2}
    /peak_rss_mb/ {memory = $2}
    / cov: / {for (i = 1; i < NF; ++i) if ($i == "cov:" && $(i + 1) > covered) covered = $(i + 1)}
    END {printf "%-18s %10d runs %7d a second, %6d edges, slowest %d s, %5d MB%s\n", target, runs, speed, covered, slowest, memory,
      status ? "  FOUND SOMETHING" : ""}
  ' "$folder/$target.log"
  return "$status"
}

# fuzz SECONDS [TARGET...]: all targets, or those named, for so long each, as many at once as there are processors. Fails when
# one of them found something.
fuzz() {
  local seconds=$1 failed=0 target
  shift
  mapfile -t packages < <(packages_to_fuzz)
  install_packages "${packages[@]}"
  use_shared_cache "$root"
  (cd "$root" && cmake --preset fuzz && cmake --build --preset fuzz) >&2
  local -a names=("$@") running=()
  [ "$#" -gt 0 ] || mapfile -t names < <(cd "$root/build/fuzz/bin" && printf '%s\n' fuzz_* | sed 's/^fuzz_//')
  for target in "${names[@]}"; do
    while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do sleep 0.2; done
    fuzz_one "$target" "$seconds" &
    running+=("$!")
  done
  for target in "${running[@]}"; do
    wait "$target" || failed=1
  done
  [ "$failed" -eq 0 ] || fail "The inputs are in build/fuzz/found, what happened in build/fuzz/TARGET.log. Mend it, then add the input to tests/fuzz/findings/TARGET."
}
