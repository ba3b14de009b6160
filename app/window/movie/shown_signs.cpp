#include "window/movie/shown_signs.h"

#include <QApplication>

#include "viscera/heart/beating_heart.h"
#include "window/style/language.h"

namespace viscera::app {

MovieSigns::Source shownSigns(const Playback& playback, const CirculationModel& circulation,
                              const presentation::HeartSigns& signs, const scene::Theme& theme) {
  MovieSigns::Source source{std::nullopt, std::nullopt, signs, theme, QApplication::font(), wording()};
  if (const CirculationModel::Shown* shown = circulation.present()) {
    source.curves = MovieSigns::Curves{*shown, std::nullopt, circulation.isPlayed()};
    if (const CirculationModel::Shown* kept = circulation.kept())
      source.curves->before = *kept;
    return source;
  }
  const sequences::Sequence* sequence = playback.sequence();
  if (const heart::BeatingHeart* heart = sequence ? sequence->heart() : nullptr)
    source.beat = heart->textbookBeat(playback.player().ratePerMinute());
  return source;
}

} // namespace viscera::app
