#include "window/slices/patient_offer.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "viscera/medical_io/image_beside.h"
#include "window/import/file_actions.h"
#include "window/slices/scan_actions.h"

namespace viscera::app {
namespace {

using medical_io::ImageContents;

constexpr int kOfferSeconds = 30;

bool cameFromLabels(const document::Organ& organ) {
  return !organ.file.empty() && medical_io::isLabelMap(organ.file);
}

QString fileNameOf(const std::filesystem::path& file) {
  return text(file.filename().string());
}

} // namespace

PatientOffer::PatientOffer(Workspace& workspace, FileActions& files, ScanActions& scans,
                           std::function<bool()> importing, QObject* parent)
    : QObject(parent), workspace_(workspace), files_(files), scans_(scans), importing_(std::move(importing)),
      subscription_(workspace.onChange([this](const document::Change&) { look(); })) {}

bool PatientOffer::misses(ImageContents wanted) const {
  const document::DocumentState& state = workspace_.state();
  if (wanted == ImageContents::values)
    return !state.scan && !state.study;
  return std::none_of(state.organs->begin(), state.organs->end(),
                      [](const auto& organ) { return cameFromLabels(*organ); });
}

/// Most changes are poses, for which files are not checked again.
void PatientOffer::look() {
  const document::DocumentState& state = workspace_.state();
  if (state.organs == seenOrgans_ && state.scan == seenScan_)
    return;
  seenOrgans_ = state.organs;
  seenScan_ = state.scan;
  if (state.scan && !state.scan->file.empty() && misses(ImageContents::labels))
    return searchFolder(state.scan->file, ImageContents::labels);
  const auto organ = std::find_if(state.organs->begin(), state.organs->end(),
                                  [](const auto& one) { return cameFromLabels(*one); });
  if (organ != state.organs->end() && misses(ImageContents::values))
    searchFolder((*organ)->file, ImageContents::values);
}

void PatientOffer::searchFolder(const std::filesystem::path& image, ImageContents wanted) {
  if (!asked_.insert(image).second)
    return;
  // Errors are not shown: nothing is offered then.
  workspace_.jobs().submit<std::optional<std::filesystem::path>>(
      tr("Searching beside %1").arg(fileNameOf(image)).toStdString(), "beside",
      [image, wanted](Progress& progress) { return medical_io::imageBeside(image, wanted, progress); },
      [this, image, wanted](const JobResult<std::optional<std::filesystem::path>>& result) {
        if (result.value && *result.value && misses(wanted) && !importing_())
          offer(image, **result.value, wanted);
      });
}

void PatientOffer::offer(const std::filesystem::path& image, const std::filesystem::path& found,
                         ImageContents contents) {
  const bool scan = contents == ImageContents::values;
  const QString place = text(found.string());
  const QString said =
      scan ? tr("The scan %2 has the same voxels as %1.").arg(fileNameOf(image), fileNameOf(found))
           : tr("The label map %2 has the same voxels as %1.").arg(fileNameOf(image), fileNameOf(found));
  // The offer takes the place of a message that names the files that did not open.
  const QString unopened = files_.unopenedBeside(image);
  workspace_.say({unopened.isEmpty() ? Message::Severity::info : Message::Severity::error,
                  unopened.isEmpty() ? said : unopened + QLatin1Char('\n') + said,
                  {{scan ? tr("Open the scan") : tr("Open its organs"),
                    [this, scan, place] {
                      if (scan)
                        scans_.open(place);
                      else
                        files_.open({place});
                    }}},
                  unopened.isEmpty() ? kOfferSeconds : 0});
}

} // namespace viscera::app
