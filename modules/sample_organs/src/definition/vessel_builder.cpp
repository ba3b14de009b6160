#include "definition/vessel_builder.h"

#include <cmath>
#include <memory>
#include <set>

#include "definition/finish_fields.h"
#include "implicit/tube.h"

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr double kVesselStep = 1.5; // mm; finer than the 3 mm at which vessels are laid on a surface
constexpr int kMostSmoothing = 100;

} // namespace

VesselBuilder::VesselBuilder(const ImplicitNode& base, int level, BuildNode buildNode)
    : base_(base), level_(level), buildNode_(std::move(buildNode)) {}

void VesselBuilder::add(const json& content, const std::string& where) {
  Fields fields(content, where);
  const Finish finish = finishFrom(fields);
  const double seam = fields.positive("seam", SurfaceVessel{}.seam);
  if (level_ < fields.integer("lod", 0, 0, 2))
    return;
  const SurfacePath path = pathFrom(fields);
  fields.ignore("name");
  fields.requireNothingElse();
  const std::vector<AxisPoint> axis = axisOnSurface(base_, path);
  if (axis.empty())
    fields.fail("points", "all end at one place on the surface", "move them nearer to the surface");
  if (fields.has("name") && !named_.emplace(fields.text("name"), axis).second)
    fields.fail("name", "is that of another path here", "rename one of them");
  TubeShape shape;
  shape.step = kVesselStep;
  const auto node = std::make_shared<Tube>(axis, shape);
  node->setFinish(finish);
  vessels_.push_back({node, seam});
}

SurfacePath VesselBuilder::pathFrom(Fields& fields) const {
  SurfacePath path;
  path.startRadius = fields.positive("r0", path.startRadius);
  path.endRadius = fields.positive("r1", path.endRadius);
  path.lift = fields.number("lift", path.lift);
  path.smoothing = fields.integer("smooth", path.smoothing, 0, kMostSmoothing);
  readFade(fields, path);
  readPoints(fields, path);
  fields.ignore("between");
  if (fields.has("between")) {
    const json& between = fields.list("between", 2);
    for (std::size_t side = 0; side < 2; ++side)
      path.between[side] = buildNode_(between[side], fields.where() + ", between");
  }
  return path;
}

void VesselBuilder::readPoints(Fields& fields, SurfacePath& path) const {
  fields.ignore("from");
  if (fields.has("from"))
    path.points.push_back(branchPoint(fields));
  for (const json& point : fields.list("points", fields.has("from") ? 1 : 2))
    path.points.push_back(vectorFrom(point, fields.where(), "points"));
}

void VesselBuilder::readFade(Fields& fields, SurfacePath& path) const {
  fields.ignore("fade");
  if (!fields.has("fade"))
    return;
  const json& fade = fields.list("fade", 2);
  for (std::size_t end = 0; end < 2; ++end)
    if (!fade[end].is_number() || fade[end].get<double>() < 0)
      fields.fail("fade", "is " + fade.dump(), "give two lengths in mm, for start and end");
  path.fadeIn = fade[0].get<double>();
  path.fadeOut = fade[1].get<double>();
}

Vec3 VesselBuilder::branchPoint(Fields& fields) const {
  Fields from(fields.get("from"), fields.where() + ", from");
  const auto stem = named_.find(from.text("path"));
  if (stem == named_.end()) {
    std::set<std::string> names;
    for (const auto& item : named_)
      names.insert(item.first);
    from.fail("path", "is no path before this one at this resolution",
              names.empty() ? "give the stem a \"name\" and put it first" : "there are " + listed(names));
  }
  const double share = from.number("at");
  if (share < 0 || share > 1)
    from.fail("at", "is outside 0 to 1", "0 is the start of the stem, 1 its end");
  from.requireNothingElse();
  const auto last = static_cast<double>(stem->second.size()) - 1;
  return stem->second[static_cast<std::size_t>(std::lround(share * last))].position;
}

} // namespace viscera::sample_organs
