# shellcheck shell=bash
# Runs the tests under a sanitiser. Sourced by test.sh, after prepare.sh and fuzz.sh.

# sanitise address|thread [CTEST_OPTION...]: builds everything with clang and runs all tests, or those of the options.
sanitise() {
  local preset
  case ${1:-} in
  address) preset=asan ;;
  thread) preset=tsan ;;
  *) fail "There are two sanitisers: ./test.sh --sanitise address and ./test.sh --sanitise thread" 64 ;;
  esac
  mapfile -t packages < <(packages_to_fuzz)
  install_packages "${packages[@]}"
  use_shared_cache "$root"
  (cd "$root" && cmake --preset "$preset" && cmake --build --preset "$preset") >&2
  build=$root/build/$preset
  # Archer tells the thread sanitiser how OpenMP's threads wait for each other; it comes with clang's OpenMP.
  local -a archer
  mapfile -t archer < <(compgen -G '/usr/lib/llvm-*/lib/libarcher.so')
  use_own_environment
  start_displays "$jobs"
  # DCMTK asks for what a length promises without throwing and without touching it. Leaks of Qt, fontconfig and Mesa are
  # not ours; VTK, Qt and the rest of the system are not instrumented, and what they do among themselves is not judged.
  ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:detect_odr_violation=0 \
    LSAN_OPTIONS=suppressions=$root/tests/support/leaks.supp:print_suppressions=0 \
    UBSAN_OPTIONS=print_stacktrace=1 OMP_TOOL_LIBRARIES=${archer[0]:-} \
    TSAN_OPTIONS=ignore_noninstrumented_modules=1:suppressions=$root/tests/support/races.supp \
    ctest --test-dir "$build" --parallel "$jobs" --resource-spec-file "$build/displays.json" \
    --output-on-failure --no-tests=error "${@:2}"
}
