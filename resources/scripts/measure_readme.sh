#!/usr/bin/env bash
# Prints every figure of "What was measured" in README.md, in its order: measure_readme.sh [BUILD_DIRECTORY] (build/release).
# Times need a quiet machine. The tests `Readme.*` hold the figures that do not depend on it.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
bin=$(cd -- "${1:-$root/build/release}" && pwd)/bin
readonly root bin
[ -x "$bin/bench_coordinates" ] || { echo "There are no benchmarks in $bin. Build the target viscera_bench." >&2; exit 66; }
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd "$work"

title() { printf '\n== %s\n' "$*"; }
bench() { # bench PROGRAM [OPTION...]: medians of nine runs
  "$bin/$1" --benchmark_repetitions=9 --benchmark_report_aggregates_only=true "${@:2}" 2>/dev/null | grep -E '^Benchmark|_median'
}

title "Heartbeat: volumes and ejection fraction"
"$bin/viscera" play heartbeat --csv beat.csv
title "Peristalsis: volume"
"$bin/viscera" play peristalsis --csv peristalsis.csv
title "Binding: identity and unity errors, smallest weight, failures, milliseconds"
organs=(sample:heart sample:stomach sample:liver sample:kidney_left)
bunny=$root/../shared/organs/bunny.obj
[ ! -e "$bunny" ] || organs+=("$bunny")
for organ in "${organs[@]}"; do
  "$bin/viscera" handles "$organ" -o handles.mrk.json --count 30 >/dev/null
  printf '%s\n' "$organ"
  "$bin/viscera" bind "$organ" --handles handles.mrk.json
  [ "$organ" != sample:liver ] || "$bin/viscera" bind "$organ" --handles handles.mrk.json --json |
    python3 -c 'import json, sys; b = json.load(sys.stdin); print("liver: %.3g ms, that is %.2g ns a vertex and handle" % (b["seconds"] * 1e3, b["seconds"] * 1e9 / b["vertices"] / b["handles"]))'
done
title "A locked deformation's volume error"
"$bin/viscera" handles sample:liver -o rest.mrk.json --count 30 >/dev/null
python3 - <<'PYTHON'
import json
rig = json.load(open("rest.mrk.json"))
points = [point for markup in rig["markups"] for point in markup["controlPoints"]]
points[10]["position"][0] += 12
json.dump(rig, open("pose.mrk.json", "w"))
PYTHON
"$bin/viscera" deform sample:liver --handles rest.mrk.json --pose pose.mrk.json --lock-volume --json
title "Benchmarks"
bench bench_coordinates
bench bench_deformation
bench bench_volume --benchmark_filter='table52|Form'
bench bench_localised
bench bench_play --benchmark_filter=frameButDrawing
bench bench_labels
bench bench_organs --benchmark_filter=generateAllMedium
title "The thesis's figures and tables"
"$bin/viscera" reproduce -o page | tail -n 3
