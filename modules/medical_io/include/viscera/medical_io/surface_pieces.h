#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/geometry/triangle_mesh.h"

/// The pieces of a surface by their sizes: which of them are fragments, such as crumbs of a segmentation, and
/// which belong to the organ, such as each of its ribs.
namespace viscera::medical_io {

/// The size below which a piece is a fragment.
struct FragmentLimit {
  enum class Measure { percent, millimetres, milliliters };
  Measure measure = Measure::percent;
  double value =
      2; ///< Of the whole area; of the longest side of the piece's box; of what the piece encloses.
};

/// "2%", "5mm" or "0.3ml". None for anything else, and for a value that is negative or not finite.
std::optional<FragmentLimit> fragmentLimit(std::string_view words);
/// The same back: "2%".
std::string inWords(const FragmentLimit& limit);

/// One piece.
struct PieceSize {
  double percent = 0;   ///< Of the area of the whole surface.
  double longestMm = 0; ///< The longest side of the box around it.
  double volumeMl = 0;  ///< Enclosed; of an open piece about as much as with caps.
};

/// The pieces of a surface, as they are joined by shared vertices.
class SurfacePieces {
public:
  /// Expects valid indices; `mesh` has to outlive this. O(n + m).
  explicit SurfacePieces(const geometry::TriangleMesh& mesh);

  const std::vector<PieceSize>& sizes() const { return sizes_; }
  /// Whether a piece is below the limit. The piece with the largest area never is. O(1).
  bool isFragment(std::size_t piece, const FragmentLimit& limit) const;
  /// Counts the fragments. O(pieces).
  std::size_t fragments(const FragmentLimit& limit) const;
  /// The surface of the fragments alone, or of all others, in their order and with their colours. O(n + m).
  geometry::TriangleMesh part(const FragmentLimit& limit, bool fragments) const;

private:
  const geometry::TriangleMesh& mesh_;
  std::vector<int> ofVertex_;
  std::vector<PieceSize> sizes_;
  std::size_t largest_ = 0;
};

/// "5 of 29 pieces go; the largest of them has 3.2 mm and 0.01 ml".
Text describeFragments(const SurfacePieces& pieces, const FragmentLimit& limit);

} // namespace viscera::medical_io
