#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image_formats/raw_image.h"

namespace viscera::medical_io {

/// Names and colours of labels from a file beside the label map.
struct LabelTable {
  std::filesystem::path file; ///< Empty: there was none.
  std::vector<StatedSegment> segments;
};

/// Looks beside the label map `file` (NAME.nii.gz, say) for NAME.ctbl, NAME.txt, NAME.json, NAME_colors.ctbl,
/// the same without an ending _seg, _label or _labels of NAME, labels.txt, dataset.json and the only .ctbl of
/// the folder, in this order, and reads the first that holds a table: 3D Slicer's (number, name, red, green,
/// blue), ITK-SNAP's (number, three colours, three switches, "name"), or a JSON object that maps numbers to
/// names or names to numbers, as a whole or under "labels". Files that hold no table are passed over.
LabelTable findLabelTable(const std::filesystem::path& file);

} // namespace viscera::medical_io
