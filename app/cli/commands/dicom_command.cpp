#include "cli/commands/all_commands.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/session_input.h"
#include "viscera/core/error.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/session_file.h"
#include "viscera/workbench/dicom_export.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

constexpr double kFinestVoxelMm = 0.1, kCoarsestVoxelMm = 20;
constexpr int kMostExportedPhases = 200;

/// `viscera dicom SESSION|ORGAN... -o FOLDER`: organs as DICOM objects for an archive.
class DicomCommand final : public Command {
public:
  std::string name() const override { return "dicom"; }
  std::string summary() const override {
    return "Write organs as DICOM: segmentation, measurements, surfaces, contours, report";
  }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }

  void addOptions(CLI::App& options) override {
    options
        .add_option("WHAT", files_,
                    "One session (.viscera), or organs (surface files, label maps, sample:NAME)")
        ->required();
    options.add_option("-o,--output", folder_, "Folder to write into; made when it is not there")
        ->type_name("FOLDER")
        ->required();
    options.add_flag("--seg", kinds_.segmentation, "Segmentation, one for each phase");
    options.add_flag("--sr", kinds_.measurements, "Structured report of volumes and measurements");
    options.add_flag("--stl", kinds_.surfaces, "Each surface as Encapsulated STL");
    options.add_flag("--rtstruct", kinds_.contours, "Contours on the scan's slices");
    options.add_option("--pdf", pdf_, "This report (.pdf) as Encapsulated PDF")->type_name("FILE");
    options
        .add_option("--scan", scan_,
                    "Folder of the DICOM images whose patient, study and slices the objects refer to")
        ->type_name("FOLDER");
    options.add_option("--series", series_, "Which series of the folder")->type_name("ID");
    options.add_option("--organ", organs_, "Only the organ of that name; may be given again")
        ->type_name("NAME")
        ->allow_extra_args(false);
    options
        .add_option("--phases", phases_,
                    "So many instants of the motion that the session plays; 0: its present pose")
        ->type_name("N")
        ->check(wholeBetween(0, kMostExportedPhases))
        ->capture_default_str();
    options.add_option("--spacing", spacingMm_, "Voxels of the segmentation without images, mm")
        ->type_name("MM")
        ->check(between(kFinestVoxelMm, kCoarsestVoxelMm))
        ->capture_default_str();
    options.add_flag("--without-identity", withoutIdentity_,
                     "Without whose it is: no name, number or date, and new UIDs");
    options
        .add_option("--secret", secret_,
                    "Text from which the new UIDs follow, so that a later export belongs to this one")
        ->type_name("TEXT");
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    kinds_.document = !pdf_.empty();
    Outcome outcome;
    const std::unique_ptr<workbench::Workbench> bench = this->bench(context, outcome.warnings);
    workbench::DicomExport what =
        workbench::dicomExportOf(*bench, organs_, phases_, outcome.warnings, context.progress);
    if (!scan_.empty())
      what.identity = workbench::studyIdentityOf(scan_, series_, context.progress);
    what.kinds = kinds_;
    what.spacingMm = spacingMm_;
    what.withoutIdentity = withoutIdentity_;
    what.secret = secret_;
    if (kinds_.document)
      what.pdf = bytesOfReport();
    const std::vector<workbench::DicomFile> written =
        workbench::writeDicomExport(folder_, what, context.progress);
    describe(written, what, outcome);
    outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    outcome.json["warnings"] = outcome.warnings;
    return outcome;
  }

private:
  std::unique_ptr<workbench::Workbench> bench(CommandContext& context, std::vector<Text>& warnings) const {
    if (document::isSessionFile(files_.front())) {
      if (files_.size() > 1)
        throw UsageError("A session is written alone", files_[1], "name one session, or organs only");
      const document::OpenedSession opened =
          document::readSession(files_.front(), context.samples, context.progress);
      warnings = opened.warnings;
      return posedSession(
          opened.contents.state,
          presentation::viewFromJson(opened.contents.view, *opened.contents.state.circulation), context);
    }
    std::vector<document::NewOrgan> organs;
    for (const std::string& file : files_)
      for (document::Organ& organ : organInputs(file, context.samples, context.progress)) {
        warnings.insert(warnings.end(), organ.warnings.begin(), organ.warnings.end());
        organs.push_back({std::move(organ), -1});
      }
    auto made = benchFor(context);
    made->perform(document::addOrgans(std::move(organs)));
    return made;
  }

  std::string bytesOfReport() const {
    std::ifstream in(pdf_, std::ios::binary);
    if (!in)
      throw NoInputError("the report cannot be read", pdf_);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  void describe(const std::vector<workbench::DicomFile>& written, const workbench::DicomExport& what,
                Outcome& outcome) const {
    Listing listing;
    ordered_json files = ordered_json::array();
    for (const workbench::DicomFile& one : written) {
      files.push_back({{"file", one.file.string()},
                       {"kind", one.kind},
                       {"organ", one.organ.empty() ? ordered_json() : ordered_json(one.organ)},
                       {"phase", one.phase},
                       {"segments", one.object.segments},
                       {"classUid", one.object.classUid},
                       {"instanceUid", one.object.instanceUid},
                       {"seriesUid", one.object.seriesUid}});
      listing.add(one.kind, one.file.string());
    }
    ordered_json identity = ordered_json::object();
    if (!withoutIdentity_)
      for (const clinic::IdentifyingElement& element : clinic::identifyingElements(what.identity)) {
        identity[element.keyword] = element.value;
        listing.add(element.keyword, element.value);
      }
    listing.add("identity", withoutIdentity_ ? "removed" : "kept");
    outcome.json = {{"folder", folder_},
                    {"files", files},
                    {"phases", what.phases.size()},
                    {"images", what.identity.images.size()},
                    {"identityRemoved", withoutIdentity_},
                    {"identity", identity}};
    outcome.text = listing.text();
  }

  std::vector<std::string> files_, organs_;
  std::string folder_, pdf_, scan_, series_, secret_;
  workbench::DicomKinds kinds_;
  int phases_ = 0;
  double spacingMm_ = 1;
  bool withoutIdentity_ = false;
};

} // namespace

std::unique_ptr<Command> dicomCommand() {
  return std::make_unique<DicomCommand>();
}

} // namespace viscera::app::cli
