#!/usr/bin/env bash
# optional_packages.sh ROOT: run.sh asks for the packages that only add to the program, and goes on without them.
set -euo pipefail
readonly root=$1
stubs=$(mktemp -d)
readonly stubs log=$stubs/log
trap 'rm -rf -- "$stubs"' EXIT

# stub NAME BODY: a program of that name for the scripts.
stub() {
  printf '#!/bin/sh\n%s\n' "$2" >"$stubs/$1"
  chmod +x "$stubs/$1"
}

die() {
  echo "$1"
  exit 1
}

stub id 'echo 0'
stub apt-get "echo \"\$@\" >>$log; exit 100"
PATH=$stubs:$PATH
# shellcheck source=/dev/null
source "$root/resources/scripts/prepare.sh"

mapfile -t packages < <(packages_to_run_if_there)
[[ " ${packages[*]} " == *' qttranslations5-l10n '* ]] || die "Qt's own texts in other languages are not asked for"
for script in run.sh test.sh; do
  grep -q packages_to_run_if_there "$root/$script" || die "$script does not ask for them"
done

stub dpkg-query 'echo not-installed'
stub apt-cache 'exit 0'
said=$(install_if_there "${packages[@]}" 2>&1) || die "it ends where the lists do not know them"
[ ! -e "$log" ] || die "it installs what the lists do not know: $(cat "$log")"
[ -z "$said" ] || die "it speaks of what is not there: $said"

stub apt-cache 'echo Package: it'
said=$(install_if_there "${packages[@]}" 2>&1) || die "it ends where they cannot be installed"
grep -q "install.*${packages[0]}" "$log" || die "it does not try to install them"
[[ $said == *"Going on without: ${packages[0]}"* ]] || die "it does not say that they are missing: $said"

rm "$log"
stub dpkg-query 'echo installed'
install_if_there "${packages[@]}" || die "it ends where they are installed"
[ ! -e "$log" ] || die "it installs what is there"
