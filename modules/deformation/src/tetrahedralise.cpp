#include "viscera/deformation/tetrahedralise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

#include <dlfcn.h>

#include "../tetgen_worker/tetgen_exchange.h"
#include "viscera/core/child_process.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/winding_number.h"

namespace viscera::deformation {
namespace {

using Reason = TetrahedraError::Reason;
constexpr int kDataErrorCode = 65;
/// The tetrahedra fill a single closed surface to this part of its volume, or they are of something else.
constexpr double kVolumeTolerance = 1e-6;
constexpr const char* kWorkerName = "viscera_tetgen_worker";
/// A process that was this near to its memory limit when it crashed, crashed because of it.
constexpr double kNearMemoryLimit = 0.7;

std::vector<char> requestFor(const geometry::TriangleMesh& surface, const TetrahedraOptions& options) {
  tetgen_exchange::Request request;
  request.points = static_cast<std::uint64_t>(surface.points.rows());
  request.triangles = static_cast<std::uint64_t>(surface.triangles.rows());
  request.maxVolume = options.maxVolumeMm3;
  request.radiusEdgeRatio = options.radiusEdgeRatio;
  const std::size_t points = sizeof(double) * static_cast<std::size_t>(surface.points.size());
  const std::size_t triangles = sizeof(std::int32_t) * static_cast<std::size_t>(surface.triangles.size());
  std::vector<char> bytes(sizeof request + points + triangles);
  std::memcpy(bytes.data(), &request, sizeof request);
  std::memcpy(bytes.data() + sizeof request, surface.points.data(), points);
  std::memcpy(bytes.data() + sizeof request + points, surface.triangles.data(), triangles);
  return bytes;
}

/// `how` with TetGen's messages; its own hints are about its command line.
Text withMessages(const Text& how, const std::string& messages) {
  std::string line = messages.substr(0, messages.find("Hint"));
  std::replace(line.begin(), line.end(), '\n', ' ');
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
    line.pop_back();
  return line.empty() ? how : phrase("%1: %2", how, line.substr(0, 200));
}

[[noreturn]] void explain(const ChildResult& result, const TetrahedraOptions& options,
                          const std::filesystem::path& worker) {
  using End = ChildResult::End;
  if (result.end == End::notStarted)
    throw TetrahedraError(Reason::missing,
                          phrase("TetGen's program %1 cannot be started: %2", worker.string(),
                                 std::string(std::strerror(result.code))),
                          "install Viscera again, or name it in VISCERA_TETGEN_WORKER");
  if (result.end == End::timeLimit)
    throw TetrahedraError(
        Reason::timeLimit,
        phrase("TetGen was not done after %1 s", std::lround(std::ceil(options.timeLimitSeconds))),
        "ask for fewer witness points");
  std::string lower = result.messages;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  const bool outOfMemory =
      result.end == End::outputLimit ||
      (result.end == End::exited && result.code == tetgen_exchange::kOutOfMemory) ||
      lower.find("memory") != std::string::npos || lower.find("bad_alloc") != std::string::npos ||
      static_cast<double>(result.peakMemoryBytes) > kNearMemoryLimit * double(options.memoryLimitBytes);
  if (outOfMemory)
    throw TetrahedraError(Reason::memoryLimit,
                          phrase("TetGen wanted more than %1 MB of memory", options.memoryLimitBytes >> 20),
                          "ask for fewer witness points");
  const Text how =
      result.end == End::killed ? diagnostic("it crashed") : diagnostic("it stopped without a result");
  throw TetrahedraError(Reason::refused,
                        phrase("TetGen cannot fill this surface (%1)", withMessages(how, result.messages)));
}

[[noreturn]] void unusable(const Text& why) {
  throw TetrahedraError(Reason::unusable, phrase("TetGen's result does not fill this surface: %1", why));
}

/// The points and tetrahedra as they came.
struct Filling {
  Points points;
  Tetrahedra tetrahedra;
};

Filling parse(const std::vector<char>& bytes) {
  tetgen_exchange::Reply reply;
  if (bytes.size() < sizeof reply)
    unusable(diagnostic("the reply is cut short"));
  std::memcpy(&reply, bytes.data(), sizeof reply);
  constexpr std::uint64_t pointBytes = 3 * sizeof(double), tetrahedronBytes = 4 * sizeof(std::int32_t);
  const std::uint64_t rest = bytes.size() - sizeof reply;
  if (reply.magic != tetgen_exchange::kMagic || reply.points > rest / pointBytes ||
      reply.tetrahedra != (rest - reply.points * pointBytes) / tetrahedronBytes ||
      rest != reply.points * pointBytes + reply.tetrahedra * tetrahedronBytes)
    unusable(diagnostic("the reply is damaged"));
  Filling filling;
  filling.points.resize(static_cast<Eigen::Index>(reply.points), 3);
  filling.tetrahedra.resize(static_cast<Eigen::Index>(reply.tetrahedra), 4);
  const char* at = bytes.data() + sizeof reply;
  std::memcpy(filling.points.data(), at, reply.points * pointBytes);
  std::memcpy(filling.tetrahedra.data(), at + reply.points * pointBytes, reply.tetrahedra * tetrahedronBytes);
  if (filling.tetrahedra.rows() == 0)
    unusable("there are no tetrahedra in it; the surface may be open");
  if (filling.tetrahedra.minCoeff() < 0 || filling.tetrahedra.maxCoeff() >= filling.points.rows())
    unusable(diagnostic("a tetrahedron has a corner that does not exist"));
  return filling;
}

/// Makes all tetrahedra positive, whatever TetGen's order is.
void orient(Filling& filling) {
  const Values volumes = tetrahedronVolumes(filling.points, filling.tetrahedra);
  for (Eigen::Index t = 0; t < volumes.size(); ++t)
    if (volumes[t] < 0)
      std::swap(filling.tetrahedra(t, 2), filling.tetrahedra(t, 3));
}

/// Takes the tetrahedra away that lie in a cavity: TetGen fills whatever the outermost surface holds.
void emptyCavities(Filling& filling, const geometry::TriangleMesh& surface) {
  const geometry::WindingNumber winding(surface);
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < filling.tetrahedra.rows(); ++t) {
    Vec3 center = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
      center += filling.points.row(filling.tetrahedra(t, k)).transpose() / 4;
    if (winding.inside(center))
      filling.tetrahedra.row(kept++) = filling.tetrahedra.row(t).eval();
  }
  filling.tetrahedra.conservativeResize(kept, 4);
  if (kept == 0)
    unusable("all of it is a cavity");
}

/// Lexicographic order of rows, for looking points up by their bits.
struct RowsInOrder {
  const Points& points;
  bool operator()(Eigen::Index a, Eigen::Index b) const {
    return std::lexicographical_compare(points.row(a).begin(), points.row(a).end(), points.row(b).begin(),
                                        points.row(b).end());
  }
};

/// The points of the surface first and in their order, as coordinate systems want them.
coordinates::SolidMesh solidOf(const geometry::TriangleMesh& surface, const WitnessMesh& mesh) {
  coordinates::SolidMesh solid;
  const Eigen::Index known = surface.points.rows();
  Points both(known + mesh.points.rows(), 3);
  both << surface.points, mesh.points;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(both.rows()));
  std::iota(order.begin(), order.end(), 0);
  const RowsInOrder before{both};
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<Eigen::Index> names(static_cast<std::size_t>(mesh.points.rows()), -1);
  Eigen::Index found = 0;
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    if (order[i] < known && order[i + 1] >= known && !before(order[i], order[i + 1])) {
      names[static_cast<std::size_t>(order[i + 1] - known)] = order[i];
      ++found;
    }
  if (found != known)
    unusable(diagnostic("%n {point of the surface is|points of the surface are} missing", known - found));
  solid.points.resize(mesh.points.rows(), 3);
  Eigen::Index next = known;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] < 0)
      names[i] = next++;
    solid.points.row(names[i]) = mesh.points.row(static_cast<Eigen::Index>(i));
  }
  solid.tetrahedra = mesh.tetrahedra.unaryExpr([&](std::int32_t corner) {
    return static_cast<std::int32_t>(names[static_cast<std::size_t>(corner)]);
  });
  return solid;
}

