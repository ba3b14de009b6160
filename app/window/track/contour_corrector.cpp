#include "window/track/contour_corrector.h"

#include <algorithm>
#include <cmath>

#include "viscera/document/study_item.h"
#include "viscera/live/contour_corrections.h"
#include "viscera/live/sequence_file.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

constexpr const char* kCorrectSlot = "correctContour";
constexpr std::size_t kKnownMotions = 8;

/// Whether two requests follow the same images to the same labels.
bool isSame(const live::CineRequest& a, const live::CineRequest& b) {
  const auto same = [](const auto& x, const auto& y, const auto& equal) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal);
  };
  return a.images == b.images && a.periodSeconds == b.periodSeconds && a.leftOutSeries == b.leftOutSeries &&
         same(a.labels, b.labels,
              [](const live::PhaseLabels& x, const live::PhaseLabels& y) {
                return x.phase == y.phase && x.files == y.files;
              }) &&
         same(a.surfaces, b.surfaces, [](const live::LabelledSurface& x, const live::LabelledSurface& y) {
           return x.name == y.name && x.labels == y.labels;
         });
}

} // namespace

/// What a worker made.
struct ContourCorrector::Fitted {
  std::shared_ptr<const live::CineTracker> tracker;
  std::shared_ptr<const live::CineMotion> before, after;
};

ContourCorrector::ContourCorrector(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace) {
  subscription_ = workspace.onChange([this](const document::Change& change) {
    const auto& now = change.after.keySequence->corrections;
    if (!change.keySequence() || change.before.keySequence->corrections == now)
      return;
    const auto found =
        std::find_if(known_.begin(), known_.end(), [&](const auto& known) { return known.first == now; });
    if (found == known_.end())
      return;
    workspace_.afterChange([this, motion = found->second] { Q_EMIT corrected(motion); });
  });
}

ContourCorrector::~ContourCorrector() {
  workspace_.jobs().cancelSlot(kCorrectSlot);
}

bool ContourCorrector::available() const {
  return source_ && workspace_.state().study && !workspace_.state().keySequence->keys.empty() &&
         source_().has_value();
}

QString ContourCorrector::refusal(std::size_t phase, document::OrganId organ) const {
  const auto origin = source_ ? source_() : std::nullopt;
  if (!origin)
    return tr("Only contours of a motion that was found in images can be corrected.");
  if (working_)
    return tr("The motion is being fitted to the last correction.");
  if (std::binary_search(origin->labelled.begin(), origin->labelled.end(), phase))
    return tr("Phase %1 has labels, which are exact. Correct a phase between them, or change its labels.")
        .arg(phase + 1);
  return surfaceOf(organ).empty() ? tr("This organ is not moved by the motion that was found in images.")
                                  : QString();
}

std::string ContourCorrector::surfaceOf(document::OrganId organ) const {
  if (const auto origin = source_ ? source_() : std::nullopt)
    for (const auto& [id, name] : origin->surfaces)
      if (id == organ)
        return name;
  return {};
}

std::pair<std::size_t, double> ContourCorrector::phaseAt(double fraction) const {
  const document::KeySequence& sequence = *workspace_.state().keySequence;
  std::size_t nearest = 0;
  double least = 2, at = 0;
  for (std::size_t i = 0; i < sequence.keys.size(); ++i) {
    const double part = sequence.keys[i].seconds / sequence.periodSeconds;
    const double apart = std::abs(part - fraction);
    if (const double round = std::min(apart, 1 - apart); round < least) {
      least = round;
      nearest = i;
      at = part;
    }
  }
  return {nearest, at};
}

std::vector<live::ContourCorrection> ContourCorrector::present() const {
  std::vector<live::ContourCorrection> corrections;
  for (const document::CorrectedContour& correction : workspace_.state().keySequence->corrections)
    corrections.push_back(live::restored(correction));
  return corrections;
}

void ContourCorrector::correct(const live::ContourCorrection& correction, const Points& covered) {
  fit(live::withCorrection(present(), correction, covered));
}

void ContourCorrector::remove(std::size_t index) {
  std::vector<live::ContourCorrection> corrections = present();
  if (index >= corrections.size())
    return;
  corrections.erase(corrections.begin() + static_cast<std::ptrdiff_t>(index));
  fit(std::move(corrections));
}

