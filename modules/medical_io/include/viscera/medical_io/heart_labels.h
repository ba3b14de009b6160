#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viscera/medical_io/label_map.h"

/// Combines the labels of a heart that was segmented in parts into one organ with cavities.
namespace viscera::medical_io {

/// The labels of a map that are the parts of a heart.
struct HeartLabels {
  /// A chamber's cavity.
  struct Cavity {
    std::string chamber;     ///< "LV", "RV", "LA" or "RA".
    std::size_t segment = 0; ///< Index into `LabelMap::segments`.
  };
  std::vector<std::size_t> muscle; ///< Indices into `LabelMap::segments`; at least one.
  std::vector<Cavity> cavities;    ///< In the order of `Cavity::chamber`; at least one ventricle.
};

/// The heart by the names of labels (`anatomy::partNamed`): "heart_ventricle_left" and "heart_myocardium", or
/// "LV" and "myocardium". None where there is no muscle or no ventricle,
/// or where a chamber comes twice. O(names).
std::optional<HeartLabels> heartAmong(const std::vector<std::string>& names);

/// The heart among the labels of a map that a file or a table names.
std::optional<HeartLabels> heartLabels(const LabelMap& map);

/// Adds the segment "Heart" to the map: the voxels of its muscle and of its cavities, in a layer of their
/// own. Returns its index. Does nothing and returns none if a segment has that name already. O(voxels).
std::optional<std::size_t> addWholeHeart(LabelMap& map, const HeartLabels& heart);

} // namespace viscera::medical_io
