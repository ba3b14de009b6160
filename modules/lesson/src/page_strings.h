#pragma once

#include <map>
#include <string>

namespace viscera::lesson {

/// A text in the language of the program (`QCoreApplication::translate`, context "Lesson").
std::string said(const char* text);

/// Everything that the page itself says, by the names under which its script asks for it.
std::map<std::string, std::string> pageStrings();

} // namespace viscera::lesson
