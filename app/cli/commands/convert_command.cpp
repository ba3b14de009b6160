#include "cli/commands/all_commands.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/organ_group.h"
#include "cli/patient_info.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/arrays.h"
#include "viscera/core/error.h"
#include "viscera/deformation/organ_solid.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/assess_patient.h"
#include "viscera/medical_io/assess_surface.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/solid_model_file.h"
#include "viscera/medical_io/space.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/medical_io/surface_repairs.h"

namespace viscera::app::cli {
namespace {

constexpr double kSmallestElementMm = 0.01, kLargestElementMm = 1000;
constexpr int kFewestConvertedTriangles = 100, kMostConvertedTriangles = 1'000'000;

double millimetres(const std::string& unit) {
  for (const medical_io::LengthUnit& known : medical_io::lengthUnits())
    if (known.id == unit)
      return known.mm;
  throw UsageError("Unknown unit", unit);
}

medical_io::Space spaceNamed(const std::string& name) {
  return name == "RAS" ? medical_io::Space::ras : medical_io::Space::lps;
}

/// Whether coordinates that were read as `read` have to be rotated because they are in `stated`.
bool turned(medical_io::Space read, const std::string& stated) {
  return !stated.empty() && spaceNamed(stated) != read;
}

bool endsAsScene(const std::string& file) {
  const std::filesystem::path ending = std::filesystem::path(file).extension();
  return ending == ".3mf" || ending == ".glb";
}

/// `viscera convert`: surfaces and handle files into other formats, axes and units, several organs into one
/// file, an organ into tetrahedra. Repairs only what it is asked to.
class ConvertCommand final : public Command {
public:
  std::string name() const override { return "convert"; }
  std::string summary() const override {
    return "Convert organs or a handle file, for printing and finite elements, too";
  }
  std::vector<OutputOption> outputs() const override { return {{"--output"}, {.name = "IN", .last = true}}; }

  void addOptions(CLI::App& options) override {
    // One list: the library gives a list of names all that follow, and leaves none for a name behind it.
    options
        .add_option(
            "IN", inputs_,
            "IN... OUT: a surface, one organ of a file of several (FILE/NAME), or a handle file "
            "(.mrk.json, .fcsv), and the file to write, whose ending says the format. For .3mf, .glb, .inp "
            "and .vtu also several organs, a session, a label map or sample:heart")
        ->required();
    options.add_option("-o,--output", output_, "The file to write; all arguments are then inputs")
        ->type_name("FILE");
    options.add_option("--space", space_, "Axes to write in: LPS or RAS")
        ->check(CLI::IsMember({"LPS", "RAS"}))
        ->capture_default_str();
    options.add_option("--from-space", fromSpace_, "Axes of IN; overrides what the file states")
        ->check(CLI::IsMember({"LPS", "RAS"}));
    options.add_option("--unit", unit_, "Unit of IN's coordinates; OUT is in mm")
        ->check(CLI::IsMember({"mm", "cm", "m", "in"}))
        ->capture_default_str();
    options
        .add_option("--remove-fragments", fragments_,
                    "Drop pieces of the surface that are smaller than this: 2%, 5mm or 0.3ml")
        ->type_name("SIZE");
    options.add_flag("--keep-largest", keepLargest_, "Keep the largest piece of the surface only");
    options.add_flag("--fill-holes", fillHoles_, "Close holes with caps");
    options.add_flag("--orient", orient_, "Turn triangles so that all of them face outward");
    options
        .add_option("--remesh", remesh_,
                    "Make the surface anew with about N triangles: closed, without intersections")
        ->type_name("N")
        ->check(wholeBetween(kFewestConvertedTriangles, kMostConvertedTriangles));
    options
        .add_option(
            "--resolution", resolutionMm_,
            "Make the surface anew with details of MM, with as many triangles as --remesh says, or as "
            "that takes")
        ->type_name("MM")
        ->check(CLI::PositiveNumber);
    options
        .add_option("--scale", scale_,
                    "Multiply all coordinates, or life-size: to the usual volume of the organ that the "
                    "file's name says")
        ->type_name("FACTOR");
    options.add_flag("--mirror", mirror_, "Exchange left and right");
    options
        .add_option("--element-size", elementMm_,
                    "For .inp and .vtu: largest edge of tetrahedra inside, in mm")
        ->type_name("MM")
        ->check(CLI::Range(kSmallestElementMm, kLargestElementMm));
    options
        .add_option("--cavity", cavities_,
                    "For .inp and .vtu: a closed surface inside the organ that stays empty; may be repeated")
        ->type_name("ORGAN")
        ->expected(1)
        ->take_all();
  }

