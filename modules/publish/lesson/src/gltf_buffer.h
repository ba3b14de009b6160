#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/arrays.h"

namespace viscera::lesson {

/// The binary part of a glTF file with the accessors that lead into it.
class GltfBuffer {
public:
  enum class Target { none, vertices = 34962, indices = 34963 };

  /// Adds single precision, with the least and the largest of what is stored. Returns the accessor.
  std::size_t addVectors(const Points& points, bool withBounds);
  std::size_t addNumbers(const std::vector<float>& numbers, bool withBounds);
  /// Adds 16 bits each where `vertexCount` allows it.
  std::size_t addIndices(const std::vector<std::int32_t>& indices, Eigen::Index vertexCount);
  /// Adds opaque colours, converted from sRGB to linear values, as glTF requires.
  std::size_t addColors(const Colors& colors);

  /// The file: `tree` with these buffers, views and accessors, and the bytes.
  std::string fileOf(nlohmann::ordered_json tree) const;

private:
  std::size_t add(const void* data, std::size_t bytes, std::size_t count, const char* type, int component,
                  Target target);

  std::string bytes_;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

} // namespace viscera::lesson
