#!/usr/bin/env bash
# lintian_is_needed.sh ROOT: where there is no lintian, the packages are not tried unless that was asked for.
set -euo pipefail
readonly script=$1/resources/scripts/try_packages.sh
stubs=$(mktemp -d)
readonly stubs
trap 'rm -rf -- "$stubs"' EXIT
ln -s "$(command -v dirname)" "$stubs/dirname"
printf '#!/bin/sh\necho 1000\n' >"$stubs/id" # Not root, so that nothing begins.
chmod +x "$stubs/id"

# expect CODE WORD [VARIABLE=VALUE]: the script ends with that code and says the word.
expect() {
  local code=0 said
  said=$(env -i PATH="$stubs" "${@:3}" "$BASH" "$script" 2>&1) || code=$?
  if [ "$code" -ne "$1" ] || [[ $said != *"$2"* ]]; then
    echo "with '${*:3}' it ends with $code, not $1: $said"
    exit 1
  fi
}

expect 69 lintian
expect 69 lintian WITHOUT_LINTIAN=
expect 77 root WITHOUT_LINTIAN=1