  Outcome run(CommandContext& context) override {
    takeOutput();
    if (medical_io::isSolidModelFile(out_))
      return convertToTetrahedra(context);
    if (elementMm_ || !cavities_.empty())
      throw UsageError("tetrahedra are written as .inp or .vtu only", out_,
                       "leave out --element-size and --cavity");
    if (endsAsScene(out_) && (inputs_.size() > 1 || holdsOrgans(in_)))
      return convertOrgans(context);
    if (inputs_.size() > 1)
      throw UsageError("several organs are written as .3mf or .glb only", out_, "convert them one by one");
    return document::isHandleFile(in_) ? convertHandles() : convertSurface(context);
  }

private:
  /// What -o names, else the last argument.
  void takeOutput() {
    in_ = inputs_.front();
    out_ = output_;
    if (!out_.empty())
      return;
    if (inputs_.size() < 2)
      throw UsageError("There is no file to write", inputs_.front(),
                       "name it last, viscera convert IN OUT, or with -o");
    out_ = inputs_.back();
    inputs_.pop_back();
  }

  /// Whether it is more than a surface file: a sample organ, a session, a label map, or one organ of these.
  static bool holdsOrgans(const std::string& input) {
    if (isSample(input) || sessionReference(input) || namesLabel(input))
      return true;
    std::error_code unreachable;
    if (std::filesystem::is_directory(input, unreachable) || document::isSessionFile(input))
      return true;
    return std::filesystem::is_regular_file(input, unreachable) &&
           medical_io::fileKind(input) == medical_io::FileKind::labelMap;
  }

  /// All organs of all inputs into one file.
  Outcome convertOrgans(CommandContext& context) const {
    if (!repairs().empty() || remakes() || !scale_.empty() || !fromSpace_.empty() || unit_ != "mm")
      throw UsageError("several organs are written as they are", out_,
                       "leave out the options, or convert the organs one by one");
    const OrganGroup group = organGroup(inputs_, context.samples, context.progress);
    std::vector<medical_io::NamedSurface> surfaces;
    std::vector<medical_io::PlacedOrgan> placed;
    Outcome outcome;
    outcome.json = {{"in", in_}, {"out", out_}, {"organs", nlohmann::ordered_json::array()}};
    Listing listing;
    listing.add("file", out_);
    Eigen::Index vertices = 0, triangles = 0;
    for (std::size_t i = 0; i < group.organs.size(); ++i) {
      const document::Organ& organ = group.organs[i];
      auto mesh = organ.mesh;
      if (mesh->colors.rows() > 0 && !organ.look.vertexColors) {
        auto plainMesh = std::make_shared<geometry::TriangleMesh>(*mesh);
        plainMesh->colors.resize(0, 3);
        mesh = std::move(plainMesh);
      }
      surfaces.push_back({mesh, organ.name, organ.look.color, organ.look.opacity, group.cavityOf[i]});
      vertices += mesh->points.rows();
      triangles += mesh->triangles.rows();
      if (organ.origin.sample.empty()) // Those are made in LPS, each about an origin of its own.
        placed.push_back({organ.name, boundsOf(mesh->points), std::abs(organ.restVolumeMm3) / kMm3PerMl});
      const bool cavity = group.cavityOf[i] >= 0;
      outcome.json["organs"].push_back({{"name", organ.name},
                                        {"triangles", mesh->triangles.rows()},
                                        {"closed", organ.closed()},
                                        {"cavityOf", cavity ? nlohmann::ordered_json(group.cavityOf[i])
                                                            : nlohmann::ordered_json(nullptr)}});
      listing.add(organ.name,
                  std::to_string(mesh->triangles.rows()) + " triangles" + (cavity ? ", a cavity" : ""));
    }
    context.progress.throwIfCancelled();
    medical_io::writeSurfaces(out_, surfaces, written());
    outcome.json["vertices"] = vertices;
    outcome.json["triangles"] = triangles;
    outcome.json["space"] = space_;
    outcome.warnings = group.warnings;
    outcome.json["warnings"] = outcome.warnings;
    appendPatient(outcome, placed);
    outcome.text = listing.text();
    return outcome;
  }

