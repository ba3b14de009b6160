#pragma once

namespace viscera::medical_io {

/// Stops DCMTK from writing warnings to stderr; errors are still returned as conditions. May be called
/// repeatedly, from any thread.
void silenceDcmtk();

} // namespace viscera::medical_io
