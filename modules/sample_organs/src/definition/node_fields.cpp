#include "definition/node_fields.h"

#include <string>

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr double kCoincident = 1e-3; // mm
constexpr int kMostTaeniae = 12;
constexpr int kMostFolds = 100;

double shareOfRadius(Fields& part, const char* key, double otherwise) {
  const double share = part.number(key, otherwise);
  if (share < 0 || share >= 1)
    part.fail(key, "is outside 0 to 1", "it is a share of the radius");
  return share;
}

void readCaps(Fields& fields, TubeShape& shape) {
  const json& caps = fields.list("caps", 2);
  for (std::size_t end = 0; end < 2; ++end) {
    if (caps[end] != "flat" && caps[end] != "round")
      fields.fail("caps", "has " + caps[end].dump(), "use \"flat\" or \"round\" for start and end");
    shape.flatEnd[end] = caps[end] == "flat";
  }
}

void readLumen(Fields& part, bool present, TubeShape& shape) {
  const Lumen lumen{part.positive("wall", Lumen{}.wall), part.positive("depth", Lumen{}.depth)};
  for (const json& end : part.list("ends")) {
    if (end != 0 && end != 1)
      part.fail("ends", "has " + end.dump(), "0 is the start, 1 the end");
    const auto index = end.get<std::size_t>();
    if (!shape.flatEnd[index])
      part.fail("ends", "names an end that is round", "make its cap \"flat\"");
    if (present)
      shape.lumen[index] = lumen;
  }
}

Haustra haustraFrom(Fields& part) {
  Haustra h;
  h.period = part.positive("period", h.period);
  h.depth = shareOfRadius(part, "depth", h.depth);
  h.taeniae = part.integer("taeniae", h.taeniae, 1, kMostTaeniae);
  h.taeniaDepth = part.number("taenia_depth", h.taeniaDepth);
  h.taeniaWidth = part.positive("taenia_width", h.taeniaWidth);
  h.stagger = part.number("stagger", h.stagger);
  h.jitter = part.number("jitter", h.jitter);
  h.seed = part.integer("seed", h.seed, 0, kMostSeed);
  h.from = part.number("from", h.from);
  h.to = part.number("to", h.to);
  return h;
}

Waves wavesFrom(Fields& part) {
  Waves waves;
  waves.period = part.positive("period", waves.period);
  waves.amplitude = shareOfRadius(part, "amplitude", waves.amplitude);
  waves.phase = part.number("phase", waves.phase);
  return waves;
}

Folds foldsFrom(Fields& part) {
  Folds folds;
  folds.count = part.integer("count", folds.count, 1, kMostFolds);
  folds.depth = shareOfRadius(part, "depth", folds.depth);
  folds.wander = part.number("wander", folds.wander);
  folds.wavelength = part.positive("wavelength", folds.wavelength);
  folds.seed = part.integer("seed", folds.seed, 0, kMostSeed);
  folds.from = part.number("from", folds.from);
  folds.to = part.number("to", folds.to);
  return folds;
}

} // namespace

bool presentAt(Fields& fields, int level) {
  return level >= fields.integer("lod", 0, 0, 2);
}

Finish finishFrom(Fields& fields) {
  Finish finish;
  if (fields.optional("paint"))
    finish.paint = fields.vector("paint");
  if (fields.optional("edge_scale"))
    finish.edgeScale = fields.positive("edge_scale");
  if (finish.paint && ((finish.paint->array() < 0).any() || (finish.paint->array() > 1).any()))
    fields.fail("paint", "is outside 0 to 1", "divide by 255 when the colour is in bytes");
  fields.optionalPart("mottle", [&](Fields& part) {
    finish.mottle = Mottle{part.number("amount"), part.positive("wavelength", Mottle{}.wavelength)};
    if (finish.mottle->amount < 0 || finish.mottle->amount > 1)
      part.fail("amount", "is outside 0 to 1", "it is a share of the brightness");
  });
  return finish;
}

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
  fields.optionalPart("flatten", [&](Fields& part) {
    shape.flattenDirection = part.direction("direction");
    shape.flattenFactor = part.positive("factor");
  });
  if (fields.optional("caps"))
    readCaps(fields, shape);
  fields.optionalPart("lumen", [&](Fields& part) { readLumen(part, presentAt(part, level), shape); });
  const auto readRelief = [&](const char* key, auto& relief, auto from) {
    fields.optionalPart(key, [&](Fields& part) {
      const auto read = from(part);
      if (presentAt(part, level))
        relief = read;
    });
  };
  readRelief("haustra", shape.relief.haustra, haustraFrom);
  readRelief("waves", shape.relief.waves, wavesFrom);
  readRelief("folds", shape.relief.folds, foldsFrom);
  shape.rim = fields.number("rim", shape.rim);
  shape.step = fields.positive("step", shape.step);
  return shape;
}

} // namespace viscera::sample_organs
