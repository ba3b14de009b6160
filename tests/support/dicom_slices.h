#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

#include "label_files.h"

/// Writes slices of a scan as DICOM files, byte by byte, independently of the program's readers.
namespace viscera::tests {

/// Data elements in the order of their tags, 0xggggeeee; a value with the two letters of its type before it.
using DicomElements = std::map<std::uint32_t, std::string>;

inline std::string littleEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i)
    text += char(value >> (8 * i) & 0xFFU);
  return text;
}

inline std::string us(int value) {
  return "US" + littleEndian(std::uint64_t(value), 2);
}

inline std::string decimal(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return buffer;
}

inline std::string decimals(const Vec3& v) {
  return decimal(v.x()) + '\\' + decimal(v.y()) + '\\' + decimal(v.z());
}

/// With its header; values are filled to an even length.
inline std::string dicomElement(std::uint32_t tag, const std::string& typed) {
  const std::string type = typed.substr(0, 2);
  std::string value = typed.substr(2);
  if (value.size() % 2 != 0)
    value += type == "UI" || type == "OB" ? '\0' : ' ';
  const std::string head = littleEndian(tag >> 16U, 2) + littleEndian(tag & 0xFFFFU, 2) + type;
  const bool isLong = type == "OB" || type == "OW" || type == "SQ" || type == "UN" || type == "UT";
  return head +
         (isLong ? std::string(2, '\0') + littleEndian(value.size(), 4) : littleEndian(value.size(), 2)) +
         value;
}

inline std::string dicomElements(const DicomElements& elements) {
  std::string bytes;
  for (const auto& [tag, typed] : elements)
    bytes += dicomElement(tag, typed);
  return bytes;
}

/// One item of a sequence; several follow each other behind "SQ".
inline std::string dicomItem(const DicomElements& elements) {
  const std::string bytes = dicomElements(elements);
  return littleEndian(0xFFFE, 2) + littleEndian(0xE000, 2) + littleEndian(bytes.size(), 4) + bytes;
}

/// Preamble, mark, group 2 and the data set, explicit little-endian.
inline std::string dicomBytes(const DicomElements& elements,
                              const std::string& syntax = "1.2.840.10008.1.2.1") {
  const auto textOf = [&](std::uint32_t tag) { return elements.contains(tag) ? elements.at(tag) : "UI"; };
  const DicomElements group = {{0x00020001, "OB" + std::string("\0\1", 2)},
                               {0x00020002, textOf(0x00080016)},
                               {0x00020003, textOf(0x00080018)},
                               {0x00020010, "UI" + syntax},
                               {0x00020012, "UI1.2.3"}};
  const std::string meta = dicomElements(group);
  return std::string(128, '\0') + "DICM" + dicomElement(0x00020000, "UL" + littleEndian(meta.size(), 4)) +
         meta + dicomElements(elements);
}

constexpr double kDicomIntercept = -1024;

/// A CT slice: layer k of `image`, whose values are stored above -1024 without a sign.
inline DicomElements dicomSlice(const LabelImage& image, int k, const std::string& series = "1.2.3.4") {
  const Vec3 spacing = image.indexToLps.linear().colwise().norm();
  const Vec3 row = image.indexToLps.linear().col(0) / spacing[0];
  const Vec3 column = image.indexToLps.linear().col(1) / spacing[1];
  const std::size_t pixels = std::size_t(image.size[0]) * std::size_t(image.size[1]);
  std::string bytes;
  for (std::size_t p = 0; p < pixels; ++p)
    bytes += littleEndian(std::uint64_t(image.voxels[std::size_t(k) * pixels + p] - int(kDicomIntercept)), 2);
  const std::string number = std::to_string(k + 1);
  return {{0x00080016, "UI1.2.840.10008.5.1.4.1.1.2"},
          {0x00080018, "UI" + series + "." + number},
          {0x00080060, "CSCT"},
          {0x0008103E, "LOAbdomen 5.0"},
          {0x00100010, "PNDoe^Jane"},
          {0x00180050, "DS" + decimal(99)}, // SliceThickness lies.
          {0x0020000D, "UI1.2.3"},
          {0x0020000E, "UI" + series},
          {0x00200013, "IS" + number},
          {0x00200032, "DS" + decimals(image.indexToLps * Vec3(0, 0, k))},
          {0x00200037, "DS" + decimals(row) + '\\' + decimals(column)},
          {0x00280002, us(1)},
          {0x00280004, "CSMONOCHROME2"},
          {0x00280010, us(image.size[1])},
          {0x00280011, us(image.size[0])},
          {0x00280030, "DS" + decimal(spacing[1]) + '\\' + decimal(spacing[0])},
          {0x00280100, us(16)},
          {0x00280101, us(16)},
          {0x00280102, us(15)},
          {0x00280103, us(0)},
          {0x00281050, "DS40"},
          {0x00281051, "DS400"},
          {0x00281052, "DS" + decimal(kDicomIntercept)},
          {0x00281053, "DS1"},
          {0x7FE00010, "OW" + bytes}};
}

/// All layers of `image` as one enhanced multi-frame CT, whose frames run from the head down.
inline DicomElements enhancedDicom(const LabelImage& image) {
  DicomElements e = dicomSlice(image, 0);
  std::string pixels = "OW", frames = "SQ";
  for (int k = image.size[2] - 1; k >= 0; --k) {
    const DicomElements slice = dicomSlice(image, k);
    pixels += slice.at(0x7FE00010).substr(2);
    frames += dicomItem({{0x00209113, "SQ" + dicomItem({{0x00200032, slice.at(0x00200032)}})}});
  }
  const std::string shared =
      "SQ" + dicomItem({{0x00209116, "SQ" + dicomItem({{0x00200037, e[0x00200037]}})},
                        {0x00289110, "SQ" + dicomItem({{0x00280030, e[0x00280030]}})},
                        {0x00289145, "SQ" + dicomItem({{0x00281052, "DS-1024"}, {0x00281053, "DS1"}})}});
  for (const std::uint32_t flat : {0x00200032U, 0x00200037U, 0x00280030U, 0x00281052U, 0x00281053U})
    e.erase(flat);
  e[0x00080016] = "UI1.2.840.10008.5.1.4.1.1.2.1";
  e[0x00280008] = "IS" + std::to_string(image.size[2]);
  e[0x52009229] = shared;
  e[0x52009230] = frames;
  e[0x7FE00010] = pixels;
  return e;
}

} // namespace viscera::tests
