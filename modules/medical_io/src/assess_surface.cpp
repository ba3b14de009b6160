#include "viscera/medical_io/assess_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "file_bytes.h"
#include "space_tag.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/plausible_size.h"

namespace viscera::medical_io {
namespace {

using geometry::SurfaceReport;
using geometry::TriangleMesh;

/// A piece with less of the area than this is a crumb of a segmentation.
constexpr double kCrumb = 0.02;
/// Nearer to the middle than this the side is not checked; farther than the other the file's origin is not in
/// the middle of the body.
constexpr double kBesideMiddleMm = 15;
constexpr double kWithinBodyMm = 250;

Text sizeText(const Vec3& size) {
  return phrase("%1 x %2 x %3 mm", inDigits(size.x()), inDigits(size.y()), inDigits(size.z()));
}

/// One assessment on its way; each member looks at one thing and appends one finding or two.
class Assessment {
public:
  Assessment(const TriangleMesh& mesh, const SurfaceReport& report, const SurfaceOrigin& origin)
      : mesh_(mesh), origin_(origin) {
    result_.report = report;
  }

  SurfaceAssessment run(Progress& progress, Threads threads) {
    const Bounds box = boundsOf(mesh_.points);
    result_.sizeMm = box.high - box.low;
    if (report().closed())
      result_.volumeMl = std::abs(report().volumeMm3) / kMm3PerMl;
    signedMl_ = closedVolumeMl();
    progress.throwIfCancelled();
    result_.selfIntersections = geometry::countSelfIntersections(mesh_, progress, threads);
    subject_ = FindingSubject::axes;
    checkAxes(box);
    subject_ = FindingSubject::size;
    checkSize(box);
    subject_ = FindingSubject::holes;
    checkHoles();
    subject_ = FindingSubject::edges;
    checkEdges();
    subject_ = FindingSubject::facing;
    checkFacing();
    subject_ = FindingSubject::pieces;
    checkPieces();
    subject_ = FindingSubject::crossings;
    checkIntersections();
    return std::move(result_);
  }

private:
  const SurfaceReport& report() const { return result_.report; }

  void add(FindingSeverity severity, Text text, std::vector<std::string> repairs = {}) {
    result_.findings.push_back({severity, std::move(text), std::move(repairs), subject_});
  }

  void checkAxes(const Bounds& box) {
    const auto part = anatomy::partNamed(origin_.name);
    const anatomy::Side side = part ? anatomy::bodySideOf(*part) : anatomy::Side::none;
    const double x = box.center().x();
    const bool telling =
        side != anatomy::Side::none && std::abs(x) > kBesideMiddleMm && std::abs(x) < kWithinBodyMm;
    const bool left = side == anatomy::Side::left;
    if (telling && (x > 0) != left) {
      const long at = std::lround(x);
      const char* why = origin_.statedSpace ? "it may be mirrored" : "the file may be in RAS, or mirrored";
      add(FindingSeverity::doubt,
          left ? phrase(
                     "by its name it belongs on the patient's left, but it lies on the right (x = %1 mm): %2",
                     at, why)
               : phrase(
                     "by its name it belongs on the patient's right, but it lies on the left (x = %1 mm): %2",
                     at, why),
          {"ras-to-lps", "mirror"});
      return;
    }
    if (origin_.statedSpace)
      add(FindingSeverity::good,
          phrase("the file states its axes: %1", named(spaceName(*origin_.statedSpace))));
    else
      add(FindingSeverity::note, "the file does not state its axes: LPS is assumed",
          {"ras-to-lps", "mirror", "y-up"});
  }

  /// Signed; of an open surface as it would be with caps, 0 where it cannot be closed.
  double closedVolumeMl() const {
    if (report().closed())
      return report().volumeMm3 / kMm3PerMl;
    try {
      const TriangleMesh closed = geometry::closeHoles(mesh_).mesh;
      return geometry::volume(closed.points, closed.triangles) / kMm3PerMl;
    } catch (const DataError&) {
      return 0;
    }
  }

  /// An organ of which a part is missing is not of the size that the rest has.
  void checkSize(const Bounds& box) {
    if (origin_.cut)
      add(origin_.cut->sure ? FindingSeverity::doubt : FindingSeverity::note, origin_.cut->text());
    checkFullSize(box);
  }

