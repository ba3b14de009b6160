#include "cli/commands/handles_command.h"

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/medical_io/handle_file.h"

namespace viscera::app::cli {
namespace {

constexpr int kEnclosing = 8; ///< Corners of a box.
constexpr int kMostHandles = 10'000;

medical_io::HandleGroupRecord group(const std::string& name, const Vec3& color, const Points& positions,
                                    Eigen::Index begin, Eigen::Index end) {
  medical_io::HandleGroupRecord record{name, color, {}};
  for (Eigen::Index i = begin; i < end; ++i)
    record.handles.push_back({"H-" + std::to_string(i + 1), positions.row(i).transpose(), {}, false, true});
  return record;
}

medical_io::HandleFile fileOf(const Points& positions, bool enclosing) {
  medical_io::HandleFile file;
  const Eigen::Index corners = enclosing ? kEnclosing : 0;
  if (enclosing)
    file.groups.push_back(group("Enclosing", {0.55, 0.60, 0.65}, positions, 0, corners));
  if (positions.rows() > corners)
    file.groups.push_back(group("Handles", {1.0, 0.5, 0.2}, positions, corners, positions.rows()));
  return file;
}

} // namespace

void HandlesCommand::addOptions(CLI::App& options) {
  options.add_option("ORGAN", organ_, "A surface file, or sample:NAME[/SURFACE][@RESOLUTION]")->required();
  options.add_option("-o,--output", output_, "Handle file to write (.mrk.json)")
      ->type_name("FILE")
      ->required();
  options.add_option("--count", count_, "How many handles, the enclosing ones included")
      ->type_name("N")
      ->check(CLI::Range(4, kMostHandles))
      ->capture_default_str();
  options.add_flag("--enclosing", enclosing_,
                   "Let the first eight be the corners of a box, so that nothing lies outside");
}

Outcome HandlesCommand::run(Surroundings& surroundings) {
  if (enclosing_ && count_ < kEnclosing)
    throw UsageError("is too few for the eight enclosing handles", "--count " + std::to_string(count_),
                     "ask for 8 or more");
  const session::Organ organ = organInput(organ_, surroundings.samples, surroundings.progress);
  deformation::Placement placement;
  placement.count = count_;
  placement.enclosing = enclosing_;
  const Points positions = deformation::placeHandles(*organ.mesh, placement);
  const std::size_t outside = geometry::ConvexHull(positions).outside(organ.mesh->points).size();
  surroundings.progress.throwIfCancelled();
  medical_io::writeHandles(output_, fileOf(positions, enclosing_));

  Outcome outcome;
  outcome.json = {{"organ", organ.name},
                  {"handles", positions.rows()},
                  {"enclosing", enclosing_},
                  {"outsideHull", outside},
                  {"file", output_}};
  outcome.text = Listing()
                     .add("handles", std::to_string(positions.rows()))
                     .add("outside hull", std::to_string(outside) + " of " +
                                              std::to_string(organ.mesh->points.rows()) + " vertices")
                     .add("file", output_)
                     .text();
  outcome.warnings = organ.warnings;
  if (outside > 0)
    outcome.warnings.push_back(std::to_string(outside) +
                               " vertices lie outside the handles' hull, so the organ "
                               "cannot be bound to them; --enclosing adds handles around it");
  return outcome;
}

} // namespace viscera::app::cli
