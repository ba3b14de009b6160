#include "viscera/lesson/animated_gltf.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "carried_vertices.h"
#include "gltf_buffer.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/geometry/normals.h"

namespace viscera::lesson {
namespace {

using nlohmann::ordered_json;

/// Tolerances for a vertex, tried one after the other until the file is small enough.
constexpr double kTriedMm[] = {0.02, 0.05, 0.1, 0.2, 0.35, 0.5};
constexpr double kBetweenKeysMm = 0.02; ///< The same between keys.
constexpr Eigen::Index kFewestKeys = 96;
constexpr Eigen::Index kMostKeys = 768;
constexpr double kRoughness = 0.55;

/// The weights of the modes as the file has them: keys evenly over a cycle, straight lines between them.
struct Keys {
  Table weights;    ///< `keys x modes`, the last one closes the cycle.
  double offMm = 0; ///< In the middle between two.
};

Keys keysOf(const SampledMotion& motion, Eigen::Index count) {
  Keys keys{Table(count + 1, motion.courses.front().values.cols()), 0};
  Table off(count, keys.weights.cols());
  const auto at = [&](double key) {
    const double fraction = key / static_cast<double>(count);
    return valueAt(motion.courses.front(), std::min(fraction, 1.0)).transpose().eval();
  };
  for (Eigen::Index key = 0; key <= count; ++key)
    keys.weights.row(key) = at(static_cast<double>(key));
  for (Eigen::Index key = 0; key < count; ++key)
    off.row(key) =
        (keys.weights.row(key) + keys.weights.row(key + 1)) / 2 - at(static_cast<double>(key) + 0.5);
  keys.offMm = largestDifference(motion.modes, off).mm;
  return keys;
}

/// Everything of a file but its bytes.
class Scene {
public:
  Scene(const LessonPlan& plan, const document::DocumentState& state, const Points& points,
        const SampledMotion& motion, const Keys& keys)
      : plan_(plan), motion_(motion) {
    Eigen::Index first = 0;
    for (const PlannedSurface& surface : plan.surfaces) {
      const auto organ = state.organ(surface.organ);
      addSurface(surface, *organ, points, first, keys);
      first += organ->mesh->points.rows();
    }
    addRoot();
    if (!motion.modes.empty())
      addAnimation(keys);
  }

  std::string file() const { return buffer_.fileOf(tree_); }

private:
  void addSurface(const PlannedSurface& planned, const document::Organ& organ, const Points& points,
                  Eigen::Index first, const Keys& keys) {
    geometry::TriangleMesh mesh = *organ.mesh;
    mesh.points = points.middleRows(first, mesh.points.rows());
    const geometry::Normals normals = geometry::vertexNormals(mesh);
    ordered_json attributes = {{"POSITION", buffer_.addVectors(mesh.points, true)},
                               {"NORMAL", buffer_.addVectors(normals.cast<double>(), false)}};
    if (planned.vertexColors)
      attributes["COLOR_0"] = buffer_.addColors(mesh.colors);
    ordered_json targets = ordered_json::array(), names = ordered_json::array();
    for (const Points& mode : motion_.modes) {
      targets.push_back(
          ordered_json{{"POSITION", buffer_.addVectors(mode.middleRows(first, mesh.points.rows()), true)}});
      names.push_back("mode " + std::to_string(names.size() + 1));
    }
    const std::vector<std::int32_t> indices(mesh.triangles.data(),
                                            mesh.triangles.data() + mesh.triangles.size());
    ordered_json primitive = {{"attributes", std::move(attributes)},
                              {"indices", buffer_.addIndices(indices, mesh.points.rows())},
                              {"material", tree_["materials"].size()}};
    ordered_json solid = {{"name", planned.title}};
    if (!targets.empty()) {
      primitive["targets"] = std::move(targets);
      const Eigen::VectorXd begin = keys.weights.row(0).transpose();
      solid["weights"] = std::vector<double>(begin.data(), begin.data() + begin.size());
      solid["extras"] = {{"targetNames", std::move(names)}};
    }
    solid["primitives"] = ordered_json::array({std::move(primitive)});
    tree_["nodes"].push_back({{"name", planned.title}, {"mesh", tree_["meshes"].size()}});
    tree_["meshes"].push_back(std::move(solid));
    tree_["materials"].push_back(materialOf(planned));
  }

