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
bad=()
for source in "${sources[@]}"; do
  clang-format-14 --style=file "$source" | cmp --silent - "$source" || bad+=("$source")
done
if [ "${#bad[@]}" -gt 0 ]; then
  echo "These files are not formatted; run clang-format-14 -i on them:"
  printf '  %s\n' "${bad[@]}"
  exit 1
fi
echo "${#sources[@]} files are formatted"
