#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "space_tag.h"
#include "surface_formats.h"
#include "surface_formats/three_mf_model.h"
#include "surface_parts.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr int kDeepestObject = 64;
/// Objects may be used again and again: a few kilobytes can ask for endless copies.
constexpr std::size_t kMostUses = 100'000;
constexpr std::size_t kMostThreeMfCorners = 300'000'000;
constexpr std::uint8_t kUnpainted = 204;

std::uint8_t channelOf(PackedColor color, unsigned channel) {
  return static_cast<std::uint8_t>(color >> (24U - 8U * channel));
}

/// A mesh in its place.
struct PlacedMesh {
  RawSurface surface;
  std::optional<Vec3> color;
  double opacity = 1;
};

/// Walks through what is printed, and takes every mesh that it meets.
class ThreeMfReader {
public:
  explicit ThreeMfReader(const FileBytes& file) : file_(file), model_(readThreeMfModel(file)) {}

  std::vector<PlacedMesh> run() {
    Eigen::Affine3d toMm = Eigen::Affine3d::Identity();
    unknownUnit_ = model_.mm == 0;
    if (unknownUnit_)
      model_.mm = 1;
    toMm.linear() *= model_.mm;
    for (const ThreeMfUse& use : printed())
      visit(use, toMm, {}, 0);
    nameParts();
    if (parts_.empty())
      file_.fail("It holds no triangles", "export it as a surface of triangles");
    const std::optional<Space> space = findSpace(model_.comment, parts_.front().surface.warnings);
    for (PlacedMesh& part : parts_)
      part.surface.space = space;
    addWarnings(parts_.front().surface.warnings);
    return std::move(parts_);
  }

private:
  /// Every object that is no part of another, where there is no list.
  std::vector<ThreeMfUse> printed() {
    std::set<std::string> used;
    for (const auto& [key, object] : model_.objects)
      for (const ThreeMfUse& use : object.components)
        used.insert(use.object);
    std::vector<ThreeMfUse> all;
    for (const std::string& key : model_.order)
      if (!used.contains(key))
        all.push_back({key});
    if (model_.printed.empty())
      return all;
    for (const ThreeMfUse& use : model_.printed)
      used.insert(use.object);
    unprinted_ = static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](const ThreeMfUse& use) { return !used.contains(use.object); }));
    return model_.printed;
  }

  static std::string numberOf(const ThreeMfUse& use) { return use.object.substr(use.object.rfind('#') + 1); }

  void visit(const ThreeMfUse& use, const Eigen::Affine3d& outer, const std::string& name, int depth) {
    const auto found = model_.objects.find(use.object);
    if (found == model_.objects.end())
      file_.fail(diagnostic("there is no object %1", inQuotes(numberOf(use))));
    if (depth > kDeepestObject || ++uses_ > kMostUses)
      file_.fail(diagnostic("With its components expanded, it has too many objects"));
    const ThreeMfObject& object = found->second;
    if (object.type == "support" || object.type == "solidsupport") {
      ++supports_;
      return;
    }
    const Eigen::Affine3d transform = outer * use.transform;
    const std::string& known = object.name.empty() ? name : object.name;
    for (const ThreeMfUse& component : object.components)
      visit(component, transform, known, depth + 1);
    if (object.triangles.empty())
      return;
    std::size_t begin = 0;
    for (const ThreeMfPiece& piece : object.pieces) {
      if (piece.isShape)
        addPart(object, {begin, piece.end}, transform, piece.name.empty() ? known : piece.name,
                numberOf(use));
      else
        ++supports_;
      begin = piece.end;
    }
    if (object.pieces.empty())
      addPart(object, {0, object.triangles.size()}, transform, known, numberOf(use));
  }

  /// Some of the triangles of an object.
  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  void addPart(const ThreeMfObject& object, const Range& range, const Eigen::Affine3d& transform,
               const std::string& name, const std::string& id) {
    corners_ += 3 * (range.end - range.begin) + object.coordinates.size();
    if (corners_ > kMostThreeMfCorners)
      file_.fail(diagnostic("With its components expanded, it has too many triangles"));
    PlacedMesh part;
    RawSurface& raw = part.surface;
    raw.name = name;
    raw.coordinates = object.coordinates;
    if (!transform.matrix().isIdentity(0))
      for (std::size_t i = 0; i + 2 < raw.coordinates.size(); i += 3) {
        Eigen::Map<Vec3> point(raw.coordinates.data() + i);
        point = (transform * Vec3(point)).eval();
      }
    const bool mirrored = transform.linear().determinant() < 0;
    const auto points = static_cast<std::int64_t>(raw.pointCount());
    for (std::size_t t = range.begin; t < range.end; ++t) {
      const auto& [a, b, c] = object.triangles[t];
      for (const std::int64_t corner : {a, b, c})
        if (corner < 0 || corner >= points)
          file_.fail(
              diagnostic("object %1, triangle %2 refers to point %3, but there are %4 (counted from 0)",
                         inQuotes(id), t, corner, points));
      raw.addTriangle(a, mirrored ? c : b, mirrored ? b : c);
    }
    paint(object, range, part);
    if (!object.pieces.empty())
      dropOtherPoints(raw);
    parts_.push_back(std::move(part));
  }

  /// One colour for the whole, or one for every point.
  static void paint(const ThreeMfObject& object, const Range& range, PlacedMesh& part) {
    if (object.colors.size() <= range.begin)
      return;
    const auto begin = object.colors.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto end =
        object.colors.begin() + static_cast<std::ptrdiff_t>(std::min(range.end, object.colors.size()));
    const PackedColor first = (*begin)[0];
    const bool whole = first != kNoColor && object.colors.size() >= range.end &&
                       std::all_of(begin, end, [&](const auto& three) {
                         return three == std::array{first, first, first};
                       });
    if (whole) {
      part.color = Vec3(channelOf(first, 0), channelOf(first, 1), channelOf(first, 2)) / 255.0;
      // Some programs write no opacity as 0.
      part.opacity = channelOf(first, 3) == 0 ? 1 : channelOf(first, 3) / 255.0;
      return;
    }
    std::vector<std::uint8_t>& colors = part.surface.colors;
    colors.assign(object.coordinates.size(), kUnpainted);
    // The first triangle of a point has the last word.
    for (std::size_t t = std::min(range.end, object.colors.size()); t-- > range.begin;)
      for (std::size_t k = 0; k < 3; ++k)
        if (const PackedColor color = object.colors[t][k]; color != kNoColor)
          for (unsigned channel = 0; channel < 3; ++channel)
            colors[3 * static_cast<std::size_t>(object.triangles[t][k]) + channel] =
                channelOf(color, channel);
  }

  /// Leaves out the points of other pieces.
  static void dropOtherPoints(RawSurface& raw) {
    std::vector<std::int64_t> places(raw.pointCount(), -1);
    RawSurface kept;
    for (std::int64_t& corner : raw.corners) {
      const auto point = static_cast<std::size_t>(corner);
      if (places[point] < 0) {
        places[point] = static_cast<std::int64_t>(kept.pointCount());
        for (std::size_t k = 3 * point; k < 3 * point + 3; ++k) {
          kept.coordinates.push_back(raw.coordinates[k]);
          if (!raw.colors.empty())
            kept.colors.push_back(raw.colors[k]);
        }
      }
      corner = places[point];
    }
    raw.coordinates = std::move(kept.coordinates);
    raw.colors = std::move(kept.colors);
  }

  /// Parts without a name are numbered; several of one name, as two copies of an object are, too.
  void nameParts() {
    if (parts_.size() < 2)
      return;
    std::map<std::string, int> times;
    for (PlacedMesh& part : parts_) {
      std::string& name = part.surface.name;
      const bool unnamed = name.empty();
      if (unnamed)
        name = "Object";
      const int time = ++times[name];
      if (time > 1 || unnamed)
        name += " " + std::to_string(time);
    }
  }

  void addWarnings(std::vector<Text>& warnings) const {
    if (unknownUnit_)
      warnings.push_back(phrase("its unit %1 is not known; mm are assumed", inQuotes(model_.unit)));
    if (model_.mm != 1)
      warnings.push_back(phrase("converted from %1 to mm", model_.unit));
    if (unprinted_ > 0)
      warnings.push_back(phrase(
          "%n {object that the file does not place is|objects that the file does not place are} left out",
          unprinted_));
    if (supports_ > 0)
      warnings.push_back(
          phrase("%n {object that only supports a print is|objects that only support a print are} left out",
                 supports_));
    if (model_.unreadColors)
      warnings.push_back("colours that come from pictures or mixtures are left out");
    if (model_.unreadShapes)
      warnings.push_back("beams and other shapes that are no triangles are left out");
  }

  const FileBytes& file_;
  ThreeMfModel model_;
  std::vector<PlacedMesh> parts_;
  std::size_t uses_ = 0;
  std::size_t corners_ = 0;
  std::size_t supports_ = 0;
  std::size_t unprinted_ = 0;
  bool unknownUnit_ = false;
};

} // namespace