void ContourCorrector::cancel() {
  ++fits_;
  workspace_.jobs().cancelSlot(kCorrectSlot);
  if (std::exchange(working_, false))
    Q_EMIT ended();
}

/// The images are followed once for a motion.
void ContourCorrector::fit(std::vector<live::ContourCorrection> corrections) {
  auto origin = source_ ? source_() : std::nullopt;
  const auto& item = workspace_.state().study;
  if (!origin || !item)
    return Q_EMIT ended();
  origin->request.corrections.clear();
  if (tracked_ != item->study || !isSame(request_, origin->request)) {
    tracker_.reset();
    known_.clear();
  }
  tracked_ = item->study;
  request_ = origin->request;
  working_ = true;
  auto work = [tracker = tracker_, study = tracked_, origin = *origin, before = present(),
               after = std::move(corrections)](Progress& progress) {
    Fitted fitted;
    fitted.tracker = tracker;
    if (!tracker)
      runPart(progress, 0, 0.8, [&](Progress& part) {
        auto joined =
            std::make_shared<const live::LabelledStudy>(live::joinStudy(*study, origin.request, part));
        fitted.tracker = std::make_shared<const live::CineTracker>(std::move(joined), origin.options, part);
      });
    runPart(progress, 0.8, 0.9, [&](Progress& part) {
      fitted.before = std::make_shared<const live::CineMotion>(fitted.tracker->motion(before, part));
    });
    runPart(progress, 0.9, 1, [&](Progress& part) {
      fitted.after = std::make_shared<const live::CineMotion>(fitted.tracker->motion(after, part));
    });
    return fitted;
  };
  auto done = [this, search = ++fits_](JobResult<Fitted> result) {
    if (search != fits_)
      return; // Another one took its place.
    working_ = false;
    if (result.error)
      workspace_.report(*result.error);
    if (result.value)
      take(*result.value);
    Q_EMIT ended();
  };
  workspace_.jobs().submit<Fitted>(tr("Correct contour").toStdString(), kCorrectSlot, std::move(work),
                                   std::move(done));
}

void ContourCorrector::take(const Fitted& fitted) {
  tracker_ = fitted.tracker;
  std::vector<document::CorrectedContour> corrections;
  for (const live::CorrectionOutcome& outcome : fitted.after->corrections)
    corrections.push_back(live::stored(outcome.correction));
  const std::vector<std::size_t> keys = live::phasesThatDiffer(*fitted.before, *fitted.after);
  know(workspace_.state().keySequence->corrections, fitted.before);
  know(corrections, fitted.after);
  if (workspace_.perform(live::correctKeys(fitted.after->motion.sequence, keys, corrections)))
    tell(*fitted.after, keys.size());
}

void ContourCorrector::know(const std::vector<document::CorrectedContour>& corrections,
                            std::shared_ptr<const live::CineMotion> motion) {
  std::erase_if(known_, [&](const auto& known) { return known.first == corrections; });
  if (known_.size() == kKnownMotions)
    known_.erase(known_.begin());
  known_.emplace_back(corrections, std::move(motion));
}

void ContourCorrector::tell(const live::CineMotion& motion, std::size_t changed) {
  const int phases = static_cast<int>(changed);
  if (motion.corrections.empty())
    return workspace_.note(
        tr("The motion is that of the images again. %n phases have changed.", nullptr, phases));
  const live::CorrectionOutcome& worst =
      *std::max_element(motion.corrections.begin(), motion.corrections.end(),
                        [](const auto& a, const auto& b) { return a.met.mostMm < b.met.mostMm; });
  const QString changes = tr("%n phases have changed.", nullptr, phases);
  if (worst.met.met())
    return workspace_.note(
        tr("The motion meets all corrected contours to %1 mm.").arg(formatNumber(worst.met.mostMm, 2)) +
        QLatin1Char(' ') + changes);
  workspace_.say({Message::Severity::warning,
                  tr("The corrected contour of %1 in phase %2 is met to %3 mm only.")
                          .arg(inWords(worst.where))
                          .arg(worst.correction.phase + 1)
                          .arg(formatNumber(worst.met.mostMm, 1)) +
                      QLatin1Char(' ') + changes,
                  {},
                  0});
}

} // namespace viscera::app
