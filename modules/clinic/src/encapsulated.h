#pragma once

#include <string>
#include <string_view>

#include "dicom_object.h"

namespace viscera::clinic {

/// The document that an object carries, with its title and times (PS3.3, C.24.2).
void putEncapsulated(DcmDataset& dataset, const ObjectSeries& series, const std::string& title,
                     const std::string& mimeType, std::string_view bytes);

} // namespace viscera::clinic
