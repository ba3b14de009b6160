#pragma once

#include "signs/movie_signs.h"
#include "window/circulation/circulation_model.h"
#include "window/timeline/playback.h"

namespace viscera::app {

/// A copy of what the window shows of the beating heart's physiology, for a movie: the circulation with which
/// it beats, else the textbook's beat at its rate.
MovieSigns::Source shownSigns(const Playback& playback, const CirculationModel& circulation,
                              const presentation::HeartSigns& signs, const scene::Theme& theme);

} // namespace viscera::app
