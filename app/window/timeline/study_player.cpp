#include "window/timeline/study_player.h"

#include <algorithm>

#include "viscera/document/scan_item.h"
#include "viscera/document/study_item.h"
#include "viscera/presentation/cine_view.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {
constexpr int kStudyFrameMs = 40; ///< 25 frames a second.
/// A cycle whose duration no file states plays in this time, as `presentation::cineSeconds` has it.
constexpr double kUnknownPeriodSeconds = 1;
} // namespace

StudyPlayer::StudyPlayer(Workspace& workspace, ViewModel& view, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), view_(view), playback_(playback) {
  frames_.setInterval(kStudyFrameMs);
  connect(&frames_, &QTimer::timeout, this, &StudyPlayer::advance);
  connect(&playback, &Playback::advanced, this, &StudyPlayer::followMotion);
  connect(&playback, &Playback::stateChanged, this, [this] {
    if (!leads())
      pause();
    followMotion();
  });
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (!change.study() && !change.scan())
      return;
    pause();
    Q_EMIT stateChanged();
  });
}

bool StudyPlayer::hasImages() const {
  return document::hasImagesOverTime(workspace_.state());
}

bool StudyPlayer::leads() const {
  return hasImages() && !playback_.sequence();
}

double StudyPlayer::periodSeconds() const {
  const document::DocumentState& state = workspace_.state();
  if (state.study)
    return presentation::cineSeconds(*state.study->study);
  if (!hasImages())
    return 0;
  const double period = state.scan->time->periodSeconds;
  return period > 0 ? period : kUnknownPeriodSeconds;
}

void StudyPlayer::followMotion() {
  if (hasImages() && playback_.showing())
    seek(playback_.player().fraction());
}

void StudyPlayer::toggle() {
  if (playing())
    return pause();
  if (!leads())
    return;
  if (!loop_ && fraction() >= 1)
    seek(0);
  clock_.start();
  frames_.start();
  Q_EMIT stateChanged();
}

void StudyPlayer::pause() {
  if (!playing())
    return;
  frames_.stop();
  Q_EMIT stateChanged();
}

void StudyPlayer::setLooping(bool looping) {
  loop_ = looping;
  Q_EMIT stateChanged();
}

void StudyPlayer::seek(double fraction) {
  view_.change(
      [&](presentation::ViewState& state) { state.scan.cine.fraction = std::clamp(fraction, 0.0, 1.0); });
}

void StudyPlayer::step(int pictures) {
  pause();
  const document::DocumentState& state = workspace_.state();
  if (!hasImages())
    return;
  if (state.study) {
    const medical_io::CineStudy& study = *state.study->study;
    const std::size_t slice = presentation::cineSlices(study, view_.state().scan.cine)[0];
    return seek(presentation::cineStep(study.slices[slice], fraction(), pictures));
  }
  medical_io::CineSlice phases;
  phases.fractions = state.scan->time->fractions;
  phases.missing = state.scan->time->missing;
  seek(presentation::cineStep(phases, fraction(), pictures));
}

void StudyPlayer::advance() {
  const double seconds = playback_.player().speed() * static_cast<double>(clock_.restart()) / kMsPerSecond;
  seek(presentation::cineAdvanced(fraction(), seconds, periodSeconds(), loop_));
  if (!loop_ && fraction() >= 1)
    pause();
}

} // namespace viscera::app
