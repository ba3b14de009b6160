#include "label_formats/raw_labels.h"

namespace viscera::medical_io {

RawLabels readDicomSegmentation(FileBytes& file) {
  file.fail("DICOM segmentations are not read yet", "convert it to .seg.nrrd");
}

} // namespace viscera::medical_io