  static ordered_json materialOf(const PlannedSurface& planned) {
    const bool clear = planned.opacity < 1;
    const auto channel = [&](int i) { // sRGB's exponent; colours of vertices are multiplied with it.
      return planned.vertexColors ? 1.0 : std::pow(planned.color[i], 2.2);
    };
    return {{"name", planned.title},
            {"doubleSided", clear},
            {"alphaMode", clear ? "BLEND" : "OPAQUE"},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {channel(0), channel(1), channel(2), clear ? planned.opacity : 1.0}},
              {"metallicFactor", 0},
              {"roughnessFactor", kRoughness}}}};
  }

  /// LPS mm to metres with y up: x stays, y is z, z is -y.
  void addRoot() {
    ordered_json children = ordered_json::array();
    for (std::size_t i = 0; i < plan_.surfaces.size(); ++i)
      children.push_back(i);
    tree_["nodes"].push_back({{"name", plan_.title},
                              {"children", std::move(children)},
                              {"matrix", {.001, 0, 0, 0, 0, 0, -.001, 0, 0, .001, 0, 0, 0, 0, 0, 1}}});
    tree_["scenes"] =
        ordered_json::array({ordered_json{{"nodes", ordered_json::array({plan_.surfaces.size()})}}});
  }

  void addAnimation(const Keys& keys) {
    std::vector<float> seconds, weights;
    const auto last = static_cast<double>(keys.weights.rows() - 1);
    for (Eigen::Index key = 0; key < keys.weights.rows(); ++key)
      seconds.push_back(static_cast<float>(60 / plan_.rate * static_cast<double>(key) / last));
    for (Eigen::Index i = 0; i < keys.weights.size(); ++i)
      weights.push_back(static_cast<float>(keys.weights.data()[i]));
    const std::size_t input = buffer_.addNumbers(seconds, true), output = buffer_.addNumbers(weights, false);
    ordered_json channels = ordered_json::array();
    for (std::size_t node = 0; node < plan_.surfaces.size(); ++node)
      channels.push_back({{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    tree_["animations"] = ordered_json::array(
        {ordered_json{{"name", plan_.title},
                      {"samplers", ordered_json::array({ordered_json{
                                       {"input", input}, {"output", output}, {"interpolation", "LINEAR"}}})},
                      {"channels", std::move(channels)}}});
  }

  const LessonPlan& plan_;
  const SampledMotion& motion_;
  GltfBuffer buffer_;
  ordered_json tree_ = {
      {"asset",
       {{"version", "2.0"}, {"generator", "Viscera"}, {"extras", {{"SPACE", "LPS"}, {"unit", "mm"}}}}},
      {"scene", 0},
      {"scenes", ordered_json::array()},
      {"nodes", ordered_json::array()},
      {"meshes", ordered_json::array()},
      {"materials", ordered_json::array()}};
};

/// The largest distance from the organs themselves at the keys and between them.
double largestError(const SampledMotion& motion, const Keys& keys, double rate, CarriedVertices& carried) {
  constexpr Eigen::Index kChecked = 12;
  const Eigen::Index count = keys.weights.rows() - 1;
  double largest = 0;
  Points pose;
  for (Eigen::Index i = 0; i < kChecked; ++i) {
    const Eigen::Index key = i * count / kChecked;
    const bool between = i % 2 == 1;
    Points points = carried.rest();
    for (std::size_t k = 0; k < motion.modes.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const double next = keys.weights(key + 1, column), own = keys.weights(key, column);
      points += (between ? (own + next) / 2 : own) * motion.modes[k];
    }
    carried.poseAt((static_cast<double>(key) + (between ? 0.5 : 0)) / static_cast<double>(count), rate, pose);
    largest = std::max(largest, (carried.in(pose)-points).rowwise().norm().maxCoeff());
  }
  return largest;
}

} // namespace

WrittenGltf writeAnimatedGltf(const std::filesystem::path& file, const LessonPlan& asked,
                              const LessonSource& source, live::PosedOrgans& organs, Progress& progress,
                              Threads threads) {
  LessonPlan plan = asked;
  plan.ownHandles = false;
  CarriedVertices carried(plan, source, organs, threads);
  WrittenGltf written;
  std::string bytes;
  if (!source.sequence)
    bytes = Scene(plan, source.state, carried.in(*source.state.pose), {}, {}).file();
  else {
    const MotionSamples samples =
        sampleMotion({plan.rate}, carried.weights(), carried.carriersAt(), kBetweenKeysMm, progress);
    for (const double tried : kTriedMm) {
      const SampledMotion motion = motionOf(samples, carried.weights(), tried, progress, threads);
      Eigen::Index count = kFewestKeys;
      Keys keys = keysOf(motion, count);
      while (keys.offMm > kBetweenKeysMm && count < kMostKeys)
        keys = keysOf(motion, count *= 2);
      bytes = Scene(plan, source.state, carried.rest(), motion, keys).file();
      written = {0, motion.modes.size(), static_cast<std::size_t>(count),
                 largestError(motion, keys, plan.rate, carried)};
      if (bytes.size() <= kMostGltfBytes)
        break;
    }
  }
  written.bytes = bytes.size();
  writeAtomically(file, [&](std::ostream& stream) { stream << bytes; });
  progress.report(1);
  return written;
}

} // namespace viscera::lesson
