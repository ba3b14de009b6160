#!/usr/bin/env bash
# Asks the installed completion of bash for what a user would see after the Tab key. resources/scripts/try_packages.sh runs it
# in a fresh system, where the package bash-completion finds and loads the file.
# shellcheck source=/dev/null
source /usr/share/bash-completion/bash_completion
_completion_loader viscera
complete -p viscera >/dev/null || exit 1

# expect WANTED LINE: where the last word of LINE is being typed, these words are offered.
expect() {
  local wanted=$1 offered
  COMP_LINE=$2 COMP_POINT=${#2}
  read -ra COMP_WORDS <<<"$COMP_LINE"
  [[ $COMP_LINE != *' ' ]] || COMP_WORDS+=('')
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMPREPLY=()
  _viscera
  offered=$(printf '%s\n' "${COMPREPLY[@]}" | sort | paste -sd ' ')
  [ "$offered" = "$wanted" ] || { echo "after '$COMP_LINE' come '$offered', not '$wanted'"; exit 1; }
  echo "$COMP_LINE -> $offered"
}

expect 'play' 'viscera pla'
expect '--theme --threads' 'viscera play --th'
expect 'dark light' 'viscera play --theme '
