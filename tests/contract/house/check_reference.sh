#!/usr/bin/env bash
# check_reference.sh SOURCE_DIRECTORY WORK_DIRECTORY: fails when doxygen warns of a public header or a page of docs.
set -euo pipefail
readonly source=$1 work=$2
# Each version warns of something else; this is Debian 12's.
case $(doxygen --version 2>/dev/null) in
  1.9.4*) ;;
  *)
    echo "skipped: there is no doxygen 1.9.4"
    exit 77
    ;;
esac
rm -rf -- "$work"
mkdir -p "$work"
trap 'rm -rf -- "$work"' EXIT
cd -- "$source"
{
  cat resources/Doxyfile
  printf 'OUTPUT_DIRECTORY = "%s"\n' "$work"
} | doxygen -
pages=("$work"/html/*.html)
[ "${#pages[@]}" -gt 1000 ] || { echo "doxygen wrote ${#pages[@]} pages"; exit 1; }
echo "${#pages[@]} pages without a warning"