/// Puts the points that are not on the skin in front and drops those that no tetrahedron uses.
WitnessMesh ordered(const Filling& filling) {
  enum Use : char { unused, within, onSkin };
  std::vector<char> use(static_cast<std::size_t>(filling.points.rows()), unused);
  for (const std::int32_t corner : filling.tetrahedra.reshaped())
    use[static_cast<std::size_t>(corner)] = within;
  const Triangles skin = skinOf(filling.tetrahedra);
  for (const std::int32_t corner : skin.reshaped())
    use[static_cast<std::size_t>(corner)] = onSkin;
  std::vector<std::int32_t> names(use.size(), -1);
  WitnessMesh mesh;
  mesh.points.resize(filling.points.rows(), 3);
  std::int32_t next = 0;
  for (const char wanted : {within, onSkin}) {
    for (std::size_t i = 0; i < use.size(); ++i)
      if (use[i] == wanted) {
        mesh.points.row(next) = filling.points.row(static_cast<Eigen::Index>(i));
        names[i] = next++;
      }
    if (wanted == within)
      mesh.witnesses = next;
  }
  mesh.points.conservativeResize(next, 3);
  mesh.tetrahedra = filling.tetrahedra.unaryExpr(
      [&](std::int32_t corner) { return names[static_cast<std::size_t>(corner)]; });
  return mesh;
}

} // namespace

