#include "viscera/phantom/phantom_options.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::phantom {
namespace {

constexpr double kFinestMm = 0.2, kCoarsestMm = 40;
constexpr int kMostSlices = 40, kMostPhases = 200;
constexpr double kMostShiftMm = 30;

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');)
    words.push_back(word);
  if (text.ends_with(','))
    words.emplace_back();
  return words;
}

double numberFrom(const std::string& text, const std::string& whole, const Text& tryThis) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
    throw UsageError(misuse("\"%1\" is no number", text), whole, tryThis);
  return number;
}

void requireWithin(double value, double low, double high, const char* what) {
  if (!(value >= low && value <= high))
    throw UsageError(misuse("%1 has to lie between %2 and %3", what, inDigits(low), inDigits(high)));
}

} // namespace

Vec3 spacingFrom(const std::string& text) {
  const Text tryThis = misuse("three numbers of mm with commas between them: 2,2,8");
  const std::vector<std::string> words = splitAtCommas(text);
  if (words.size() != 3)
    throw UsageError(misuse("this is no spacing"), text, tryThis);
  Vec3 spacing;
  for (int axis = 0; axis < 3; ++axis)
    spacing[axis] = numberFrom(words[static_cast<std::size_t>(axis)], text, tryThis);
  return spacing;
}

SliceLayout slicesFrom(const std::vector<std::string>& words) {
  const Text tryThis = misuse("sax:N,GAP for a stack across the ventricle, lax for planes along it");
  SliceLayout layout{.shortAxis = 0, .gapMm = 0, .longAxis = false};
  for (const std::string& word : words) {
    if (word == "lax") {
      layout.longAxis = true;
      continue;
    }
    const std::vector<std::string> numbers =
        word.starts_with("sax:") ? splitAtCommas(word.substr(4)) : std::vector<std::string>();
    if (numbers.size() != 2)
      throw UsageError(misuse("these are no slices"), word, tryThis);
    const double count = numberFrom(numbers[0], word, tryThis);
    if (count != std::floor(count))
      throw UsageError(misuse("a stack has a whole number of slices"), word, tryThis);
    requireWithin(count, 1, kMostSlices, "the number of slices");
    layout.shortAxis = static_cast<int>(count);
    layout.gapMm = numberFrom(numbers[1], word, tryThis);
  }
  return layout;
}

void setNoise(const std::string& text, PhantomOptions& options) {
  const Text tryThis = misuse("rician:S or gaussian:S, S being the deviation in the image's unit");
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  if (colon == std::string::npos || (kind != "rician" && kind != "gaussian"))
    throw UsageError(misuse("this is no noise"), text, tryThis);
  options.noise = kind == "rician" ? Contrast::Noise::rician : Contrast::Noise::gaussian;
  options.deviation = numberFrom(text.substr(colon + 1), text, tryThis);
}

Modality modalityFrom(const std::string& name) {
  for (const Modality modality : {Modality::ct, Modality::cine, Modality::labels})
    if (nameOf(modality) == name)
      return modality;
  throw UsageError(misuse("there is no modality \"%1\"", name), {}, misuse("use ct, cine or labels"));
}

std::string nameOf(Modality modality) {
  return modality == Modality::ct ? "ct" : modality == Modality::cine ? "cine" : "labels";
}

void requireSound(const PhantomOptions& options) {
  requireWithin(options.spacing.minCoeff(), kFinestMm, kCoarsestMm, "the spacing");
  requireWithin(options.spacing.maxCoeff(), kFinestMm, kCoarsestMm, "the spacing");
  requireWithin(options.phases, 1, kMostPhases, "the number of phases");
  requireWithin(options.deviation, 0, 2000, "the deviation of the noise");
  requireWithin(options.shiftSlicesMm, 0, kMostShiftMm, "the shift of the slices");
  requireWithin(options.slices.gapMm, 0, kCoarsestMm, "the gap between slices");
  if (options.fieldSpacingMm != 0)
    requireWithin(options.fieldSpacingMm, 2, kCoarsestMm, "the spacing of the fields");
  if (options.format != ".nrrd" && options.format != ".nii.gz")
    throw UsageError(misuse("there is no format \"%1\"", options.format), {}, misuse("use nrrd or nifti"));
  if (options.modality == Modality::cine) {
    if (options.motion.breathing)
      throw UsageError(misuse("a cine study is taken while the breath is held, so that nothing breathes"), {},
                       misuse("leave out --breathing; --shift-slices makes breath-holds differ"));
    if (!options.motion.heartbeat)
      throw UsageError(misuse("a cine study shows a heartbeat"), {}, misuse("ask for --heartbeat"));
    if (options.slices.shortAxis == 0 && !options.slices.longAxis)
      throw UsageError(misuse("a cine study needs slices"), {}, misuse("ask for sax:9,2 or lax"));
    if (options.phases < 2)
      throw UsageError(misuse("a cine study has two phases or more"));
  } else if (options.shiftSlicesMm > 0) {
    throw UsageError(misuse("only the slices of a cine study are shifted"), {},
                     misuse("use --modality cine"));
  }
  if (options.noise == Contrast::Noise::rician && options.modality == Modality::ct)
    throw UsageError(misuse("the noise of a CT is not Rician: its values may be negative"), {},
                     misuse("use gaussian:%1", inDigits(options.deviation)));
}

} // namespace viscera::phantom