  void checkFullSize(const Bounds& box) {
    const double volumeMl = std::abs(signedMl_);
    std::vector<std::string> repairs;
    if (!origin_.unitStated) {
      for (const LengthUnit& unit : unitsThatFit(origin_.name, box.diagonal(), volumeMl))
        repairs.push_back("unit-" + std::string(unit.id));
      if (auto doubt = doubtAboutSize(origin_.name, box.diagonal()))
        return add(FindingSeverity::fault, std::move(*doubt), std::move(repairs));
    }
    if (volumeMl > 0)
      if (auto doubt = doubtAboutVolume(origin_.name, volumeMl))
        return add(FindingSeverity::doubt, std::move(*doubt), std::move(repairs));
    if (!origin_.cut || !origin_.cut->sure)
      add(FindingSeverity::good, phrase("the size is plausible: %1", sizeText(result_.sizeMm)));
  }

  void checkHoles() {
    if (report().closed())
      return add(FindingSeverity::good, "the surface is closed");
    add(FindingSeverity::fault,
        phrase("%n boundary {edge|edges}: the surface is open and has no volume", report().boundaryEdges),
        signedMl_ != 0 ? std::vector<std::string>{"fill-holes", "remesh"}
                       : std::vector<std::string>{"remesh"});
  }

  void checkEdges() {
    if (report().nonManifoldEdges > 0)
      add(FindingSeverity::fault,
          phrase("%n {edge joins|edges join} more than two triangles", report().nonManifoldEdges),
          {"remesh"});
    else
      add(FindingSeverity::good, "no edge joins more than two triangles");
    if (report().degenerateTriangles > 0)
      add(FindingSeverity::note,
          phrase("%n {triangle has|triangles have} no area", report().degenerateTriangles), {"remesh"});
  }

  void checkFacing() {
    if (report().misorientedEdges > 0)
      add(FindingSeverity::fault,
          phrase("%n {edge lies|edges lie} between triangles of opposite orientation",
                 report().misorientedEdges),
          {"orient"});
    else if (signedMl_ < 0)
      add(FindingSeverity::fault, "the surface is inside out", {"orient"});
    else
      add(FindingSeverity::good, "the triangles face outward");
  }

  void checkPieces() {
    if (report().components <= 1)
      return add(FindingSeverity::good, "the surface is of one piece");
    const std::vector<double> areas = geometry::areasOf(geometry::connectedPieces(mesh_), mesh_);
    const double whole = report().areaMm2;
    const auto crumbs =
        std::count_if(areas.begin(), areas.end(), [&](double area) { return area < kCrumb * whole; });
    Text text = phrase("the surface consists of %1 separate pieces", report().components);
    if (crumbs == 0)
      return add(FindingSeverity::note, std::move(text), {"keep-largest"});
    add(FindingSeverity::doubt,
        phrase("%2, %n of them {is a small fragment|are small fragments} of less than 2 % of its area",
               crumbs, text),
        {"remove-fragments", "keep-largest"});
  }

  void checkIntersections() {
    if (result_.selfIntersections == 0)
      return add(FindingSeverity::good, "the surface does not cross itself");
    add(FindingSeverity::doubt,
        phrase("%n {pair of triangles crosses|pairs of triangles cross} each other: stress mode may have to "
               "repair the surface first",
               result_.selfIntersections),
        {"remesh"});
  }

  const TriangleMesh& mesh_;
  const SurfaceOrigin& origin_;
  SurfaceAssessment result_;
  FindingSubject subject_ = FindingSubject::axes; ///< Of what is added next.
  double signedMl_ = 0;                           ///< Whose sign says where the triangles face.
};

} // namespace

FindingSeverity SurfaceAssessment::worst() const {
  FindingSeverity severity = FindingSeverity::good;
  for (const Finding& finding : findings)
    severity = std::max(severity, finding.severity);
  return severity;
}

SurfaceAssessment assessSurface(const TriangleMesh& mesh, const SurfaceOrigin& origin, Progress& progress,
                                Threads threads) {
  return assessSurface(mesh, geometry::checkSurface(mesh), origin, progress, threads);
}

SurfaceAssessment assessSurface(const TriangleMesh& mesh, const SurfaceReport& report,
                                const SurfaceOrigin& origin, Progress& progress, Threads threads) {
  return Assessment(mesh, report, origin).run(progress, threads);
}

} // namespace viscera::medical_io
