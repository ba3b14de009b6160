#pragma once

namespace viscera::python {

/// From now on errors of C++ arrive in Python as the classes of `viscera.errors`, with all that they carry.
/// Once, when the first extension is loaded; holds for all of them.
void translateErrors();

} // namespace viscera::python
