#!/usr/bin/env bash
# check_format.sh SOURCE_DIRECTORY: fails and says how when a source of ours is not formatted as .clang-format says.
set -euo pipefail
cd -- "$1"
if ! command -v clang-format-14 >/dev/null; then
  echo "skipped: there is no clang-format-14"
  exit 77
fi
mapfile -d '' -t sources < <(find app modules tests \( -name '*.h' -o -name '*.cpp' \) -print0 | sort --zero-terminated)
[ "${#sources[@]}" -gt 0 ] || { echo "there are no sources"; exit 1; }
# Sixteen files at a time, on all processors: starting the program costs more than a file does.
mapfile -t bad < <(printf '%s\0' "${sources[@]}" |
  { xargs --null --max-args=16 --max-procs="$(nproc)" clang-format-14 --style=file --dry-run 2>&1 || true; } |
  sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: warning: .*/\1/p' | sort --unique)
if [ "${#bad[@]}" -gt 0 ]; then
  echo "These files are not formatted; run clang-format-14 -i on them:"
  printf '  %s\n' "${bad[@]}"
  exit 1
fi
echo "${#sources[@]} files are formatted"
