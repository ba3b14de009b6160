#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raw_surface.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {

/// One of the organs of a raw surface, with the look that the file gives it.
struct RawOrgan {
  RawSurface surface;
  std::optional<Vec3> color;
  double opacity = 1;
  int cavityOf = -1; ///< Its place among the organs; -1: it is no cavity.
};

/// Takes a raw surface apart into organs, by its parts. A part that is closed by itself is one (equal points
/// of a part count as one point). Open parts that share points are one together: an organ in several
/// materials, or a vessel with its inlets. An open part that shares nothing with another open one is an
/// organ, too. The first has the file's warnings. Their names are unique and not empty, unless the file
/// itself says which parts are organs. Throws `DataError` as `assembleSurface` for indices and coordinates.
/// O(n + m log m).
std::vector<RawOrgan> organsOf(RawSurface&& raw, const std::filesystem::path& file);

/// The names of the organs that `organsOf` would give. Throws as it does.
std::vector<std::string> organNames(const RawSurface& raw, const std::filesystem::path& file);

/// Throws `UsageError` when `raw` has several organs; it lists them and says how to choose one.
void requireOneOrgan(const RawSurface& raw, const std::filesystem::path& file);

/// The error for the name of an organ that a file does not have; it lists those that it has.
UsageError noSuchOrgan(const std::string& name, const std::vector<std::string>& names, const Text& where);

/// Adds a warning to each closed organ that lies inside another, and is not its cavity: the volume of the
/// outer one contains its volume. O(m log m) for each that has others in its box.
void warnOfNested(std::vector<SurfacePart>& parts);

/// Collects the parts of a file while its polygons are read.
class PartList {
public:
  /// The number of the part with that name, which is made when there is none.
  std::uint32_t named(const std::string& name);
  /// A new part, whatever its name.
  std::uint32_t add(RawPart part);
  std::uint32_t add(std::string name);
  RawPart& at(std::uint32_t part) { return parts_[part]; }
  std::size_t size() const { return parts_.size(); }
  /// Whether no part has coloured points.
  bool allPlain() const;

  /// All polygons from `polygons` on belong to `part`.
  void begin(std::uint32_t part, std::size_t polygons);
  /// Adds the parts to a surface that is read. One part alone gives it only its name and look.
  void moveTo(RawSurface& raw);

private:
  struct Run {
    std::uint32_t part;
    std::size_t first;
  };
  std::vector<RawPart> parts_;
  std::map<std::string, std::uint32_t> byName_;
  std::vector<Run> runs_;
};

} // namespace viscera::medical_io