TetrahedraError::TetrahedraError(Reason reason, Text what, Text tryThis)
    : Error(kDataErrorCode, std::move(what), {}, std::move(tryThis)), reason_(reason) {}

std::filesystem::path installedTetgenWorker() {
  if (const char* named = std::getenv("VISCERA_TETGEN_WORKER"); named && *named)
    return named;
  Dl_info library{};
  if (dladdr(reinterpret_cast<void*>(&installedTetgenWorker), &library) == 0 || !library.dli_fname)
    return kWorkerName;
  // The loader may have found the library through a link, as /lib is one to /usr/lib.
  std::error_code unreachable;
  const auto real = std::filesystem::weakly_canonical(library.dli_fname, unreachable);
  const auto folder = (unreachable ? std::filesystem::path(library.dli_fname) : real).parent_path();
  for (const char* beside : {VISCERA_LIBEXEC_FROM_LIBDIR, "../bin"})
    if (std::filesystem::exists(folder / beside / kWorkerName, unreachable))
      return (folder / beside / kWorkerName).lexically_normal();
  return (folder / VISCERA_LIBEXEC_FROM_LIBDIR / kWorkerName).lexically_normal();
}

WitnessMesh tetrahedralise(const geometry::TriangleMesh& surface, const TetrahedraOptions& options,
                           Progress& progress) {
  geometry::requireValid(surface, "surface");
  const geometry::SurfaceReport report = geometry::checkSurface(surface);
  if (surface.triangles.rows() == 0 || !report.closed())
    throw TetrahedraError(Reason::refused,
                          phrase("the surface is open (%n boundary {edge|edges})", report.boundaryEdges));
  const std::filesystem::path worker = options.worker.empty() ? installedTetgenWorker() : options.worker;
  ChildResult result = runChild(worker, requestFor(surface, options),
                                {options.timeLimitSeconds, options.memoryLimitBytes}, progress);
  if (result.end != ChildResult::End::exited || result.code != tetgen_exchange::kDone)
    explain(result, options, worker);
  Filling filling = parse(result.output);
  result.output = {};
  orient(filling);
  if (report.components > 1)
    emptyCavities(filling, surface);
  WitnessMesh mesh = ordered(filling);
  const double filled = tetrahedronVolumes(mesh.points, mesh.tetrahedra).sum();
  if (report.components == 1 &&
      !(std::abs(filled - std::abs(report.volumeMm3)) <= kVolumeTolerance * std::abs(report.volumeMm3)))
    unusable(diagnostic("its volume differs from that of the surface"));
  if (mesh.witnesses > 0) // No witness is correct for a coarse surface; the caller decides.
    requireUsable(mesh, "TetGen's tetrahedra");
  return mesh;
}

coordinates::BindOptions withTetgen(coordinates::BindOptions options) {
  if (!options.tetrahedralise)
    options.tetrahedralise = [](const geometry::TriangleMesh& surface, double volumeMm3, Progress& progress) {
      TetrahedraOptions tetgen;
      tetgen.maxVolumeMm3 = volumeMm3;
      return solidOf(surface, tetrahedralise(surface, tetgen, progress));
    };
  return options;
}

} // namespace viscera::deformation
