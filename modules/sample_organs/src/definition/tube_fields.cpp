#include "definition/tube_fields.h"

#include <algorithm>
#include <string>

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr double kCoincident = 1e-3; // mm
constexpr int kMostTaeniae = 12;
constexpr int kMostFolds = 100;
constexpr int kMostSeed = 1'000'000;

bool presentAt(Fields& part, int level) {
  return level >= part.integer("lod", 0, 0, 2);
}

void readCaps(Fields& fields, TubeShape& shape) {
  const json& caps = fields.list("caps", 2);
  for (std::size_t end = 0; end < 2; ++end) {
    if (caps[end] != "flat" && caps[end] != "round")
      fields.fail("caps", "has " + caps[end].dump(), "use \"flat\" or \"round\" for start and end");
    shape.flatEnd[end] = caps[end] == "flat";
  }
}

void readLumen(Fields& fields, int level, TubeShape& shape) {
  Fields part(fields.get("lumen"), fields.where() + ", lumen");
  const Lumen lumen{part.positive("wall", Lumen{}.wall), part.positive("depth", Lumen{}.depth)};
  const bool present = presentAt(part, level);
  for (const json& end : part.list("ends")) {
    if (end != 0 && end != 1)
      part.fail("ends", "has " + end.dump(), "0 is the start, 1 the end");
    const auto index = end.get<std::size_t>();
    if (!shape.flatEnd[index])
      part.fail("ends", "names an end that is round", "make its cap \"flat\"");
    if (present)
      shape.lumen[index] = lumen;
  }
  part.requireNothingElse();
}

void readHaustra(Fields& fields, int level, TubeShape& shape) {
  Fields part(fields.get("haustra"), fields.where() + ", haustra");
  Haustra h;
  h.period = part.positive("period", h.period);
  h.depth = part.number("depth", h.depth);
  h.taeniae = part.integer("taeniae", h.taeniae, 1, kMostTaeniae);
  h.taeniaDepth = part.number("taenia_depth", h.taeniaDepth);
  h.taeniaWidth = part.positive("taenia_width", h.taeniaWidth);
  h.stagger = part.number("stagger", h.stagger);
  h.jitter = part.number("jitter", h.jitter);
  h.seed = part.integer("seed", h.seed, 0, kMostSeed);
  h.from = part.number("from", h.from);
  h.to = part.number("to", h.to);
  if (h.depth < 0 || h.depth >= 1)
    part.fail("depth", "is outside 0 to 1", "it is a share of the radius");
  if (presentAt(part, level))
    shape.relief.haustra = h;
  part.requireNothingElse();
}

void readWaves(Fields& fields, int level, TubeShape& shape) {
  Fields part(fields.get("waves"), fields.where() + ", waves");
  Waves waves;
  waves.period = part.positive("period", waves.period);
  waves.amplitude = part.number("amplitude", waves.amplitude);
  waves.phase = part.number("phase", waves.phase);
  if (waves.amplitude < 0 || waves.amplitude >= 1)
    part.fail("amplitude", "is outside 0 to 1", "it is a share of the radius");
  if (presentAt(part, level))
    shape.relief.waves = waves;
  part.requireNothingElse();
}

void readFolds(Fields& fields, int level, TubeShape& shape) {
  Fields part(fields.get("folds"), fields.where() + ", folds");
  Folds folds;
  folds.count = part.integer("count", folds.count, 1, kMostFolds);
  folds.depth = part.number("depth", folds.depth);
  folds.wander = part.number("wander", folds.wander);
  folds.wavelength = part.positive("wavelength", folds.wavelength);
  folds.seed = part.integer("seed", folds.seed, 0, kMostSeed);
  folds.from = part.number("from", folds.from);
  folds.to = part.number("to", folds.to);
  if (folds.depth < 0 || folds.depth >= 1)
    part.fail("depth", "is outside 0 to 1", "it is a share of the radius");
  if (presentAt(part, level))
    shape.relief.folds = folds;
  part.requireNothingElse();
}

} // namespace

std::vector<AxisPoint> axisFrom(Fields& fields) {
  std::vector<AxisPoint> axis;
  for (const json& item : fields.list("points", 2)) {
    const std::string key = "points[" + std::to_string(axis.size()) + "]";
    const bool good = item.is_array() && item.size() == 4 && item[3].is_number();
    if (!good)
      fields.fail(key, "is " + item.dump(), "write each point as [x, y, z, radius]");
    const AxisPoint point{vectorFrom(json::array({item[0], item[1], item[2]}), fields.where(), key),
                          item[3].get<double>()};
    if (!(point.radius > 0))
      fields.fail(key, "has the radius " + item[3].dump(), "it must be above 0");
    if (!axis.empty() && (point.position - axis.back().position).norm() < kCoincident)
      fields.fail(key, "lies on the point before it", "remove one of the two");
    axis.push_back(point);
  }
  return axis;
}

TubeShape tubeShapeFrom(Fields& fields, int level) {
  TubeShape shape;
  for (const char* part : {"flatten", "caps", "lumen", "haustra", "waves", "folds"})
    fields.ignore(part);
  if (fields.has("flatten")) {
    Fields flatten(fields.get("flatten"), fields.where() + ", flatten");
    shape.flattenDirection = flatten.direction("direction");
    shape.flattenFactor = flatten.positive("factor");
    flatten.requireNothingElse();
  }
  if (fields.has("caps"))
    readCaps(fields, shape);
  if (fields.has("lumen"))
    readLumen(fields, level, shape);
  if (fields.has("haustra"))
    readHaustra(fields, level, shape);
  if (fields.has("waves"))
    readWaves(fields, level, shape);
  if (fields.has("folds"))
    readFolds(fields, level, shape);
  shape.rim = fields.number("rim", shape.rim);
  shape.step = fields.positive("step", shape.step);
  return shape;
}

} // namespace viscera::sample_organs
