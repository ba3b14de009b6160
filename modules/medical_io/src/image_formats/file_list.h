#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.h"
#include "text_scanner.h"

/// The names of several data files in the headers of NRRD and MetaImage.
namespace viscera::medical_io {

/// Whether the value of the field says that the names follow, one a line: "LIST", "LIST 2".
bool isListOfFiles(std::string_view field);

/// The names on the lines that are left.
std::vector<std::string> namesOfFiles(TextScanner& scanner);

/// The names that "slice%03d.raw 1 30 1" stands for, as in `printf`: first number, last number and step; a
/// fourth number, the dimensions of each file, may follow. Empty for a field of another form, such as the
/// name of one file. Throws `DataError` naming `file` for numbers that lead nowhere, and for more than 65,535
/// files.
std::vector<std::string> filesOfPattern(const FileBytes& file, std::string_view field);

} // namespace viscera::medical_io