  /// One organ, filled up to its cavities.
  Outcome convertToTetrahedra(CommandContext& context) const {
    if (!repairs().empty() || remakes() || !scale_.empty() || !fromSpace_.empty() || space_ != "LPS" ||
        unit_ != "mm")
      throw UsageError("tetrahedra are written in LPS mm of a surface as it is", out_,
                       "convert the surface first, and then the result");
    OrganGroup group = organGroup(inputs_, context.samples, context.progress);
    const OrganGroup hollow = organGroup(cavities_, context.samples, context.progress);
    if (group.organs.empty())
      throw UsageError("there is no organ in it", in_);
    const document::Organ& organ = group.organs.front();
    std::vector<deformation::NamedWall> cavities;
    for (std::size_t i = 1; i < group.organs.size(); ++i) {
      if (group.cavityOf[i] != 0)
        throw UsageError("tetrahedra are made of one organ with its cavities", group.organs[i].name,
                         "name the organ behind a slash, and its cavities by --cavity");
      cavities.push_back({group.organs[i].name, group.organs[i].mesh});
    }
    for (const document::Organ& cavity : hollow.organs)
      cavities.push_back({cavity.name, cavity.mesh});
    deformation::TetrahedraOptions options;
    if (elementMm_) // The volume of a regular tetrahedron.
      options.maxVolumeMm3 = std::pow(*elementMm_, 3) / (6 * std::numbers::sqrt2);
    const deformation::OrganSolid solid = filled(organ, cavities, options, context.progress);
    context.progress.throwIfCancelled();
    medical_io::writeSolidModel(out_, solid, organ.name);
    Outcome outcome = outcomeOf(solid);
    outcome.warnings = std::move(group.warnings);
    outcome.warnings.insert(outcome.warnings.end(), hollow.warnings.begin(), hollow.warnings.end());
    assessFiles(inputs_, outcome.warnings, context);
    assessFiles(cavities_, outcome.warnings, context);
    outcome.json["warnings"] = outcome.warnings;
    appendPatient(outcome, placedOf(group, hollow));
    return outcome;
  }

  /// All organs that were named, where they lie.
  static std::vector<medical_io::PlacedOrgan> placedOf(const OrganGroup& group, const OrganGroup& hollow) {
    std::vector<medical_io::PlacedOrgan> placed;
    for (const OrganGroup* each : {&group, &hollow})
      for (const document::Organ& organ : each->organs)
        if (organ.origin.sample.empty()) // Those are made in LPS, each about an origin of its own.
          placed.push_back(
              {organ.name, boundsOf(organ.mesh->points), std::abs(organ.restVolumeMm3) / kMm3PerMl});
    return placed;
  }

  deformation::OrganSolid filled(const document::Organ& organ,
                                 const std::vector<deformation::NamedWall>& cavities,
                                 const deformation::TetrahedraOptions& options, Progress& progress) const {
    try {
      return deformation::fillOrgan({"OUTER", organ.mesh}, cavities, options, progress);
    } catch (const deformation::TetrahedraError& error) {
      using Reason = deformation::TetrahedraError::Reason;
      const bool tooMany = error.reason() == Reason::timeLimit || error.reason() == Reason::memoryLimit;
      throw DataError(error.problem(), in_,
                      tooMany ? Text("choose a larger --element-size, or fewer triangles by --remesh first")
                              : error.tryThis());
    }
  }

