#pragma once

namespace viscera::medical_io {

/// DCMTK writes what it finds odd to stderr; errors come back as conditions all the same. For any number of
/// calls from any thread.
void silenceDcmtk();

} // namespace viscera::medical_io
