#include "viscera/presentation/part_names.h"

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

namespace viscera::presentation {
namespace {

constexpr int kTries = 2;

Eigen::Index nearestVertex(const Points& points, const Vec3& place) {
  Eigen::Index nearest = 0;
  (points.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

} // namespace

std::vector<Part> partsOf(const document::OrganList& organs) {
  std::vector<Part> parts;
  for (const auto& organ : organs)
    if (organ->look.visible)
      for (std::size_t place = 0; place < organ->places.size(); ++place)
        parts.push_back({organ->id, place, nearestVertex(organ->mesh->points, organ->places[place].at)});
  return parts;
}

std::vector<Part> clickableParts(const document::OrganList& organs) {
  const auto find = [&](document::OrganId id) {
    return std::find_if(organs.begin(), organs.end(), [id](const auto& organ) { return organ->id == id; });
  };
  std::vector<Part> parts = partsOf(organs);
  std::erase_if(parts, [&](const Part& part) {
    const auto organ = find(part.organ);
    const auto around = organ == organs.end() ? organs.end() : find((*organ)->parent);
    return around != organs.end() && (*around)->look.visible;
  });
  return parts;
}

const std::string& nameOf(const Part& part, const document::OrganList& organs) {
  static const std::string none;
  for (const auto& organ : organs)
    if (organ->id == part.organ && part.place < organ->places.size())
      return organ->places[part.place].name;
  return none;
}

std::optional<Part> nearestPart(const std::vector<Part>& parts, document::OrganId organ, const Points& points,
                                const Vec3& place) {
  std::optional<Part> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const Part& part : parts) {
    if (part.organ != organ || part.vertex < 0 || part.vertex >= points.rows())
      continue;
    const double away = (points.row(part.vertex).transpose() - place).norm();
    if (away < least) {
      least = away;
      nearest = part;
    }
  }
  return nearest;
}

PartQuiz::PartQuiz(std::vector<Part> parts, unsigned seed) : all_(std::move(parts)), open_(all_) {
  std::mt19937 random(seed); // Not std::shuffle: every library would ask in another order.
  for (std::size_t left = open_.size(); left > 1; --left)
    std::swap(open_[left - 1], open_[random() % left]);
}

bool PartQuiz::answer(const Part& chosen) {
  if (open_.empty())
    return false;
  const bool right = chosen == open_.front();
  if (right) {
    found_.push_back(open_.front());
    open_.erase(open_.begin());
  } else {
    ++mistakes_;
    ++tries_;
  }
  if (right || tries_ >= kTries)
    tries_ = 0;
  if (!right && tries_ == 0)
    std::rotate(open_.begin(), open_.begin() + 1, open_.end());
  return right;
}

} // namespace viscera::presentation
