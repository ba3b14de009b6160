#pragma once

#include <string>

namespace viscera::tests {

/// From now on keeps the warnings and errors of Qt and VTK instead of printing them.
void keepPrinted();
/// What was kept since the last call; empty when nothing was.
std::string takePrinted();

} // namespace viscera::tests
