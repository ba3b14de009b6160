#include "definition/node_builder.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "definition/node_fields.h"
#include "definition/vessel_builder.h"
#include "viscera/core/error.h"

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr int kHighestLevel = 2;
constexpr int kMostOctaves = 8;
constexpr double kRimBlend = 0.4;   // mm; rounds the rims of cut vessels
constexpr double kMostWall = 0.28;  // of a vessel's radius
constexpr double kBeyondEnds = 3.0; // mm that a lumen goes on beyond its vessel's flat end, to leave it
constexpr double kSkew = 0.02; // how far from orthonormal written axes may be; they carry two or three digits

/// The rotation of `rotate_deg` (about x, then y, then z) or of `axes` (the local axes in the outer frame).
Eigen::Matrix3d rotationFrom(Fields& fields) {
  if (fields.optional("axes")) {
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

} // namespace

NodeBuilder::NodeBuilder(const OrganDefinition& definition, Resolution resolution)
    : definition_(definition), resolution_(resolution), level_(static_cast<int>(resolution)) {}

NodePtr NodeBuilder::named(const std::string& name) {
  if (definition_.nodes.count(name) == 0)
    throw UsageError("there is no node \"" + name + "\"", definition_.file,
                     "there are " + listed(namesOf(definition_.nodes)));
  const NodePtr node = buildNamed(name, definition_.file);
  if (!node)
    throw UsageError("the node \"" + name + "\" does not exist at this resolution", definition_.file,
                     "ask for a higher one");
  return node;
}

NodePtr NodeBuilder::root(const SurfaceDefinition& surface) {
  if (!surface.joined())
    return required(surface.root, surface.where);
  std::vector<NodePtr> lumina;
  for (const std::string& lumen : surface.less)
    lumina.push_back(root(definition_.surface(lumen)));
  return makeSubtraction(root(definition_.surface(surface.fromAt(resolution_))), std::move(lumina),
                         kRimBlend);
}

NodePtr NodeBuilder::paint(const SurfaceDefinition& surface) {
  return surface.paint.is_null() ? nullptr : required(surface.paint, surface.where + ", paint");
}

NodePtr NodeBuilder::buildNamed(const std::string& name, const std::string& askedBy) {
  if (const auto done = built_.find(name); done != built_.end() && wall_ == 0)
    return done->second;
  const auto found = definition_.nodes.find(name);
  if (found == definition_.nodes.end()) {
    const std::set<std::string> names = namesOf(definition_.nodes);
    const std::string near = nearestName(name, names);
    throw DataError("there is no node \"" + name + "\"", askedBy,
                    near.empty() ? "there are " + listed(names) : "is it \"" + near + "\" that is meant?");
  }
  if (!underConstruction_.insert(name).second)
    throw DataError("the node \"" + name + "\" is made of itself", askedBy, "break the circle of references");
  const NodePtr node = build(found->second.node, found->second.where);
  underConstruction_.erase(name);
  if (wall_ == 0)
    built_.emplace(name, node);
  return node;
}

NodePtr NodeBuilder::build(const Json& content, const std::string& where) {
  if (content.is_string())
    return buildNamed(content.get<std::string>(), where);
  Fields fields(content, where);
  fields.ignore("name");
  const bool reached = presentAt(fields, level_);
  const bool passed = level_ > fields.integer("max_lod", kHighestLevel, 0, kHighestLevel);
  const Finish finish = finishFrom(fields);
  if (!reached || passed)
    return nullptr;
  const NewNode node = buildType(fields.text("type"), fields);
  fields.requireNothingElse();
  node->setFinish(finish);
  return node;
}

NewNode NodeBuilder::buildType(const std::string& type, Fields& fields) {
  static const std::map<std::string, NewNode (NodeBuilder::*)(Fields&)> types = {
      {"union", &NodeBuilder::unionOf},
      {"subtract", &NodeBuilder::subtraction},
      {"intersect", &NodeBuilder::intersection},
      {"offset", &NodeBuilder::offset},
      {"lumen", &NodeBuilder::lumen},
      {"frame", &NodeBuilder::frame},
      {"displace", &NodeBuilder::displacement},
      {"surface_vessels", &NodeBuilder::surfaceVessels},
      {"ellipsoid", &NodeBuilder::ellipsoid},
      {"half_space", &NodeBuilder::halfSpace},
      {"tube", &NodeBuilder::tube}};
  const auto found = types.find(type);
  if (found == types.end())
    fields.fail("type", "is \"" + type + "\", which is not known", "use one of " + listed(namesOf(types)));
  if (wall_ > 0 && type != "tube" && type != "union")
    fields.fail("type", "is \"" + type + "\" inside a lumen", "give a lumen tubes and unions of tubes");
  return (this->*found->second)(fields);
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

std::vector<NodePtr> NodeBuilder::someChildren(Fields& fields) {
  std::vector<NodePtr> nodes = children(fields);
  if (nodes.empty())
    fields.fail("children", "has nothing for this resolution", "lower the \"lod\" of one of them");
  return nodes;
}

double NodeBuilder::atLevel(Fields& fields, const std::string& key) const {
  const Json& widths = fields.get(key);
  const bool leveled = widths.is_array() && widths.size() == kHighestLevel + 1;
  const Json& value = leveled ? widths[static_cast<std::size_t>(level_)] : widths;
  if (!value.is_number() || value.get<double>() < 0)
    fields.fail(key, "is " + widths.dump(), "give a width in mm, or three for low, medium and high");
  return value.get<double>();
}

double NodeBuilder::blend(Fields& fields) const {
  return fields.optional("k") ? atLevel(fields, "k") : 0;
}

NewNode NodeBuilder::ellipsoid(Fields& fields) {
  const Vec3 radii = fields.vector("radii");
  if ((radii.array() <= 0).any())
    fields.fail("radii", "are not all above 0");
  return makeEllipsoid(fields.vector("center"), radii, rotationFrom(fields));
}

NewNode NodeBuilder::halfSpace(Fields& fields) {
  return makeHalfSpace(fields.vector("point"), fields.direction("normal"));
}

NewNode NodeBuilder::tube(Fields& fields) {
  std::vector<AxisPoint> axis = axisFrom(fields);
  TubeShape shape = tubeShapeFrom(fields, level_);
  if (wall_ > 0) {
    for (AxisPoint& point : axis)
      point.radius -= std::min(wall_, kMostWall * point.radius);
    shape.lumen = {};
    shape.beyond = kBeyondEnds;
  }
  return makeTube(std::move(axis), shape);
}

NewNode NodeBuilder::lumen(Fields& fields) {
  wall_ = atLevel(fields, "wall");
  if (wall_ == 0)
    fields.fail("wall", "is 0", "a lumen has to be narrower than its vessel");
  NodePtr vessels = child(fields, "child");
  wall_ = 0;
  return makeUnion({std::move(vessels)}, 0);
}

NewNode NodeBuilder::unionOf(Fields& fields) {
  std::vector<NodePtr> parts = someChildren(fields);
  return makeUnion(std::move(parts), blend(fields));
}

NewNode NodeBuilder::subtraction(Fields& fields) {
  const NodePtr body = child(fields, "from");
  return makeSubtraction(body, children(fields), blend(fields));
}

NewNode NodeBuilder::intersection(Fields& fields) {
  std::vector<NodePtr> parts = someChildren(fields);
  return makeIntersection(std::move(parts), blend(fields));
}

NewNode NodeBuilder::offset(Fields& fields) {
  const double distance = fields.number("distance");
  return makeOffset(child(fields, "child"), distance);
}

NewNode NodeBuilder::frame(Fields& fields) {
  Placement placement;
  placement.origin = fields.vector("origin", placement.origin);
  placement.rotation = rotationFrom(fields);
  placement.mirror = fields.vector("mirror", placement.mirror);
  placement.scale = fields.positive("scale", placement.scale);
  if (!(placement.mirror.array().abs() == 1).all())
    fields.fail("mirror", "has other numbers than 1 and -1");
  return makeFrame(child(fields, "child"), placement);
}

NewNode NodeBuilder::displacement(Fields& fields) {
  Roughness roughness;
  roughness.amplitude = fields.positive("amplitude", roughness.amplitude);
  roughness.wavelength = fields.positive("wavelength", roughness.wavelength);
  roughness.octaves = fields.integer("octaves", roughness.octaves, 1, kMostOctaves);
  roughness.seed = fields.integer("seed", roughness.seed, 0, kMostSeed);
  return makeDisplacement(child(fields, "child"), roughness);
}

NewNode NodeBuilder::surfaceVessels(Fields& fields) {
  const NodePtr base = child(fields, "base");
  VesselBuilder vessels(*base, level_, [this](const Json& content, const std::string& where) {
    return required(content, where);
  });
  const Json& paths = fields.list("paths");
  for (std::size_t i = 0; i < paths.size(); ++i)
    vessels.add(paths[i], fields.where() + ", paths[" + std::to_string(i) + "]");
  vessels_.insert(vessels_.end(), vessels.vessels().begin(), vessels.vessels().end());
  return makeSurfaceVessels(base, vessels.take(), blend(fields));
}

} // namespace viscera::sample_organs
