#include "mesh_differences.h"

#include <cmath>

namespace viscera::lesson {
namespace {

constexpr int kMeshCorners = 3;

/// Calls `take(vertex, other)` for each pair of a triangle's corners with `other < vertex`.
template <class Take>
void forEachPair(const Triangles& triangles, const Take& take) {
  for (const auto& corners : triangles.rowwise())
    for (int a = 0; a < kMeshCorners; ++a)
      for (int b = 0; b < kMeshCorners; ++b)
        if (corners[b] < corners[a])
          take(static_cast<std::size_t>(corners[a]), static_cast<std::size_t>(corners[b]));
}

} // namespace

MeshDifferences::MeshDifferences(const Triangles& triangles, Eigen::Index vertices)
    : first_(static_cast<std::size_t>(vertices) + 1, 0) {
  forEachPair(triangles, [this](std::size_t vertex, std::size_t) { ++first_[vertex + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i)
    first_[i] += first_[i - 1];
  before_.resize(first_.back());
  std::vector<std::size_t> next = first_;
  forEachPair(triangles, [&](std::size_t vertex, std::size_t other) { before_[next[vertex]++] = other; });
}

std::int32_t MeshDifferences::guess(const std::int32_t* field, std::size_t vertex,
                                    std::size_t components) const {
  const std::size_t begin = first_[vertex], end = first_[vertex + 1];
  if (begin == end)
    return vertex == 0 ? 0 : field[(vertex - 1) * components];
  double sum = 0; // Whole numbers, exact as the page's are.
  for (std::size_t i = begin; i < end; ++i)
    sum += field[before_[i] * components];
  return static_cast<std::int32_t>(std::floor(sum / static_cast<double>(end - begin) + 0.5));
}

std::vector<std::int32_t> MeshDifferences::of(const std::vector<std::int32_t>& values, int components) const {
  const auto width = static_cast<std::size_t>(components), vertices = first_.size() - 1;
  std::vector<std::int32_t> differences(values.size());
  for (std::size_t field = 0; field < values.size(); field += vertices * width)
    for (std::size_t i = 0; i < vertices * width; ++i)
      differences[field + i] = static_cast<std::int32_t>(
          std::int64_t(values[field + i]) - guess(values.data() + field + i % width, i / width, width));
  return differences;
}

std::vector<std::int32_t> MeshDifferences::undone(const std::vector<std::int32_t>& differences,
                                                  int components) const {
  const auto width = static_cast<std::size_t>(components), vertices = first_.size() - 1;
  std::vector<std::int32_t> values(differences.size());
  for (std::size_t field = 0; field < values.size(); field += vertices * width)
    for (std::size_t i = 0; i < vertices * width; ++i)
      values[field + i] = static_cast<std::int32_t>(
          std::int64_t(differences[field + i]) + guess(values.data() + field + i % width, i / width, width));
  return values;
}

} // namespace viscera::lesson
