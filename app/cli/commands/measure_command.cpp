#include "cli/commands/all_commands.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/organ_group.h"
#include "cli/positions.h"
#include "cli/system_options.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/sides_of_plane.h"
#include "viscera/geometry/surface_gap.h"
#include "viscera/live/movable_binding.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

constexpr double kMm2OfCm2 = 100;
constexpr std::size_t kMostPairs = 66; ///< All of twelve organs.

/// "X,Y,Z:NX,NY,NZ": a point of the plane, and the direction that it faces.
geometry::Plane planeFrom(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    throw UsageError("a plane is X,Y,Z:NX,NY,NZ, a point in mm and a direction", "--plane " + text);
  const Vec3 normal = positionOf(text.substr(colon + 1), "--plane");
  if (!(normal.norm() > 0))
    throw UsageError("the direction of a plane must not be zero", "--plane " + text);
  return {positionOf(text.substr(0, colon), "--plane"), normal.normalized()};
}

/// An organ in the pose.
struct PosedSurface {
  const document::Organ* organ = nullptr;
  Points points;
};

/// `viscera measure`: distances between organs, and what a plane leaves of them.
class MeasureCommand final : public Command {
public:
  std::string name() const override { return "measure"; }
  std::string summary() const override {
    return "Measure distances between organs, and volumes on both sides of a plane";
  }

  void addOptions(CLI::App& options) override {
    options
        .add_option("ORGAN", inputs_,
                    "Surface files, label maps, sessions or sample:NAME; all organs in them, or FILE/ORGAN")
        ->required();
    options.add_option("--from", from_, "Only the distances from this organ, by its name")->type_name("NAME");
    options
        .add_option("--plane", plane_,
                    "The volumes on both sides of the plane through X,Y,Z (mm, LPS) that faces NX,NY,NZ")
        ->type_name("X,Y,Z:NX,NY,NZ");
    CLI::Option* handles =
        options.add_option("--handles", handles_, "The rest handles (.mrk.json), for a pose")
            ->type_name("FILE");
    options
        .add_option("--pose", pose_,
                    "Where the handles are (.mrk.json), by their labels; others stay at rest")
        ->type_name("FILE")
        ->needs(handles);
    system_.addTo(options);
  }

  Outcome run(CommandContext& context) override {
    std::optional<geometry::Plane> plane;
    if (!plane_.empty())
      plane = planeFrom(plane_);
    const OrganGroup group = organGroup(inputs_, context.samples, context.progress);
    Outcome outcome;
    outcome.warnings = group.warnings;
    const std::vector<PosedSurface> surfaces = posed(group, context, outcome.warnings);
    Listing listing;
    outcome.json["distances"] = distances(surfaces, group, listing, context.progress);
    if (plane)
      outcome.json["resection"] = resection(surfaces, *plane, listing);
    outcome.json["warnings"] = outcome.warnings;
    outcome.text = listing.text();
    return outcome;
  }

private:
  std::vector<PosedSurface> posed(const OrganGroup& group, CommandContext& context,
                                  std::vector<Text>& warnings) const {
    std::vector<PosedSurface> surfaces;
    for (const document::Organ& organ : group.organs)
      surfaces.push_back({&organ, organ.mesh->points});
    if (pose_.empty())
      return surfaces;
    const auto system = system_.system(context);
    const auto options = system_.bindOptions(*system, context);
    const document::Rig rig = rigInput(handles_, warnings, system_.cage());
    const coordinates::HandleSet handles = document::handleSet(rig);
    const Points pose = poseInput(pose_, rig, warnings);
    for (PosedSurface& surface : surfaces)
      live::bindMovable(*surface.organ, *system, handles, options, context.progress)
          ->deform(pose, surface.points, options.threads);
    return surfaces;
  }

  std::size_t placeOf(const std::string& name, const OrganGroup& group) const {
    const auto found = std::find_if(group.organs.begin(), group.organs.end(),
                                    [&name](const document::Organ& organ) { return organ.name == name; });
    if (found != group.organs.end())
      return static_cast<std::size_t>(found - group.organs.begin());
    std::string names;
    for (const document::Organ& organ : group.organs)
      names += (names.empty() ? "" : ", ") + organ.name;
    throw UsageError("there is no organ of that name", "--from " + name, "the organs are: " + names);
  }

  /// Distances of all pairs, or of one organ with all others.
  ordered_json distances(const std::vector<PosedSurface>& surfaces, const OrganGroup& group, Listing& listing,
                         Progress& progress) const {
    const std::size_t count = surfaces.size();
    const std::size_t from = from_.empty() ? count : placeOf(from_, group); // `count`: from each.
    if (from == count && count * (count - 1) / 2 > kMostPairs)
      throw UsageError("there are too many pairs of organs", std::to_string(count) + " organs",
                       "name one with --from");
    std::deque<geometry::SurfaceBoxes> boxes;
    for (const PosedSurface& surface : surfaces) {
      progress.throwIfCancelled();
      boxes.emplace_back(surface.points, surface.organ->mesh->triangles);
    }
    ordered_json list = ordered_json::array();
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b) {
        if (from < count ? a != from || b == a : b <= a)
          continue;
        progress.throwIfCancelled();
        const geometry::SurfaceGap gap = geometry::gapBetween(boxes[a], boxes[b]);
        const std::string &nameA = surfaces[a].organ->name, &nameB = surfaces[b].organ->name;
        list.push_back({{"from", nameA},
                        {"to", nameB},
                        {"distanceMm", gap.mm},
                        {"touching", gap.mm == 0},
                        {"fromMm", numbersJson(gap.from)},
                        {"toMm", numbersJson(gap.to)}});
        listing.add(nameA + " - " + nameB, gap.mm == 0 ? "touch or cross" : fixed(gap.mm, 2) + " mm");
      }
    return list;
  }

  ordered_json resection(const std::vector<PosedSurface>& surfaces, const geometry::Plane& plane,
                         Listing& listing) const {
    ordered_json organs = ordered_json::array();
    for (const PosedSurface& surface : surfaces) {
      const document::Organ& organ = *surface.organ;
      if (!organ.closed()) {
        listing.add(organ.name, "no volume: the surface is open");
        organs.push_back(
            {{"organ", organ.name}, {"frontMl", nullptr}, {"backMl", nullptr}, {"faceCm2", nullptr}});
        continue;
      }
      const geometry::SidesOfPlane sides =
          geometry::sidesOfPlane({&surface.points, &organ.mesh->triangles}, plane);
      const double front = sides.frontMm3 / kMm3PerMl, back = sides.backMm3 / kMm3PerMl;
      organs.push_back({{"organ", organ.name},
                        {"frontMl", front},
                        {"backMl", back},
                        {"faceCm2", sides.faceMm2 / kMm2OfCm2}});
      listing.add(organ.name, fixed(front, 3) + " ml in front of the plane, " + fixed(back, 3) +
                                  " ml behind it, face " + fixed(sides.faceMm2 / kMm2OfCm2, 2) + " cm2");
    }
    return {
        {"originMm", numbersJson(plane.origin)}, {"normal", numbersJson(plane.normal)}, {"organs", organs}};
  }

  std::vector<std::string> inputs_;
  std::string from_;
  std::string plane_;
  std::string handles_;
  std::string pose_;
  SystemOptions system_;
};

} // namespace

std::unique_ptr<Command> measureCommand() {
  return std::make_unique<MeasureCommand>();
}

} // namespace viscera::app::cli
