# shellcheck shell=bash
# Runs the tests under a sanitiser. Sourced by test.sh, after prepare.sh and fuzz.sh.

# preset_of address|thread: of CMakePresets.json.
preset_of() {
  case $1 in
  address) echo asan ;;
  thread) echo tsan ;;
  *) fail "There are two sanitisers: ./test.sh --sanitise address and ./test.sh --sanitise thread" 64 ;;
  esac
}

# build_sanitised PRESET MODULES [TARGET...]: with clang, in build/PRESET, which `build` names from now on. The sanitiser
# does not judge the code of MODULES (a list of CMake).
build_sanitised() {
  local preset=$1 modules=$2
  local -a targets=()
  shift 2
  [ "$#" -eq 0 ] || targets=(--target "$@")
  mapfile -t packages < <(packages_to_fuzz)
  install_packages "${packages[@]}"
  use_shared_cache "$root"
  (cd "$root" && cmake --preset "$preset" -DVISCERA_NOT_SANITISED="$modules" && cmake --build --preset "$preset" "${targets[@]}") >&2
  build=$root/build/$preset
}

# run_sanitised COMMAND [ARGUMENT...]: where sanitisers know what is not ours.
run_sanitised() {
  # Archer tells the thread sanitiser how OpenMP's threads wait for each other; it comes with clang's OpenMP.
  local -a archer
  mapfile -t archer < <(compgen -G '/usr/lib/llvm-*/lib/libarcher.so')
  # DCMTK asks for what a length promises without throwing and without touching it. Leaks of Qt, fontconfig and Mesa are
  # not ours; VTK, Qt and the rest of the system are not instrumented, and what they do among themselves is not judged.
  # A test forks and starts threads in its child, which the thread sanitiser stops unless told otherwise. Up to clang 16
  # the address sanitiser takes some dynamic TLS blocks, by their addresses, for those of an older C library, and crashes
  # while it looks for leaks. With a C library of today it knows no other such blocks, so that nothing is lost without them.
  ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:detect_odr_violation=0:intercept_tls_get_addr=0 \
    LSAN_OPTIONS=suppressions=$root/tests/support/leaks.supp:print_suppressions=0 \
    UBSAN_OPTIONS=print_stacktrace=1 OMP_TOOL_LIBRARIES=${archer[0]:-} \
    TSAN_OPTIONS=ignore_noninstrumented_modules=1:die_after_fork=0:suppressions=$root/tests/support/races.supp \
    "$@"
}

# sanitise address|thread [CTEST_OPTION...]: builds everything and runs all tests, or those of the options.
sanitise() {
  local preset
  preset=$(preset_of "${1:-}")
  build_sanitised "$preset" ""
  use_own_environment
  start_displays "$tests_at_once"
  run_sanitised ctest --test-dir "$build" --parallel "$tests_at_once" --resource-spec-file "$build/displays.json" \
    --output-on-failure --no-tests=error "${@:2}"
}

# run_in_shares PROGRAM [ARGUMENT...]: the tests of the program, a share of them on each processor; fails where one fails.
run_in_shares() {
  local share process failed=0
  local -a processes=()
  for ((share = 0; share < jobs; ++share)); do
    GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=$share run_sanitised "$@" &
    processes+=($!)
  done
  for process in "${processes[@]}"; do
    wait "$process" || failed=1
  done
  return "$failed"
}

# sanitise_part address|thread: what continuous integration has time for. The readers of files see the bytes of strangers,
# which come no further than the geometry; of coordinates and deformation those tests whose names say that they run on several
# threads.
sanitise_part() {
  local preset test
  preset=$(preset_of "${1:-}")
  local -a tests=(test_medical_io test_scans)
  local chosen='*' beyond='coordinates;deformation'
  if [ "$preset" = tsan ]; then
    tests=(test_threads)
    chosen='*Thread*:*Parallel*' beyond=
  fi
  build_sanitised "$preset" "$beyond" "${tests[@]}"
  use_own_environment
  # Some kernels lay out memory in a way that a sanitiser refuses, or let it look for no leaks.
  if ! run_sanitised "$build/bin/${tests[0]}" --gtest_list_tests >/dev/null 2>"$build/start.log"; then
    say "Skipped: the $1 sanitiser does not start here; it says: $(tail -n 2 "$build/start.log")"
    return
  fi
  for test in "${tests[@]}"; do
    say "== $test under the $1 sanitiser"
    run_in_shares "$build/bin/$test" --gtest_brief=1 --gtest_filter="$chosen"
  done
}
