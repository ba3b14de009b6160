#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "definition/fields.h"
#include "definition/organ_definition.h"
#include "implicit/nodes.h"
#include "viscera/geometry/named_vessel.h"

namespace viscera::sample_organs {

/// Builds the implicit surfaces of a definition at one resolution. Named nodes are built once, when first
/// referred to. The definition must outlive the builder. Not thread-safe, but the nodes that it builds are.
class NodeBuilder {
public:
  NodeBuilder(const OrganDefinition& definition, Resolution resolution);

  /// The node of this name. Throws `UsageError` that lists the existing nodes.
  NodePtr named(const std::string& name);

  /// The root of a surface; of one that is joined from others, the first less the others. Throws `DataError`
  /// that names the file, the node and the field.
  NodePtr root(const SurfaceDefinition& surface);
  /// The node that a surface is painted by in place of its body's colours; null for none.
  NodePtr paint(const SurfaceDefinition& surface);
  /// The vessels with names in anatomy of all nodes that were built so far.
  const std::vector<geometry::NamedVessel>& vessels() const { return vessels_; }

private:
  using Json = nlohmann::json;

  /// Null when the node is not meant for this resolution.
  NodePtr build(const Json& content, const std::string& where);
  NodePtr buildNamed(const std::string& name, const std::string& askedBy);
  NewNode buildType(const std::string& type, Fields& fields);
  NodePtr required(const Json& content, const std::string& where);
  NodePtr child(Fields& fields, const std::string& key);
  std::vector<NodePtr> children(Fields& fields);
  std::vector<NodePtr> someChildren(Fields& fields);
  /// A width in mm, one number or three for the levels.
  double atLevel(Fields& fields, const std::string& key) const;
  double blend(Fields& fields) const;

  NewNode ellipsoid(Fields& fields);
  NewNode halfSpace(Fields& fields);
  NewNode tube(Fields& fields);
  NewNode unionOf(Fields& fields);
  NewNode subtraction(Fields& fields);
  NewNode intersection(Fields& fields);
  NewNode offset(Fields& fields);
  NewNode lumen(Fields& fields);
  NewNode frame(Fields& fields);
  NewNode displacement(Fields& fields);
  NewNode surfaceVessels(Fields& fields);

  const OrganDefinition& definition_;
  Resolution resolution_;
  int level_;
  double wall_ = 0; ///< Inside a lumen, how much narrower than its vessel it is, mm.
  std::map<std::string, NodePtr> built_;
  std::vector<geometry::NamedVessel> vessels_;
  std::set<std::string> underConstruction_;
};

} // namespace viscera::sample_organs
