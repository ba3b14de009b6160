#include "window/timeline/study_player.h"

#include <algorithm>

#include "viscera/document/study_item.h"
#include "viscera/presentation/cine_view.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {
constexpr int kStudyFrameMs = 40; ///< 25 frames a second.
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
    if (!change.study())
      return;
    pause();
    Q_EMIT stateChanged();
  });
}

bool StudyPlayer::leads() const {
  return workspace_.state().study && !playback_.sequence();
}

double StudyPlayer::periodSeconds() const {
  const auto& study = workspace_.state().study;
  return study ? presentation::cineSeconds(*study->study) : 0;
}

void StudyPlayer::followMotion() {
  if (workspace_.state().study && playback_.showing())
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
  if (!workspace_.state().study)
    return;
  const medical_io::CineStudy& study = *workspace_.state().study->study;
  const std::size_t slice = presentation::cineSlices(study, view_.state().scan.cine)[0];
  seek(presentation::cineStep(study.slices[slice], fraction(), pictures));
}

void StudyPlayer::advance() {
  const double seconds = playback_.player().speed() * static_cast<double>(clock_.restart()) / kMsPerSecond;
  seek(presentation::cineAdvanced(fraction(), seconds, periodSeconds(), loop_));
  if (!loop_ && fraction() >= 1)
    pause();
}

} // namespace viscera::app
