#!/usr/bin/env bash
# Draws every sample organ from three sides and film strips of the sequences into docs/pictures, by the program alone.
# make_pictures.sh [PROGRAM]: the program is build/release/bin/viscera unless another one is named. A display is needed for pictures of the window only.
set -eu
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${1:-$source/build/release/bin/viscera}
pictures=$source/docs/pictures
[ -x "$program" ] || { echo "make_pictures.sh: there is no program $program; ./run.sh --build-only makes one" >&2; exit 66; }
mkdir -p "$pictures"

organ() { # organ NAME SIDES [OPTION...]
  local name=$1 sides=$2
  shift 2
  "$program" render "sample:$name" -o "$pictures/organ_$name.png" --views "$sides" --size 420x420 --theme light "$@"
}
strip() { # strip NAME SEQUENCE FPS COLUMNS SIZE VIEW [OPTION...]
  local name=$1 sequence=$2 fps=$3 columns=$4 size=$5 view=$6
  shift 6
  "$program" play "$sequence" --fps "$fps" --sheet "$pictures/strip_$name.png" --columns "$columns" --size "$size" \
    --view "$view" --theme light "$@"
}

organ heart anterior,left,posterior
python3 "$source/resources/scripts/draw_heart_cuts.py" "$program" "$pictures"
organ stomach anterior,posterior,superior
organ liver anterior,posterior,inferior
organ kidney_left anterior,left,posterior
organ kidney_right anterior,right,posterior
organ stomach_and_bowel anterior,left,posterior
organ digestive_system anterior,left,posterior
strip heartbeat heartbeat 10 4 340x260 anterior
strip peristalsis peristalsis 0.4 4 340x260 anterior
strip breathing breathing 1 4 340x260 anterior

# The same motions on surfaces of other organs: the program's own files stand in for a patient's.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" sample heart@low -o "$work/heart.stl"
"$program" sample stomach@low -o "$work/stomach.stl"
strip retargeted_heart heartbeat 10 4 340x260 anterior --organ "$work/heart.stl"
strip retargeted_stomach peristalsis 0.4 4 340x260 anterior --organ "$work/stomach.stl"

# The measured motions of docs/patient_motion.md, by the tests that hold them; the window's need a display, and the series of surfaces.
tests=$(dirname "$program")
if [ -n "${DISPLAY:-}" ]; then
  "$program" --fresh-settings --mode play --theme dark --window-size 1600x1000 --screenshot "$pictures/window_heart.png"
fi
if [ -x "$tests/test_motion_pictures" ]; then
  VISCERA_UPDATE_PICTURES=1 "$tests/test_motion_pictures" --gtest_brief=1
fi
if [ -x "$tests/gui_tests" ] && [ -n "${DISPLAY:-}" ]; then
  VISCERA_UPDATE_PICTURES=1 "$tests/gui_tests" --gtest_brief=1 --gtest_filter='RealSeries.Takes*'
fi
