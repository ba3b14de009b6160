#!/usr/bin/env bash
# Draws every scenario of the circulation into docs/pictures, and brings the tables of docs/circulation.md up to date.
# make_circulation_pictures.sh [PROGRAM]: the program is build/release/bin/viscera unless another one is named. No display is needed.
set -eu
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${1:-$source/build/release/bin/viscera}
page=$source/docs/circulation.md
[ -x "$program" ] || { echo "make_circulation_pictures.sh: there is no program $program; ./run.sh --build-only makes one" >&2; exit 66; }

for scenario in rest exercise haemorrhage heart-failure-reduced-ef heart-failure-preserved-ef hypertension aortic-stenosis \
  mitral-regurgitation tamponade; do
  "$program" circulate --scenario "$scenario" --png "$source/docs/pictures/circulation_$scenario.png" --size 1200x760 >/dev/null
done

# bring NAME: standard input takes the place of what stands between <!-- NAME --> and <!-- end of NAME -->.
bring() {
  awk -v name="$1" 'NR == FNR { new = new $0 "\n"; next }
    $0 == "<!-- end of " name " -->" { inside = 0 }
    !inside { print }
    $0 == "<!-- " name " -->" { printf "%s", new; inside = 1 }' - "$page" >"$page.new"
  mv "$page.new" "$page"
}
"$program" circulate --published | bring published
"$program" circulate --list | grep '^|' | bring parameters
