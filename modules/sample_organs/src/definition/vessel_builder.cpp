#include "definition/vessel_builder.h"

#include <algorithm>
#include <cmath>

#include "definition/node_fields.h"

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr double kVesselStep = 1.5; // mm; finer than the 3 mm at which vessels are laid on a surface
constexpr int kMostSmoothing = 100;

void readFade(Fields& fields, SurfacePath& path) {
  const json& fade = fields.list("fade", 2);
  for (std::size_t end = 0; end < 2; ++end)
    if (!fade[end].is_number() || fade[end].get<double>() < 0)
      fields.fail("fade", "is " + fade.dump(), "give two lengths in mm, for start and end");
  path.fadeIn = fade[0].get<double>();
  path.fadeOut = fade[1].get<double>();
}

} // namespace

geometry::NamedVessel vesselAlong(const std::vector<AxisPoint>& axis, const Vec3& color) {
  const std::vector<AxisSample> samples = sampleAxis(axis, kVesselStep, Vec3::UnitY());
  const auto count = static_cast<Eigen::Index>(samples.size());
  geometry::NamedVessel vessel{{}, color, Points(count, 3), Values(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    vessel.axis.row(i) = samples[static_cast<std::size_t>(i)].position.transpose();
    vessel.radii[i] = samples[static_cast<std::size_t>(i)].radius;
  }
  return vessel;
}

VesselBuilder::VesselBuilder(const ImplicitNode& base, int level, BuildNode buildNode)
    : base_(base), level_(level), buildNode_(std::move(buildNode)) {}

void VesselBuilder::add(const json& content, const std::string& where) {
  Fields fields(content, where);
  const Finish finish = finishFrom(fields);
  const double seam = fields.positive("seam", SurfaceVessel{}.seam);
  if (!presentAt(fields, level_))
    return;
  const SurfacePath path = pathFrom(fields);
  const bool named = fields.optional("name");
  const json* names = fields.optional("vessel");
  fields.requireNothingElse();
  const std::vector<AxisPoint> axis = axisOnSurface(base_, path);
  if (axis.empty())
    fields.fail("points", "all end at one place on the surface", "move them nearer to the surface");
  if (named && !named_.emplace(fields.text("name"), axis).second)
    fields.fail("name", "is that of another path here", "rename one of them");
  if (names)
    addNamed(*names, axis, finish.paint.value_or(Shade{}.color), fields);
  TubeShape shape;
  shape.step = kVesselStep;
  const NewNode node = makeTube(axis, shape);
  node->setFinish(finish);
  vessels_.push_back({node, seam});
}

/// One name for all of the path, or two with the share of its length between them.
void VesselBuilder::addNamed(const json& names, const std::vector<AxisPoint>& axis, const Vec3& color,
                             const Fields& fields) {
  const bool two = names.is_array() && names.size() == 3 && names[0].is_string() && names[1].is_number() &&
                   names[2].is_string();
  if (!names.is_string() && !two)
    fields.fail("vessel", "is " + names.dump(), "give a name, or [name, share of the length, name]");
  geometry::NamedVessel whole = vesselAlong(axis, color);
  if (!two) {
    whole.name = names.get<std::string>();
    anatomy_.push_back(std::move(whole));
    return;
  }
  const double share = std::clamp(names[1].get<double>(), 0.0, 1.0);
  const Eigen::Index last = whole.axis.rows() - 1;
  const auto at = std::clamp<Eigen::Index>(std::lround(share * static_cast<double>(last)), 1, last - 1);
  anatomy_.push_back(
      {names[0].get<std::string>(), color, whole.axis.topRows(at + 1), whole.radii.head(at + 1)});
  anatomy_.push_back({names[2].get<std::string>(), color, whole.axis.bottomRows(last - at + 1),
                      whole.radii.tail(last - at + 1)});
}

SurfacePath VesselBuilder::pathFrom(Fields& fields) const {
  SurfacePath path;
  path.startRadius = fields.positive("r0", path.startRadius);
  path.endRadius = fields.positive("r1", path.endRadius);
  path.lift = fields.number("lift", path.lift);
  path.smoothing = fields.integer("smooth", path.smoothing, 0, kMostSmoothing);
  if (fields.optional("fade"))
    readFade(fields, path);
  fields.optionalPart("from", [&](Fields& from) { path.points.push_back(branchPoint(from)); });
  for (const json& point : fields.list("points", path.points.empty() ? 2 : 1))
    path.points.push_back(vectorFrom(point, fields.where(), "points"));
  if (fields.optional("between")) {
    const json& between = fields.list("between", 2);
    for (std::size_t side = 0; side < 2; ++side)
      path.between[side] = buildNode_(between[side], fields.where() + ", between");
  }
  return path;
}

Vec3 VesselBuilder::branchPoint(Fields& from) const {
  const auto stem = named_.find(from.text("path"));
  if (stem == named_.end())
    from.fail("path", "is not a path before this one at this resolution",
              named_.empty() ? "give the stem a \"name\" and put it first"
                             : "there are " + listed(namesOf(named_)));
  const double share = from.number("at");
  if (share < 0 || share > 1)
    from.fail("at", "is outside 0 to 1", "0 is the start of the stem, 1 its end");
  const auto last = static_cast<double>(stem->second.size()) - 1;
  return stem->second[static_cast<std::size_t>(std::lround(share * last))].position;
}

} // namespace viscera::sample_organs
