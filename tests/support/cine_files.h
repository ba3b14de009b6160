#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "viscera/tracking/cine_images.h"

/// A cine study on disk, for tests of modules that have no readers below them.
namespace viscera::tests {

/// The elements of one uncompressed DICOM file (explicit VR, little endian), those within sequences left out.
class PlainDicom {
public:
  explicit PlainDicom(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
    for (std::size_t at = 132; at + 8 <= bytes_.size();)
      at = readElement(at);
  }

  std::string text(std::uint16_t group, std::uint16_t element) const {
    const auto found = elements_.find({group, element});
    return found == elements_.end() ? std::string()
                                    : bytes_.substr(found->second.first, found->second.second);
  }
  /// Numbers in decimals that backslashes separate.
  std::vector<double> numbers(std::uint16_t group, std::uint16_t element) const {
    std::vector<double> numbers;
    std::istringstream words(text(group, element));
    for (std::string word; std::getline(words, word, '\\');)
      numbers.push_back(std::stod(word));
    return numbers;
  }
  /// The grey values; those that a damaged file lacks are zero.
  tracking::CineImage image() const {
    tracking::CineImage image = tracking::CineImage::Zero(number(0x28, 0x10), number(0x28, 0x11));
    const std::string pixels = text(0x7fe0, 0x10);
    for (std::size_t i = 0; i < static_cast<std::size_t>(image.size()) && 2 * i + 1 < pixels.size(); ++i)
      image.data()[i] = number16(pixels, 2 * i);
    return image;
  }

private:
  static std::uint16_t number16(const std::string& bytes, std::size_t at) {
    std::uint16_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
  }
  std::uint16_t number(std::uint16_t group, std::uint16_t element) const {
    return number16(text(group, element), 0);
  }
  std::size_t readElement(std::size_t at) {
    static const std::set<std::string> wide = {"OB", "OW", "SQ", "UN", "UT", "OF"};
    const bool isWide = wide.contains(bytes_.substr(at + 4, 2));
    std::uint32_t length = isWide ? 0 : number16(bytes_, at + 6);
    if (isWide)
      std::memcpy(&length, bytes_.data() + at + 8, sizeof length);
    const std::size_t begin = at + (isWide ? 12 : 8);
    if (length == 0xffffffffU) {
      const std::size_t end = bytes_.find(std::string("\xfe\xff\xdd\xe0", 4), begin);
      return end == std::string::npos ? bytes_.size() : end + 8;
    }
    elements_.insert({{number16(bytes_, at), number16(bytes_, at + 2)}, {begin, length}});
    return begin + length;
  }

  std::string bytes_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::pair<std::size_t, std::size_t>> elements_;
};

/// The images of one folder as a plane, ordered by their times.
inline tracking::CinePlane readCinePlane(const std::filesystem::path& folder) {
  std::map<double, PlainDicom> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    PlainDicom file(entry.path());
    const double milliseconds = file.numbers(0x18, 0x1060).at(0);
    files.emplace(milliseconds, std::move(file));
  }
  tracking::CinePlane plane;
  plane.name = folder.filename().string();
  const PlainDicom& first = files.begin()->second;
  const std::vector<double> position = first.numbers(0x20, 0x32), axes = first.numbers(0x20, 0x37),
                            spacing = first.numbers(0x28, 0x30);
  plane.origin = Vec3(position[0], position[1], position[2]);
  plane.alongRow = Vec3(axes[0], axes[1], axes[2]);
  plane.alongColumn = Vec3(axes[3], axes[4], axes[5]);
  plane.spacing = Eigen::Vector2d(spacing[1], spacing[0]);
  // The period is the number of images times their distance in time.
  const double step = files.rbegin()->first / static_cast<double>(files.size() - 1);
  for (const auto& [milliseconds, file] : files) {
    plane.fractions.push_back(milliseconds / (step * static_cast<double>(files.size())));
    plane.images.push_back(file.image());
  }
  return plane;
}

} // namespace viscera::tests
