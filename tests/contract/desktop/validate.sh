#!/usr/bin/env bash
# validate.sh desktop|metainfo|mime|translations FOLDER: ends with 77 where the validator is not installed.
set -euo pipefail
readonly kind=$1 folder=$2

need() {
  command -v "$1" >/dev/null || {
    echo "skipped: $1 is not installed ($2)"
    exit 77
  }
}

case $kind in
  desktop)
    need desktop-file-validate desktop-file-utils
    said=$(desktop-file-validate "$folder/org.viscera.Viscera.desktop" 2>&1) || true
    [ -z "$said" ] || { echo "$said"; exit 1; }
    ;;
  metainfo)
    need appstreamcli appstream
    appstreamcli validate --no-net --pedantic "$folder/org.viscera.Viscera.metainfo.xml"
    ;;
  mime)
    need update-mime-database shared-mime-info
    work=$(mktemp -d)
    trap 'rm -rf -- "$work"' EXIT
    mkdir -p "$work/mime/packages"
    cp "$folder/org.viscera.Viscera.mime.xml" "$work/mime/packages/"
    said=$(XDG_DATA_HOME=$work PKGSYSTEM_ENABLE_FSYNC=0 update-mime-database "$work/mime" 2>&1) || { echo "$said"; exit 1; }
    [ -z "$said" ] || { echo "$said"; exit 1; }
    grep -q 'application/x-viscera-session+json:\*\.viscera' "$work/mime/globs2" ||
      { echo "*.viscera is no session"; exit 1; }
    for glob in nifti:*.nii nifti:*.nii.gz nrrd:*.nrrd nrrd:*.nhdr metaimage:*.mha metaimage:*.mhd; do
      grep -qF "application/x-viscera-$glob" "$work/mime/globs2" || { echo "$glob is described nowhere"; exit 1; }
      grep -q "^MimeType=.*application/x-viscera-${glob%%:*};" "$folder/org.viscera.Viscera.desktop" ||
        { echo "the desktop entry does not open $glob"; exit 1; }
    done
    grep -q '^MimeType=.*;application/dicom;' "$folder/org.viscera.Viscera.desktop" ||
      { echo "the desktop entry does not open DICOM files"; exit 1; }
    # Each type that the desktop entry names and that is ours is described here.
    for type in $(grep '^MimeType=' "$folder/org.viscera.Viscera.desktop" | cut -d= -f2 | tr ';' '\n' | grep x-viscera); do
      grep -q "^$type$" "$work/mime/types" || { echo "$type is described nowhere"; exit 1; }
    done
    ;;
  translations)
    # Each text of the three files, in each language of the window.
    for language in ca de es fr; do
      for key in GenericName Comment Keywords; do
        grep -q "^$key\[$language\]=" "$folder/org.viscera.Viscera.desktop" || { echo "$key has no $language"; exit 1; }
      done
      for text in mime:comment metainfo:summary metainfo:p; do
        file=$folder/org.viscera.Viscera.${text%%:*}.xml tag=${text##*:}
        all=$(grep -c "<$tag>" "$file") said=$(grep -c "<$tag xml:lang=\"$language\">" "$file") || true
        [ "$all" = "$said" ] || { echo "$file: $said of $all <$tag> in $language"; exit 1; }
      done
    done
    ;;
esac
