#include "cli/heart_signs.h"

#include <array>
#include <utility>

#include <QFont>
#include <QSize>

#include <CLI/CLI.hpp>
#include <vtkImageData.h>

#include "cli/circulation_findings.h"
#include "signs/movie_signs.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/core/error.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/report/fonts_at_hand.h"

namespace viscera::app::cli {
namespace {

using presentation::HeartSigns;

constexpr auto kAll = "all";
constexpr double kTypePoints = 10;
/// Pixels above the signs below which no organ can be seen.
constexpr int kLeastAbove = 64;

/// A sign by its word, and whether the textbook's beat has it.
struct Sign {
  const char* name;
  bool HeartSigns::*member;
  bool ofTextbook;
};
constexpr std::array<Sign, 5> kSigns = {{{"pressures", &HeartSigns::pressures, false},
                                         {"loops", &HeartSigns::loops, false},
                                         {"ecg", &HeartSigns::ecg, true},
                                         {"valves", &HeartSigns::valves, true},
                                         {"sounds", &HeartSigns::sounds, true}}};

std::vector<std::string> words() {
  std::vector<std::string> all = {kAll};
  for (const Sign& sign : kSigns)
    all.emplace_back(sign.name);
  return all;
}

} // namespace

ToldBeat toldBeat(const sequences::Sequence& sequence, const std::optional<live::DrivingCirculation>& driving,
                  double ratePerMinute) {
  ToldBeat beat;
  if (driving) {
    Progress quiet;
    beat.circulation = shownOf(driving->name, driving->parameters,
                               circulation::findPeriodicState(driving->parameters, quiet));
  } else if (const heart::BeatingHeart* heart = sequence.heart()) {
    beat.textbook = heart->textbookBeat(ratePerMinute);
  }
  return beat;
}

void SignsOption::addTo(CLI::App& options) {
  options
      .add_option("--signs", names_,
                  "Below each picture what the beating heart tells at that instant: all, or some of "
                  "pressures,loops,ecg,valves,sounds; the first two need a circulation")
      ->type_name("NAMES")
      ->delimiter(',')
      ->check(CLI::IsMember(words()));
}

std::string SignsOption::text() const {
  std::string text;
  for (const std::string& name : names_)
    text += (text.empty() ? "--signs " : ",") + name;
  return text;
}

HeartSigns SignsOption::chosen() const {
  HeartSigns signs{false, false, false, false, false};
  for (const std::string& name : names_)
    for (const Sign& sign : kSigns)
      signs.*sign.member = signs.*sign.member || name == kAll || name == sign.name;
  return signs;
}

struct SignsBelow::Parts {
  report::FontsAtHand fonts; ///< Before all of Qt's things, and longer.
  std::unique_ptr<MovieSigns> signs;
};

SignsBelow::SignsBelow(const SignsOption& option, ToldBeat beat, const StageOptions& options)
    : above_(options), parts_(std::make_unique<Parts>()) {
  MovieSigns::Source source{
      std::nullopt, std::move(beat.textbook), option.chosen(), themeOf(options), {}, {}};
  if (beat.circulation)
    source.curves = MovieSigns::Curves{*std::move(beat.circulation), std::nullopt, true};
  for (const Sign& sign : kSigns)
    if (source.signs.*sign.member && (source.curves || sign.ofTextbook))
      drawn_.emplace_back(sign.name);
  source.type.setPointSizeF(kTypePoints);
  parts_->signs = MovieSigns::of(std::move(source), {options.size.width, options.size.height});
  if (!parts_->signs)
    throw UsageError("This motion tells none of them", option.text(),
                     "play heartbeat; pressures and loops need a circulation (--scenario)");
  above_.size.height -= parts_->signs->height();
  if (above_.size.height < kLeastAbove)
    throw UsageError("No room is left above the signs", "--size",
                     std::to_string(parts_->signs->height() + kLeastAbove) + " pixels high at least");
}

SignsBelow::~SignsBelow() = default;

vtkSmartPointer<vtkImageData> SignsBelow::below(vtkImageData* picture, double fraction) {
  return aboveEachOther(picture, parts_->signs->picture(fraction));
}

} // namespace viscera::app::cli
