#pragma once

#include <string>

#include "viscera/document/organ.h"

namespace viscera::report {

/// A text in the language of the program, as the window translates names of the numerical modules
/// (resources/translations/names_*.ts).
std::string said(const char* text);
/// The same with `first` and `second` in the places of %1 and %2.
std::string said(const char* text, const std::string& first, const std::string& second = {});

/// Likewise of a name (a system, a sequence, a phase, a quantity); as it is when it has no translation.
std::string named(const std::string& name);
/// Likewise of a text that is put together from parts (viscera/core/phrase.h): a warning, an obstacle.
std::string messageInWords(const std::string& message);

/// A change with its sign: "+1.3", "-0.4"; one that the digits do not show is "0.0".
std::string signedNumber(double value, int digits);

/// A text without the folders of the files that it names: "/home/ann/liver.stl" becomes "liver.stl".
std::string withoutFolders(const std::string& text);

/// What a reader calls an organ: "LV cavity".
std::string titleOf(const document::Organ& organ);

} // namespace viscera::report