  Outcome outcomeOf(const deformation::OrganSolid& solid) const {
    Outcome outcome;
    const double volumeMl = deformation::tetrahedronVolumes(solid.points, solid.tetrahedra).sum() / kMm3PerMl;
    outcome.json = {{"in", in_},
                    {"out", out_},
                    {"vertices", solid.points.rows()},
                    {"triangles", 0},
                    {"tetrahedra", solid.tetrahedra.rows()},
                    {"volumeMl", volumeMl},
                    {"space", space_},
                    {"walls", nlohmann::ordered_json::array()}};
    Listing listing;
    listing.add("file", out_)
        .add("tetrahedra", std::to_string(solid.tetrahedra.rows()) + ", " + fixed(volumeMl, 1) + " ml")
        .add("nodes", std::to_string(solid.points.rows()));
    for (const deformation::OrganSolid::Wall& wall : solid.walls) {
      outcome.json["triangles"] = outcome.json["triangles"].get<std::size_t>() + wall.faces.size();
      outcome.json["walls"].push_back(
          {{"name", wall.name}, {"nodes", wall.nodes.size()}, {"faces", wall.faces.size()}});
      listing.add(wall.name, std::to_string(wall.nodes.size()) + " nodes");
    }
    outcome.text = listing.text();
    return outcome;
  }

  Outcome convertSurface(CommandContext& context) const {
    if (document::isHandleFile(out_))
      throw UsageError("a surface cannot be written as a handle file", out_,
                       "viscera handles places handles");
    std::vector<medical_io::SurfacePart> parts;
    if (auto named = surfacePartInput(in_)) {
      named->cavityOf = -1;
      parts.push_back(std::move(*named));
    } else {
      parts = medical_io::readSurfaces(in_);
    }
    if (parts.size() > 1 && !endsAsScene(out_))
      medical_io::readSurface(in_); // Throws, and lists the organs.
    Outcome outcome;
    std::vector<Converted> converted;
    for (const medical_io::SurfacePart& part : parts)
      converted.push_back(convertOne(part.surface, parts.size() > 1, outcome, context));
    context.progress.throwIfCancelled();
    write(parts, converted);
    describe(converted, outcome);
    return outcome;
  }

  struct Converted {
    std::string name;
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    geometry::SurfaceReport report;
    std::optional<medical_io::SurfaceChange> change;
  };

  /// What is doubtful about a surface of that file.
  static std::vector<medical_io::Finding> findingsOf(const medical_io::SurfaceFile& surface,
                                                     const geometry::TriangleMesh& mesh,
                                                     const geometry::SurfaceReport& report,
                                                     CommandContext& context) {
    return medical_io::assessSurface(
               mesh, report,
               {surface.name, surface.spaceStated ? std::optional(surface.space) : std::nullopt},
               context.progress, context.threads)
        .findings;
  }

  /// Adds what is doubtful about the surfaces in these files, once.
  static void assessFiles(const std::vector<std::string>& files, std::vector<Text>& warnings,
                          CommandContext& context) {
    for (const std::string& file : files) {
      std::error_code unreachable;
      if (isSample(file) || !std::filesystem::is_regular_file(file, unreachable) ||
          medical_io::fileKind(file) != medical_io::FileKind::surface)
        continue;
      for (const medical_io::SurfacePart& part : medical_io::readSurfaces(file)) {
        const auto findings = findingsOf(part.surface, part.surface.mesh, part.surface.report, context);
        removeFindings(warnings, findings);
        appendFindings(warnings, findings);
      }
    }
  }

