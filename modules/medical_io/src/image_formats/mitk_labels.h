#pragma once

#include <map>
#include <string>

#include "image_formats/raw_image.h"

namespace viscera::medical_io {

/// Reads the labels of a segmentation of MITK from the keys of its NRRD header, as `raw.stated`; each group
/// of labels is a layer of its own. The newer form is JSON in `org.mitk.multilabel.segmentation.labelgroups`,
/// the older one `org.mitk.image.multilabel` XML in `org.mitk.label_LAYER_LABEL`. Labels that cannot be read
/// are said in `raw.warnings`. Does nothing for other files. Does not throw.
void readMitkLabels(const std::map<std::string, std::string>& keys, RawImage& raw);

} // namespace viscera::medical_io