RawSurface readThreeMf(const FileBytes& file) {
  RawSurface whole;
  PartList parts;
  for (PlacedMesh& mesh : ThreeMfReader(file).run()) {
    RawSurface& one = mesh.surface;
    RawPart part;
    part.name = one.name;
    part.color = mesh.color;
    part.opacity = mesh.opacity;
    part.plain = one.colors.empty();
    parts.begin(parts.add(std::move(part)), whole.polygonCount());
    const auto before = static_cast<std::int64_t>(whole.pointCount());
    one.colors.resize(one.coordinates.size(), 0);
    whole.coordinates.insert(whole.coordinates.end(), one.coordinates.begin(), one.coordinates.end());
    whole.colors.insert(whole.colors.end(), one.colors.begin(), one.colors.end());
    for (std::size_t corner = 0; corner + 2 < one.corners.size(); corner += 3)
      whole.addTriangle(one.corners[corner] + before, one.corners[corner + 1] + before,
                        one.corners[corner + 2] + before);
    if (parts.size() == 1) {
      whole.name = one.name;
      whole.space = one.space;
      whole.warnings = std::move(one.warnings);
    }
    one = {};
  }
  if (parts.size() > 1)
    whole.name.clear();
  if (parts.allPlain())
    whole.colors.clear();
  whole.partsAreOrgans = true;
  parts.moveTo(whole);
  return whole;
}

} // namespace viscera::medical_io
