#include "definition/node_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "definition/finish_fields.h"
#include "definition/tube_fields.h"
#include "definition/vessel_builder.h"
#include "implicit/displacement.h"
#include "implicit/ellipsoid.h"
#include "implicit/frame.h"
#include "implicit/half_space.h"
#include "implicit/intersection.h"
#include "implicit/offset.h"
#include "implicit/subtraction.h"
#include "implicit/surface_vessels.h"
#include "implicit/union.h"
#include "viscera/core/error.h"

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr int kHighestLevel = 2;
constexpr int kMostOctaves = 8;
constexpr int kMostSeed = 1'000'000;
constexpr double kSkew = 0.02; // how far from orthonormal written axes may be; they carry two or three digits

/// The rotation of `rotate_deg` (about x, then y, then z) or of `axes` (the local axes in the outer frame).
Eigen::Matrix3d rotationFrom(Fields& fields) {
  if (fields.has("axes")) {
    const json& axes = fields.list("axes", 3);
    Eigen::Matrix3d rotation;
    for (int i = 0; i < 3; ++i)
      rotation.col(i) = vectorFrom(axes[static_cast<std::size_t>(i)], fields.where(), "axes").normalized();
    const double error =
        (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(error < kSkew) || rotation.determinant() < 0)
      fields.fail("axes", "are not three perpendicular right-handed directions",
                  "mend them, or use \"mirror\" for a mirrored frame");
    return rotation;
  }
  const Vec3 angles = fields.vector("rotate_deg", Vec3::Zero()) * std::numbers::pi / 180;
  return (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
      .toRotationMatrix();
}

template <class Node, class... Arguments>
std::shared_ptr<Node> made(Arguments&&... arguments) {
  return std::make_shared<Node>(std::forward<Arguments>(arguments)...);
}

} // namespace

NodeBuilder::NodeBuilder(const OrganDefinition& definition, Resolution resolution)
    : definition_(definition), level_(static_cast<int>(resolution)) {}

NodePtr NodeBuilder::named(const std::string& name) {
  if (definition_.nodes.count(name) == 0) {
    std::set<std::string> names;
    for (const auto& node : definition_.nodes)
      names.insert(node.first);
    throw UsageError("there is no node \"" + name + "\"", definition_.file, "there are " + listed(names));
  }
  const NodePtr node = buildNamed(name, definition_.file);
  if (!node)
    throw UsageError("the node \"" + name + "\" does not exist at this resolution", definition_.file,
                     "ask for a higher one");
  return node;
}

NodePtr NodeBuilder::root(const SurfaceDefinition& surface) {
  return required(surface.root, surface.where);
}

NodePtr NodeBuilder::buildNamed(const std::string& name, const std::string& askedBy) {
  if (const auto done = built_.find(name); done != built_.end())
    return done->second;
  const auto found = definition_.nodes.find(name);
  if (found == definition_.nodes.end()) {
    std::set<std::string> names;
    for (const auto& node : definition_.nodes)
      names.insert(node.first);
    const std::string near = nearestName(name, names);
    throw DataError("there is no node \"" + name + "\"", askedBy,
                    near.empty() ? "there are " + listed(names) : "is it \"" + near + "\" that is meant?");
  }
  if (!underConstruction_.insert(name).second)
    throw DataError("the node \"" + name + "\" is made of itself", askedBy, "break the circle of references");
  const NodePtr node = build(found->second.node, found->second.where);
  underConstruction_.erase(name);
  built_.emplace(name, node);
  return node;
}

bool NodeBuilder::presentAt(Fields& fields) const {
  const int from = fields.integer("lod", 0, 0, kHighestLevel);
  const int to = fields.integer("max_lod", kHighestLevel, 0, kHighestLevel);
  return from <= level_ && level_ <= to;
}

NodePtr NodeBuilder::build(const Json& content, const std::string& where) {
  if (content.is_string())
    return buildNamed(content.get<std::string>(), where);
  Fields fields(content, where);
  fields.ignore("name");
  const bool present = presentAt(fields);
  const Finish finish = finishFrom(fields);
  if (!present)
    return nullptr;
  const NewNode node = buildType(fields.text("type"), fields);
  fields.requireNothingElse();
  node->setFinish(finish);
  return node;
}

NodeBuilder::NewNode NodeBuilder::buildType(const std::string& type, Fields& fields) {
  static const std::map<std::string, NewNode (NodeBuilder::*)(Fields&)> composite = {
      {"union", &NodeBuilder::unionOf},
      {"subtract", &NodeBuilder::subtraction},
      {"intersect", &NodeBuilder::intersection},
      {"offset", &NodeBuilder::offset},
      {"frame", &NodeBuilder::frame},
      {"displace", &NodeBuilder::displacement},
      {"surface_vessels", &NodeBuilder::surfaceVessels}};
  static const std::map<std::string, NewNode (NodeBuilder::*)(Fields&) const> simple = {
      {"ellipsoid", &NodeBuilder::ellipsoid},
      {"half_space", &NodeBuilder::halfSpace},
      {"tube", &NodeBuilder::tube}};
  if (const auto found = composite.find(type); found != composite.end())
    return (this->*found->second)(fields);
  if (const auto found = simple.find(type); found != simple.end())
    return (this->*found->second)(fields);
  std::set<std::string> types;
  for (const auto& item : composite)
    types.insert(item.first);
  for (const auto& item : simple)
    types.insert(item.first);
  fields.fail("type", "is \"" + type + "\", which is not known", "use one of " + listed(types));
}

