#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "definition/fields.h"
#include "implicit/nodes.h"
#include "implicit/surface_path.h"

namespace viscera::sample_organs {

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

private:
  SurfacePath pathFrom(Fields& fields) const;
  Vec3 branchPoint(Fields& from) const;

  const ImplicitNode& base_;
  int level_;
  BuildNode buildNode_;
  std::vector<SurfaceVessel> vessels_;
  std::map<std::string, std::vector<AxisPoint>> named_;
};

} // namespace viscera::sample_organs
