#pragma once

#include <string>

namespace viscera::tests {

/// Begins to collect the warnings and errors of Qt and VTK instead of printing them.
void keepPrinted();
/// The messages collected since the last call; empty for none.
std::string takePrinted();

} // namespace viscera::tests