NodePtr NodeBuilder::required(const Json& content, const std::string& where) {
  NodePtr node = build(content, where);
  if (!node)
    throw DataError("nothing is left here at this resolution", where,
                    "lower the \"lod\" of the node it needs");
  return node;
}

NodePtr NodeBuilder::child(Fields& fields, const std::string& key) {
  return required(fields.get(key), fields.where() + ", " + key);
}

std::vector<NodePtr> NodeBuilder::children(Fields& fields) {
  std::vector<NodePtr> nodes;
  const Json& list = fields.list("children");
  for (std::size_t i = 0; i < list.size(); ++i)
    if (NodePtr node = build(list[i], fields.where() + ", children[" + std::to_string(i) + "]"))
      nodes.push_back(std::move(node));
  return nodes;
}

double NodeBuilder::blend(Fields& fields) const {
  fields.ignore("k");
  if (!fields.has("k"))
    return 0;
  const Json& k = fields.get("k");
  const Json& value = k.is_array() && k.size() == kHighestLevel + 1 ? k[static_cast<std::size_t>(level_)] : k;
  if (!value.is_number() || value.get<double>() < 0)
    fields.fail("k", "is " + k.dump(), "give a width in mm, or three for low, medium and high");
  return value.get<double>();
}

NodeBuilder::NewNode NodeBuilder::ellipsoid(Fields& fields) const {
  const Vec3 radii = fields.vector("radii");
  if ((radii.array() <= 0).any())
    fields.fail("radii", "are not all above 0");
  fields.ignore("axes");
  return made<Ellipsoid>(fields.vector("center"), radii, rotationFrom(fields));
}

NodeBuilder::NewNode NodeBuilder::halfSpace(Fields& fields) const {
  return made<HalfSpace>(fields.vector("point"), fields.direction("normal"));
}

NodeBuilder::NewNode NodeBuilder::tube(Fields& fields) const {
  const std::vector<AxisPoint> axis = axisFrom(fields);
  return made<Tube>(axis, tubeShapeFrom(fields, level_));
}

NodeBuilder::NewNode NodeBuilder::unionOf(Fields& fields) {
  std::vector<NodePtr> parts = children(fields);
  if (parts.empty())
    fields.fail("children", "has nothing for this resolution", "lower the \"lod\" of one of them");
  return made<Union>(std::move(parts), blend(fields));
}

NodeBuilder::NewNode NodeBuilder::subtraction(Fields& fields) {
  NodePtr body = child(fields, "from");
  return made<Subtraction>(std::move(body), children(fields), blend(fields));
}

NodeBuilder::NewNode NodeBuilder::intersection(Fields& fields) {
  std::vector<NodePtr> parts = children(fields);
  if (parts.empty())
    fields.fail("children", "has nothing for this resolution", "lower the \"lod\" of one of them");
  return made<Intersection>(std::move(parts), blend(fields));
}

NodeBuilder::NewNode NodeBuilder::offset(Fields& fields) {
  const double distance = fields.number("distance");
  return made<Offset>(child(fields, "child"), distance);
}

NodeBuilder::NewNode NodeBuilder::frame(Fields& fields) {
  Placement placement;
  placement.origin = fields.vector("origin", placement.origin);
  fields.ignore("axes");
  placement.rotation = rotationFrom(fields);
  placement.mirror = fields.vector("mirror", placement.mirror);
  placement.scale = fields.positive("scale", placement.scale);
  if (!(placement.mirror.array().abs() == 1).all())
    fields.fail("mirror", "has other numbers than 1 and -1");
  return made<Frame>(child(fields, "child"), placement);
}

NodeBuilder::NewNode NodeBuilder::displacement(Fields& fields) {
  Roughness roughness;
  roughness.amplitude = fields.positive("amplitude", roughness.amplitude);
  roughness.wavelength = fields.positive("wavelength", roughness.wavelength);
  roughness.octaves = fields.integer("octaves", roughness.octaves, 1, kMostOctaves);
  roughness.seed = fields.integer("seed", roughness.seed, 0, kMostSeed);
  return made<Displacement>(child(fields, "child"), roughness);
}

NodeBuilder::NewNode NodeBuilder::surfaceVessels(Fields& fields) {
  NodePtr base = child(fields, "base");
  VesselBuilder vessels(*base, level_, [this](const Json& content, const std::string& where) {
    return required(content, where);
  });
  const Json& paths = fields.list("paths");
  for (std::size_t i = 0; i < paths.size(); ++i)
    vessels.add(paths[i], fields.where() + ", paths[" + std::to_string(i) + "]");
  return made<SurfaceVessels>(std::move(base), vessels.take(), blend(fields));
}

} // namespace viscera::sample_organs
