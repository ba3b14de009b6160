#pragma once

#include <string>

#include "dicom_slices.h"

namespace viscera::tests {

/// A slice as `dicomSlice`, with all that says whose it is: Jane Doe, her study, and who sent her.
inline DicomElements identifiedSlice(const LabelImage& image, int k) {
  DicomElements slice = dicomSlice(image, k, "1.2.840.4711.2");
  slice[0x00080020] = "DA20240301";
  slice[0x00080030] = "TM093017";
  slice[0x00080050] = "SHACC4711";
  slice[0x00080090] = "PNHouse^Gregory";
  slice[0x00081030] = "LOAbdomen of Jane";
  slice[0x00100020] = "LOPID0815";
  slice[0x00100030] = "DA19700131";
  slice[0x00100040] = "CSF";
  slice[0x0020000D] = "UI1.2.840.4711.1";
  slice[0x00200010] = "SHS1";
  slice[0x00200052] = "UI1.2.840.4711.9";
  return slice;
}

} // namespace viscera::tests
