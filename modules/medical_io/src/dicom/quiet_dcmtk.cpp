#include "viscera/medical_io/quiet_dcmtk.h"

#include <mutex>

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/oflog/oflog.h>

namespace viscera::medical_io {

void silenceDcmtk() {
  static std::once_flag once;
  std::call_once(once, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
}

} // namespace viscera::medical_io