  Converted convertOne(const medical_io::SurfaceFile& surface, bool amongOthers, Outcome& outcome,
                       CommandContext& context) const {
    const auto assess = [&](const geometry::TriangleMesh& mesh, const geometry::SurfaceReport& report) {
      return findingsOf(surface, mesh, report, context);
    };
    std::vector<Text> warnings = surface.warnings;
    removeFindings(warnings, assess(surface.mesh, surface.report));
    geometry::TriangleMesh mesh = surface.mesh;
    if (turned(surface.space, fromSpace_))
      mesh = geometry::turnedHalf(std::move(mesh));
    if (millimetres(unit_) != 1)
      mesh = geometry::scaled(std::move(mesh), millimetres(unit_));
    for (const std::string& repair : repairs())
      mesh = medical_io::surfaceRepair(repair).apply(mesh, context.progress, context.threads);
    mesh = scaled(std::move(mesh), surface.name);
    Converted result;
    if (remakes()) {
      geometry::TriangleMesh before = std::move(mesh);
      mesh = resolutionMm_ ? medical_io::remeshedAt(before, *resolutionMm_, remesh_.value_or(0),
                                                    context.progress, context.threads)
                           : medical_io::remeshed(before, *remesh_, context.progress, context.threads);
      result.change = medical_io::surfaceChange(before, mesh, context.threads);
      if (auto lost = medical_io::doubtAbout(*result.change))
        warnings.push_back(std::move(*lost));
    }
    result.name = surface.name;
    result.report = geometry::checkSurface(mesh);
    appendFindings(warnings, assess(mesh, result.report));
    for (Text& warning : warnings)
      outcome.warnings.push_back(amongOthers ? phrase("%1: %2", surface.name, warning) : std::move(warning));
    result.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
    return result;
  }

  bool remakes() const { return remesh_ || resolutionMm_; }

  geometry::TriangleMesh scaled(geometry::TriangleMesh mesh, const std::string& name) const {
    if (scale_.empty())
      return mesh;
    Progress quiet;
    if (scale_ != "life-size")
      return medical_io::surfaceRepair("scale=" + scale_).apply(mesh, quiet, {});
    const geometry::SurfaceReport report = geometry::checkSurface(mesh);
    const auto factor = report.closed()
                            ? medical_io::lifeSizeFactor(name, std::abs(report.volumeMm3) / kMm3PerMl)
                            : std::nullopt;
    if (!factor)
      throw DataError("its life size is not known", name,
                      "close the surface by --fill-holes and name the file by its organ, or give a factor");
    return geometry::scaled(std::move(mesh), *factor);
  }

  void write(const std::vector<medical_io::SurfacePart>& parts,
             const std::vector<Converted>& converted) const {
    // A print has the organ's colour, also of one alone.
    if (parts.size() == 1 && std::filesystem::path(out_).extension() != ".3mf") {
      medical_io::writeSurface(out_, *converted.front().mesh,
                               {.space = written(), .name = converted.front().name});
      return;
    }
    std::vector<medical_io::NamedSurface> surfaces;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      medical_io::NamedSurface surface{converted[i].mesh, converted[i].name};
      surface.color = parts[i].color.value_or(anatomy::colorNamed(surface.name).value_or(surface.color));
      surface.opacity = parts[i].opacity;
      surface.cavityOf = parts[i].cavityOf;
      surfaces.push_back(std::move(surface));
    }
    medical_io::writeSurfaces(out_, surfaces, written());
  }

