#pragma once

#include <string>

#include "viscera/core/phrase.h"
#include "viscera/document/organ.h"

namespace viscera::report {

/// Translates a text into the language of the program, by the same translations that the window uses for
/// names of the numerical modules (resources/translations/names_*.ts).
std::string said(const char* text);
/// The same with `first` and `second` in the places of %1 and %2.
std::string said(const char* text, const std::string& first, const std::string& second = {});

/// Likewise of a name (a system, a quantity); unchanged when it has no translation.
std::string named(const std::string& name);
/// Likewise of a text with its parts: a warning, an obstacle, the name of a sequence.
std::string inWords(const Text& text);

/// A change with its sign: "+1.3", "-0.4"; one that the digits do not show is "0.0".
std::string signedNumber(double value, int digits);

/// A text without the folders of the files that it names: "/home/ann/liver.stl" becomes "liver.stl".
std::string withoutFolders(const std::string& text);

/// The title of an organ in a report: "LV cavity".
std::string titleOf(const document::Organ& organ);

} // namespace viscera::report
