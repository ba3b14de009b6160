#pragma once

#include <string>
#include <vector>

/// The picture of the table of coordinate systems beside elasticity.
namespace viscera::thesis {

/// One coordinate system: the numbers of all its drags.
struct ElasticRow {
  std::string name;
  std::vector<double> relative; ///< Difference by the elastic displacement, per cent.
  std::vector<double> spearman; ///< Rank correlation of stress; numbers that are none are left out.
};

/// A row a system, the nearest to elasticity first: the middle half of its drags as a bar, all but the outer
/// twentieths as a line, and the median as a dot, of both numbers; systems without drags last, by name only.
/// SVG on white.
std::string elasticChart(const std::vector<ElasticRow>& rows, const std::string& title);

} // namespace viscera::thesis