  void describe(const std::vector<Converted>& converted, Outcome& outcome) const {
    std::vector<std::string> done = repairs();
    if (!scale_.empty())
      done.push_back("scale=" + scale_);
    if (remakes())
      done.emplace_back("remesh");
    Eigen::Index vertices = 0, triangles = 0;
    bool closed = true;
    nlohmann::ordered_json organs = nlohmann::ordered_json::array();
    for (const Converted& one : converted) {
      vertices += one.mesh->points.rows();
      triangles += one.mesh->triangles.rows();
      closed = closed && one.report.closed();
      organs.push_back({{"name", one.name},
                        {"vertices", one.mesh->points.rows()},
                        {"triangles", one.mesh->triangles.rows()},
                        {"closed", one.report.closed()}});
    }
    outcome.json = {{"in", in_},       {"out", out_},     {"vertices", vertices}, {"triangles", triangles},
                    {"space", space_}, {"repairs", done}, {"closed", closed}};
    Listing listing;
    listing.add("file", out_);
    if (converted.size() > 1) {
      outcome.json["organs"] = organs;
      listing.add("organs", std::to_string(converted.size()));
    }
    outcome.text =
        listing.add("vertices", std::to_string(vertices)).add("triangles", std::to_string(triangles)).text();
    for (const Converted& one : converted) {
      if (!one.change)
        continue;
      const nlohmann::ordered_json change = {{"trianglesBefore", one.change->trianglesBefore},
                                             {"meanMm", one.change->meanMm},
                                             {"maximumMm", one.change->maximumMm}};
      if (converted.size() == 1)
        outcome.json["remesh"] = change;
      else
        outcome.json["remesh"][one.name] = change;
      outcome.text += "  " + inWords(*one.change).english() + "\n";
    }
    outcome.json["warnings"] = outcome.warnings;
    std::vector<medical_io::PlacedOrgan> placed;
    for (const Converted& one : converted)
      placed.push_back({one.name, boundsOf(one.mesh->points),
                        one.report.closed() ? std::abs(one.report.volumeMm3) / kMm3PerMl : 0});
    appendPatient(outcome, placed);
  }

  Outcome convertHandles() const {
    requireNoSurfaceOptions();
    if (!document::isHandleFile(out_))
      throw UsageError("a handle file cannot be written as a surface", out_, "use .mrk.json or .fcsv");
    medical_io::HandleFile handles = medical_io::readHandles(in_);
    const double mm = millimetres(unit_);
    for (medical_io::HandleGroupRecord& group : handles.groups)
      for (medical_io::HandleRecord& handle : group.handles)
        if (mm != 1)
          handle.position *= mm;
    medical_io::writeHandles(out_, handles, {.space = written()});
    Outcome outcome;
    outcome.warnings = handles.warnings;
    if (out_.ends_with(".fcsv"))
      for (Text& lost : medical_io::fcsvLoses(handles))
        outcome.warnings.push_back(std::move(lost));
    outcome.json = {{"in", in_},
                    {"out", out_},
                    {"vertices", handles.count()},
                    {"triangles", 0},
                    {"handles", handles.count()},
                    {"space", space_},
                    {"warnings", outcome.warnings}};
    outcome.text = Listing().add("file", out_).add("handles", std::to_string(handles.count())).text();
    return outcome;
  }

  /// The repairs asked for, in the order in which they are done.
  std::vector<std::string> repairs() const {
    std::vector<std::string> list;
    if (!fragments_.empty())
      list.push_back("remove-fragments=" + fragments_);
    if (keepLargest_)
      list.emplace_back("keep-largest");
    if (orient_) // Before the holes: caps run as the triangles beside them do.
      list.emplace_back("orient");
    if (fillHoles_)
      list.emplace_back("fill-holes");
    if (mirror_)
      list.emplace_back("mirror");
    return list;
  }

  void requireNoSurfaceOptions() const {
    if (!fromSpace_.empty())
      throw UsageError("handle files state their axes themselves", "--from-space");
    if (!repairs().empty() || remakes() || !scale_.empty())
      throw UsageError("handles cannot be repaired as surfaces are", in_,
                       "leave out the options that repair a surface");
  }

  medical_io::Space written() const { return spaceNamed(space_); }

  std::vector<std::string> inputs_; ///< Of the arguments all but the last.
  std::string in_;                  ///< The first of them.
  std::string out_;
  std::string output_; ///< By -o; empty: the last argument.
  std::vector<std::string> cavities_;
  std::optional<double> elementMm_;
  std::string space_ = "LPS";
  std::string fromSpace_;
  std::string unit_ = "mm";
  bool fillHoles_ = false;
  bool keepLargest_ = false;
  bool orient_ = false;
  bool mirror_ = false;
  std::optional<int> remesh_;
  std::optional<double> resolutionMm_;
  std::string fragments_, scale_;
};

} // namespace

std::unique_ptr<Command> convertCommand() {
  return std::make_unique<ConvertCommand>();
}

} // namespace viscera::app::cli
