#include "cli/commands/all_commands.h"

#include <memory>
#include <numeric>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/document/group_commands.h"
#include "viscera/document/open_files.h"
#include "viscera/document/system_commands.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/medical_io/handle_file.h"

namespace viscera::app::cli {
namespace {

constexpr int kEnclosing = 8; ///< Corners of a box.
constexpr int kMostPlacedHandles = 10'000;
constexpr int kMostGroups = 100;

std::vector<int> rowsFrom(Eigen::Index begin, Eigen::Index end) {
  std::vector<int> rows(static_cast<std::size_t>(end - begin));
  std::iota(rows.begin(), rows.end(), static_cast<int>(begin));
  return rows;
}

/// A handle at each position, labelled by its row.
document::Rig labelledRig(const Points& positions) {
  document::Rig rig = document::rigAt(positions);
  for (std::size_t i = 0; i < rig.handles.size(); ++i)
    rig.handles[i].label = "H-" + std::to_string(i + 1);
  return rig;
}

/// Enclosing handles and the others as a group each.
document::Rig plainRig(const Points& positions, bool enclosing) {
  const Eigen::Index corners = enclosing ? kEnclosing : 0;
  document::Rig rig = labelledRig(positions);
  if (enclosing)
    rig.addGroup("Enclosing", {0.55, 0.60, 0.65}, rowsFrom(0, corners));
  if (positions.rows() > corners)
    rig.addGroup("Handles", {1.0, 0.5, 0.2}, rowsFrom(corners, positions.rows()));
  return rig;
}

/// The handles in groups, behind them the corners that grouping added.
document::Rig groupedRig(const Points& positions, const document::Organ& organ,
                         const document::GroupingChoice& choice) {
  const deformation::Grouping grouping =
      document::makeGroups(choice, {std::make_shared<const document::Organ>(organ)}, positions);
  Points all(positions.rows() + grouping.added.rows(), 3);
  all << positions, grouping.added;
  document::Rig rig = labelledRig(all);
  for (std::size_t i = static_cast<std::size_t>(positions.rows()); i < rig.handles.size(); ++i)
    rig.handles[i].description = document::kAddedByGrouping;
  for (std::size_t i = 0; i < grouping.groups.size(); ++i)
    rig.addGroup(grouping.groups[i].name, document::groupColor(i), grouping.groups[i].handles);
  return rig;
}

std::size_t outsideCage(const geometry::TriangleMesh& cage, const Points& points) {
  const geometry::WindingNumber winding(cage);
  std::size_t outside = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    outside += winding.inside(points.row(i).transpose()) ? 0 : 1;
  return outside;
}

/// `viscera handles`: places handles around an organ, or takes a cage's vertices, in groups where they are
/// asked for.
class HandlesCommand final : public Command {
public:
  std::string name() const override { return "handles"; }
  std::string summary() const override { return "Place handles around an organ"; }
  std::vector<OutputOption> outputs() const override { return {handleOutput("--output")}; }

  void addOptions(CLI::App& options) override {
    options.add_option("ORGAN", organ_, "A surface file, or sample:NAME[/SURFACE][@RESOLUTION]")->required();
    options.add_option("-o,--output", output_, "Handle file to write (.mrk.json)")
        ->type_name("FILE")
        ->required();
    CLI::Option* count =
        options.add_option("--count", count_, "How many handles, the enclosing ones included")
            ->type_name("N")
            ->check(wholeBetween(deformation::fewestHandles(false), kMostPlacedHandles))
            ->capture_default_str();
    CLI::Option* enclosing = options.add_flag(
        "--enclosing", enclosing_,
        "Let the first eight be the corners of a box, so that nothing lies outside; this is so by default, "
        "but for --groups and --group-by, which add corners where a part needs them");
    options
        .add_flag("--no-enclosing", notEnclosing_, "Place all handles just off the surface, without the box")
        ->excludes(enclosing);
    options
        .add_option("--cage", cage_,
                    "Take the vertices of this closed surface around the organ; bind with the same --cage")
        ->type_name("FILE")
        ->excludes(count)
        ->excludes(enclosing);
    options
        .add_option(
            "--groups", groups_,
            "Put the handles into so many groups; corners of a box are added where they do not hold a part")
        ->type_name("N")
        ->check(wholeBetween(1, kMostGroups));
    options
        .add_option(
            "--group-by", groupBy_,
            "How: axis (parts along the longest axis), cluster (handles near to each other), organ (one for "
            "each connected piece)")
        ->type_name("WAY")
        ->check(CLI::IsMember({"axis", "cluster", "organ"}));
  }

