#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dicom_slices.h"

/// Writes DICOM segmentations byte by byte, of the forms that DCMTK's module for them does not write.
namespace viscera::tests {

/// Options of a segmentation for tests.
struct SegmentWriting {
  std::string type = "BINARY"; ///< Or "FRACTIONAL", "LABELMAP".
  int bits = 1;                ///< Allocated: 1, 8 or 16.
  int inside = 1;              ///< The value of a voxel of a mask.
  int background = 0;          ///< Of a label map; another than 0 is stated as padding.
  std::map<int, std::string> names = {};
  std::string characterSet = {};
  std::string frameOfReference = "1.2.9";
  std::string referencedSeries = {};   ///< Empty: none.
  std::string referencedInstance = {}; ///< Of the first frame's source; empty: none.
  std::set<int> slices = {};           ///< Those that are written; empty: all.
  int phases = 1;                      ///< So many times, each time with its temporal position.
  std::vector<LabelImage> later = {};  ///< What the phases after the first show; empty: the same.
  double stepSeconds = 0;              ///< Between temporal positions; 0: not stated.
};

inline std::set<int> labelsOf(const LabelImage& image) {
  std::set<int> labels(image.voxels.begin(), image.voxels.end());
  labels.erase(0);
  return labels;
}

/// A frame of a segmentation: its values, its slice and its segment (0 in a label map).
struct SegmentFrame {
  std::vector<int> values;
  int slice = 0, segment = 0, phase = 1;
};

inline std::vector<SegmentFrame> segmentFrames(const LabelImage& image, const SegmentWriting& writing) {
  const std::size_t pixels = std::size_t(image.size[0]) * std::size_t(image.size[1]);
  const bool isLabelMap = writing.type == "LABELMAP";
  std::vector<SegmentFrame> frames;
  for (const int label : isLabelMap ? std::set<int>{0} : labelsOf(image))
    for (int k = 0; k < image.size[2]; ++k) {
      if (!writing.slices.empty() && !writing.slices.contains(k))
        continue;
      for (int phase = 1; phase <= writing.phases; ++phase) {
        const LabelImage& shown =
            phase == 1 || writing.later.empty() ? image : writing.later[std::size_t(phase) - 2];
        SegmentFrame frame{std::vector<int>(pixels), k, label, phase};
        for (std::size_t p = 0; p < pixels; ++p) {
          const int voxel = shown.voxels[std::size_t(k) * pixels + p];
          frame.values[p] =
              isLabelMap ? (voxel == 0 ? writing.background : voxel) : (voxel == label ? writing.inside : 0);
        }
        frames.push_back(std::move(frame));
      }
    }
  return frames;
}

/// Eight pixels a byte, the first one lowest.
inline std::string packedBits(const std::vector<int>& values) {
  std::string bytes((values.size() + 7) / 8, '\0');
  for (std::size_t p = 0; p < values.size(); ++p)
    if (values[p] != 0)
      bytes[p / 8] = static_cast<char>(bytes[p / 8] | 1 << (p % 8));
  return bytes;
}

/// The data set without pixels.
inline DicomElements segmentationHeader(const LabelImage& image, const SegmentWriting& writing) {
  const Vec3 spacing = image.indexToLps.linear().colwise().norm();
  const Vec3 row = image.indexToLps.linear().col(0) / spacing[0];
  const Vec3 column = image.indexToLps.linear().col(1) / spacing[1];
  std::string segments = "SQ", frames = "SQ";
  for (const int label : labelsOf(image)) {
    DicomElements segment = {{0x00620004, us(label)}, {0x00620008, "CSMANUAL"}};
    segment[0x00620005] = "LO" + (writing.names.contains(label) ? writing.names.at(label) : std::string("?"));
    segments += dicomItem(segment);
  }
  std::size_t count = 0;
  for (const SegmentFrame& frame : segmentFrames(image, writing)) {
    DicomElements groups = {
        {0x00209113,
         "SQ" + dicomItem({{0x00200032, "DS" + decimals(image.indexToLps * Vec3(0, 0, frame.slice))}})}};
    if (writing.phases > 1)
      groups[0x00209111] =
          "SQ" + dicomItem({{0x00209128, "UL" + littleEndian(std::uint64_t(frame.phase), 4)}});
    if (writing.stepSeconds > 0)
      groups[0x00209310] =
          "SQ" + dicomItem({{0x0020930D, "FD" + littleEndian(std::bit_cast<std::uint64_t>(
                                                                 writing.stepSeconds * (frame.phase - 1)),
                                                             8)}});
    if (frame.segment > 0)
      groups[0x0062000A] = "SQ" + dicomItem({{0x0062000B, us(frame.segment)}});
    if (count == 0 && !writing.referencedInstance.empty())
      groups[0x00089124] =
          "SQ" +
          dicomItem({{0x00082112, "SQ" + dicomItem({{0x00081155, "UI" + writing.referencedInstance}})}});
    frames += dicomItem(groups);
    ++count;
  }
  DicomElements e = {
      {0x00080016,
       writing.type == "LABELMAP" ? "UI1.2.840.10008.5.1.4.1.1.66.7" : "UI1.2.840.10008.5.1.4.1.1.66.4"},
      {0x00080018, "UI1.2.7.1"},
      {0x00080060, "CSSEG"},
      {0x0020000D, "UI1.2.3"},
      {0x0020000E, "UI1.2.7"},
      {0x00200052, "UI" + writing.frameOfReference},
      {0x00280002, us(1)},
      {0x00280004, "CSMONOCHROME2"},
      {0x00280008, "IS" + std::to_string(count)},
      {0x00280010, us(image.size[1])},
      {0x00280011, us(image.size[0])},
      {0x00280100, us(writing.bits)},
      {0x00280101, us(writing.bits)},
      {0x00280102, us(writing.bits - 1)},
      {0x00280103, us(0)},
      {0x00620001, "CS" + writing.type},
      {0x00620002, segments},
      {0x52009229,
       "SQ" + dicomItem({{0x00209116,
                          "SQ" + dicomItem({{0x00200037, "DS" + decimals(row) + '\\' + decimals(column)}})},
                         {0x00289110, "SQ" + dicomItem({{0x00180050, "DS" + decimal(spacing[2])},
                                                        {0x00180088, "DS" + decimal(spacing[2])},
                                                        {0x00280030, "DS" + decimal(spacing[1]) + '\\' +
                                                                         decimal(spacing[0])}})}})},
      {0x52009230, frames}};
  if (!writing.characterSet.empty())
    e[0x00080005] = "CS" + writing.characterSet;
  if (writing.type == "FRACTIONAL")
    e[0x0062000E] = us(255);
  if (writing.background != 0)
    e[0x00280120] = us(writing.background);
  if (!writing.referencedSeries.empty())
    e[0x00081115] = "SQ" + dicomItem({{0x0020000E, "UI" + writing.referencedSeries}});
  return e;
}

/// The data set, its pixels not packed.
inline DicomElements segmentationElements(const LabelImage& image, const SegmentWriting& writing) {
  DicomElements e = segmentationHeader(image, writing);
  std::vector<int> values;
  for (const SegmentFrame& frame : segmentFrames(image, writing))
    values.insert(values.end(), frame.values.begin(), frame.values.end());
  std::string bytes;
  if (writing.bits == 1)
    bytes = packedBits(values);
  else
    for (const int value : values)
      bytes += littleEndian(std::uint64_t(value), writing.bits / 8);
  e[0x7FE00010] = (writing.bits == 16 ? "OW" : "OB") + bytes;
  return e;
}

/// One segment of RLE (PS3.5, annex G) that has each byte as it is.
inline std::string rleFrame(const std::string& bytes) {
  std::string packed = littleEndian(1, 4) + littleEndian(64, 4) + std::string(56, '\0');
  for (std::size_t at = 0; at < bytes.size(); at += 128) {
    const std::string part = bytes.substr(at, 128);
    packed += static_cast<char>(part.size() - 1) + part;
  }
  return packed + std::string(packed.size() % 2, '\0');
}

/// A file with frames of one bit in RLE, each frame by itself: eight pixels a byte, or a byte for each.
inline std::string rleBits(const LabelImage& image, const SegmentWriting& writing, bool byteEach) {
  std::string pixels = littleEndian(0x7FE0, 2) + littleEndian(0x0010, 2) + std::string("OB\0\0", 4) +
                       littleEndian(0xFFFFFFFF, 4);
  const auto addItem = [&](const std::string& bytes) {
    pixels += littleEndian(0xFFFE, 2) + littleEndian(0xE000, 2) + littleEndian(bytes.size(), 4) + bytes;
  };
  addItem("");
  for (const SegmentFrame& frame : segmentFrames(image, writing))
    addItem(rleFrame(byteEach ? std::string(frame.values.begin(), frame.values.end())
                              : packedBits(frame.values)));
  pixels += littleEndian(0xFFFE, 2) + littleEndian(0xE0DD, 2) + littleEndian(0, 4);
  return dicomBytes(segmentationHeader(image, writing), "1.2.840.10008.1.2.5") + pixels;
}

} // namespace viscera::tests
