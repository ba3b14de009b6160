#!/bin/sh
# Brings resources/translations/viscera_*.ts to the texts of the sources: new ones come without a translation, to be
# filled in by hand or with Qt Linguist; those that are gone leave. names_*.ts are kept by hand: what the numerical
# modules say, which know no Qt, and what several classes of the window say, which share_translations.py puts there.
# viscera_en.ts has the plurals of English texts alone; the test Translations says what is missing in either.
set -eu
cd "$(dirname "$0")/../.."
for language in ca de es fr; do
  lupdate -silent -no-obsolete -locations none app modules -ts "resources/translations/viscera_$language.ts"
done
resources/scripts/share_translations.py
lupdate -silent -no-obsolete -locations none -pluralonly app modules -ts resources/translations/viscera_en.ts
