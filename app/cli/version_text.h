#pragma once

#include <string>

namespace viscera::app::cli {

/// The text that `viscera --version` prints: the program's version in the first line ("viscera 0.1.0"), then
/// a line for each library that it was built with or has loaded ("VTK 9.1.0"), then the compiler. VTK and Qt
/// are asked at run time, because a system may have replaced them since the build.
std::string versionText();

} // namespace viscera::app::cli
