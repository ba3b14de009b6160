#!/usr/bin/env bash
# Draws the window in every mode and language at 1280x800, at 100 and at 200 %, for a person to look at: whether a text is cut
# off, breaks badly or is still English. Writes FOLDER/<language>_<mode>_<percent>.png and FOLDER/index.html, which shows the
# languages side by side.
#   resources/scripts/make_language_pictures.sh [--languages "de es"] [--modes "play"] [--scales "100"] [--theme light] [FOLDER [PROGRAM]]
# FOLDER: build/language_pictures unless another is named; PROGRAM: build/release/bin/viscera. Needs xvfb.
set -euo pipefail
source=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
readonly source size=1280x800
languages="en de es fr ca" modes="explore handles deform stress play" scales="100 200" theme=dark

die() {
  echo "make_language_pictures.sh: $1" >&2
  exit "$2"
}

while [[ ${1:-} == --* ]]; do
  [ "$#" -ge 2 ] || die "$1 needs a value" 64
  case $1 in
    --languages) languages=$2 ;;
    --modes) modes=$2 ;;
    --scales) scales=$2 ;;
    --theme) theme=$2 ;;
    *) die "there is no option $1" 64 ;;
  esac
  shift 2
done
folder=${1:-$source/build/language_pictures}
program=${2:-$source/build/release/bin/viscera}
[ -x "$program" ] || die "there is no program $program; ./run.sh --build-only makes one" 66
command -v xvfb-run >/dev/null || die "xvfb-run is missing. As root: apt-get install xvfb xauth" 69
mkdir -p "$folder"

# picture LANGUAGE MODE PERCENT: on a screen that has room for the window at that scale.
picture() {
  local language=$1 mode=$2 percent=$3
  local file=$folder/${language}_${mode}_$percent.png factor
  factor=$(printf '%d.%02d' $((percent / 100)) $((percent % 100)))
  QT_SCALE_FACTOR=$factor QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
    xvfb-run --auto-servernum --server-args '-screen 0 3840x2400x24' \
    "$program" --fresh-settings --language "$language" --mode "$mode" --theme "$theme" --window-size "$size" --screenshot "$file"
  echo "$file"
}

# One row for each mode and scale, with the languages beside each other; a click shows a picture in its own size.
write_page() {
  local language mode percent name
  echo '<!DOCTYPE html><meta charset="utf-8"><title>The window in every language</title>'
  echo '<style>body { font-family: sans-serif } div { display: flex; gap: 8px } img { width: 800px }</style>'
  for percent in $scales; do
    for mode in $modes; do
      echo "<h2>$mode, $percent %</h2><div>"
      for language in $languages; do
        name=${language}_${mode}_$percent.png
        echo "<figure><a href=\"$name\"><img src=\"$name\" alt=\"$name\"></a><figcaption>$language</figcaption></figure>"
      done
      echo '</div>'
    done
  done
}

for percent in $scales; do
  for mode in $modes; do
    for language in $languages; do
      picture "$language" "$mode" "$percent"
    done
  done
done
write_page >"$folder/index.html"
echo "Look at $folder/index.html"
