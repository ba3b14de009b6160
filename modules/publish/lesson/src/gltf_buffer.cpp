#include "gltf_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace viscera::lesson {
namespace {

using nlohmann::ordered_json;

// Component types and chunks of glTF 2.0.
constexpr int kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::uint32_t kHeader = 12, kChunkHeader = 8;
constexpr Eigen::Index kMostShort = 65535;

void align(std::string& bytes, char with) {
  bytes.resize((bytes.size() + 3) / 4 * 4, with);
}

void append(std::string& bytes, std::initializer_list<std::uint32_t> words) {
  for (const std::uint32_t word : words)
    bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

/// The transfer function of sRGB (IEC 61966-2-1).
double linear(double byte) {
  const double value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

} // namespace

std::size_t GltfBuffer::add(const void* data, std::size_t bytes, std::size_t count, const char* type,
                            int component, Target target) {
  align(bytes_, '\0');
  ordered_json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes}};
  if (target != Target::none)
    view["target"] = static_cast<int>(target);
  views_.push_back(std::move(view));
  bytes_.append(static_cast<const char*>(data), bytes);
  accessors_.push_back(
      {{"bufferView", views_.size() - 1}, {"componentType", component}, {"type", type}, {"count", count}});
  return accessors_.size() - 1;
}

std::size_t GltfBuffer::addVectors(const Points& points, bool withBounds) {
  using Floats = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
  const Floats stored = points.cast<float>();
  const std::size_t accessor = add(stored.data(), static_cast<std::size_t>(stored.size()) * sizeof(float),
                                   static_cast<std::size_t>(stored.rows()), "VEC3", kFloat, Target::vertices);
  if (withBounds)
    for (int axis = 0; axis < 3; ++axis) {
      accessors_[accessor]["min"].push_back(stored.col(axis).minCoeff());
      accessors_[accessor]["max"].push_back(stored.col(axis).maxCoeff());
    }
  return accessor;
}

std::size_t GltfBuffer::addNumbers(const std::vector<float>& numbers, bool withBounds) {
  const std::size_t accessor =
      add(numbers.data(), numbers.size() * sizeof(float), numbers.size(), "SCALAR", kFloat, Target::none);
  if (withBounds) {
    accessors_[accessor]["min"].push_back(*std::min_element(numbers.begin(), numbers.end()));
    accessors_[accessor]["max"].push_back(*std::max_element(numbers.begin(), numbers.end()));
  }
  return accessor;
}

std::size_t GltfBuffer::addIndices(const std::vector<std::int32_t>& indices, Eigen::Index vertexCount) {
  if (vertexCount >= kMostShort)
    return add(indices.data(), indices.size() * sizeof(std::int32_t), indices.size(), "SCALAR", kInt,
               Target::indices);
  const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
  return add(narrow.data(), narrow.size() * sizeof(std::uint16_t), narrow.size(), "SCALAR", kShort,
             Target::indices);
}

std::size_t GltfBuffer::addColors(const Colors& colors) {
  std::array<std::uint8_t, 256> table = {};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<std::uint8_t>(std::lround(255 * linear(static_cast<double>(i))));
  std::vector<std::uint8_t> stored;
  for (const auto& color : colors.rowwise())
    stored.insert(stored.end(), {table[color[0]], table[color[1]], table[color[2]], 255});
  const std::size_t accessor = add(stored.data(), stored.size(), static_cast<std::size_t>(colors.rows()),
                                   "VEC4", kByte, Target::vertices);
  accessors_[accessor]["normalized"] = true;
  return accessor;
}

std::string GltfBuffer::fileOf(ordered_json tree) const {
  std::string binary = bytes_;
  align(binary, '\0');
  tree["accessors"] = accessors_;
  tree["bufferViews"] = views_;
  tree["buffers"] = ordered_json::array({ordered_json{{"byteLength", binary.size()}}});
  std::string text = tree.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  align(text, ' ');
  const auto textSize = static_cast<std::uint32_t>(text.size()),
             binarySize = static_cast<std::uint32_t>(binary.size());
  std::string file;
  append(file, {kMagic, 2, kHeader + 2 * kChunkHeader + textSize + binarySize, textSize, kJsonChunk});
  file += text;
  append(file, {binarySize, kBinaryChunk});
  return file + binary;
}

} // namespace viscera::lesson
