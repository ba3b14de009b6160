#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "definition/fields.h"
#include "implicit/nodes.h"
#include "implicit/surface_path.h"
#include "viscera/geometry/named_vessel.h"

namespace viscera::sample_organs {

/// A vessel without a name along a smooth axis through these points.
geometry::NamedVessel vesselAlong(const std::vector<AxisPoint>& axis, const Vec3& color);

/// Builds the vessels of one `surface_vessels` node on its base, one after the other; a path may branch off
/// an earlier one.
class VesselBuilder {
public:
  /// How to build the nodes that paths refer to: content, and where it stands.
  using BuildNode = std::function<NodePtr(const nlohmann::json&, const std::string&)>;

  /// `base` must outlive the builder. Paths whose `lod` is above `level` are left out.
  VesselBuilder(const ImplicitNode& base, int level, BuildNode buildNode);

  /// Reads one path. Throws `DataError` that names file, node, path and field.
  void add(const nlohmann::json& content, const std::string& where);

  /// Returns the vessels that were added.
  std::vector<SurfaceVessel> take() { return std::move(vessels_); }
  /// The vessels that have a name in anatomy, as lines.
  const std::vector<geometry::NamedVessel>& vessels() const { return anatomy_; }

private:
  SurfacePath pathFrom(Fields& fields) const;
  Vec3 branchPoint(Fields& from) const;
  void addNamed(const nlohmann::json& names, const std::vector<AxisPoint>& axis, const Vec3& color,
                const Fields& fields);

  const ImplicitNode& base_;
  int level_;
  BuildNode buildNode_;
  std::vector<SurfaceVessel> vessels_;
  std::map<std::string, std::vector<AxisPoint>> named_;
  std::vector<geometry::NamedVessel> anatomy_;
};

} // namespace viscera::sample_organs
