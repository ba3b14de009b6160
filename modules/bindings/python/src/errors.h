#pragma once

namespace viscera::python {

/// Registers the translation of C++ errors to the classes of `viscera.errors`, with all their attributes.
/// Call it once, when the first extension is loaded; it applies to all extensions.
void translateErrors();

} // namespace viscera::python