  Outcome run(CommandContext& context) override {
    const bool enclosing = encloses();
    if (cage_.empty() && count_ < deformation::fewestHandles(enclosing))
      throw UsageError("It is too few for the eight enclosing handles", "--count " + std::to_string(count_),
                       "ask for 8 or more, or leave the box out with --no-enclosing");
    document::GroupingChoice choice;
    choice.by = groupBy_.empty() ? choice.by : document::groupingFromName(groupBy_);
    choice.count = groups_ > 0 ? groups_ : choice.count;
    const document::Organ organ = organInput(organ_, context.samples, context.progress);
    deformation::Placement placement;
    placement.count = count_;
    placement.enclosing = enclosing;
    const auto cage = cage_.empty() ? nullptr : document::readCage(cage_, context.progress).mesh;
    const Points positions = cage ? cage->points : deformation::placeHandles(*organ.mesh, placement);
    const document::Rig rig =
        grouped() ? groupedRig(positions, organ, choice) : plainRig(positions, enclosing);
    const std::size_t outside =
        cage ? outsideCage(*cage, organ.mesh->points)
             : geometry::ConvexHull(rig.restPositions()).outside(organ.mesh->points).size();
    context.progress.throwIfCancelled();
    medical_io::writeHandles(output_, document::handleFile(rig));

    Outcome outcome;
    const std::size_t added = rig.handles.size() - static_cast<std::size_t>(positions.rows());
    outcome.json = {{"organ", organ.name},   {"handles", rig.handles.size()}, {"enclosing", enclosing},
                    {"addedHandles", added}, {"outsideHull", outside},        {"file", output_}};
    Listing listing;
    listing.add("handles", std::to_string(rig.handles.size()));
    if (grouped())
      listing.add("added", std::to_string(added) + " corners of boxes, so that every part is surrounded");
    for (const document::Group& group : rig.groups) {
      outcome.json["groups"].push_back({{"name", group.name}, {"handles", group.handles.size()}});
      listing.add("group", group.name + ", " + std::to_string(group.handles.size()) + " handles");
    }
    outcome.text =
        listing
            .add(cage ? "outside cage" : "outside hull",
                 std::to_string(outside) + " of " + std::to_string(organ.mesh->points.rows()) + " vertices")
            .add("file", output_)
            .text();
    outcome.warnings = organ.warnings;
    if (outside > 0)
      outcome.warnings.push_back(
          std::to_string(outside) +
          (cage ? " vertices lie outside the cage, so most systems cannot bind the "
                  "organ to it; move the cage's vertices outward"
                : " vertices lie outside the handles' hull, so the organ "
                  "cannot be bound to them; without --no-enclosing a box around it is added"));
    return outcome;
  }

private:
  bool grouped() const { return groups_ > 0 || !groupBy_.empty(); }
  /// A cage encloses the organ by itself, and so do groups, which get corners where they do not hold a part.
  bool encloses() const { return enclosing_ || (!notEnclosing_ && !grouped() && cage_.empty()); }

  std::string organ_;
  std::string output_;
  int count_ = 30;
  bool enclosing_ = false;    ///< Asked for.
  bool notEnclosing_ = false; ///< Asked not to.
  int groups_ = 0;            ///< 0: none asked for.
  std::string groupBy_;
  std::string cage_; ///< A surface file whose vertices become the handles; empty: they are placed.
};

} // namespace

std::unique_ptr<Command> handlesCommand() {
  return std::make_unique<HandlesCommand>();
}

} // namespace viscera::app::cli
