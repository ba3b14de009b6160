#include "window/recorded/recorded_motion.h"

#include <algorithm>

#include "viscera/document/recording.h"
#include "viscera/document/recording_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/motion/sequence_file.h"
#include "window/language.h"

namespace viscera::app {
namespace {

constexpr double kKeyStep = 0.5; ///< s

/// Whether any key moves a handle that there is: another rig leaves nothing of a recording.
bool movesAny(const document::Recording& recording, const document::Rig& rig) {
  return std::any_of(recording.keys.begin(), recording.keys.end(), [&](const document::RecordedKey& key) {
    return std::any_of(key.displacements.begin(), key.displacements.end(),
                       [&](const auto& moved) { return rig.indexOf(moved.first) >= 0; });
  });
}

} // namespace

RecordedMotion::RecordedMotion(Workspace& workspace, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback) {
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.recording() || change.rig() || change.organs())
      sync(change.recording());
  });
}

void RecordedMotion::sync(bool choose) {
  const document::Recording& recording = workspace_.document().recording();
  if (!present_ && recording.keys.empty())
    return;
  const bool present = present_ && playback_.sequence() == present_.get();
  if (present_)
    playback_.forget(present_.get());
  present_.reset();
  const auto& organs = workspace_.document().organs();
  if (organs.empty() || !movesAny(recording, workspace_.document().rig()))
    return;
  workspace_.guarded([&] { present_ = document::sequenceOf(recording, workspace_.document().rig()); });
  if (!present_)
    return;
  if (choose || present)
    playback_.setSequence(present_, organs.front()->id);
  else
    playback_.offer(present_, organs.front()->id);
}

double RecordedMotion::nextSeconds() const {
  const auto& keys = workspace_.document().recording().keys;
  return keys.empty() ? 0 : keys.back().seconds + kKeyStep;
}

bool RecordedMotion::addKey(double seconds, sequences::Easing easing) {
  std::vector<document::Command> commands;
  if (seconds >= workspace_.document().recording().periodSeconds) {
    document::RecordingEdit longer;
    longer.periodSeconds = seconds + kKeyStep;
    commands.push_back(document::editRecording(longer));
  }
  commands.push_back(document::recordKey(seconds, easing));
  return workspace_.perform(document::combined(
      tr("Record a key at %1 s").arg(formatNumber(seconds, 2)).toStdString(), std::move(commands)));
}

bool RecordedMotion::takePose(document::KeyId key) {
  const document::RecordedKey* found = workspace_.document().recording().key(key);
  if (!found)
    return false;
  return workspace_.perform(document::setPose(document::poseOf(*found, workspace_.document().rig()),
                                              tr("Use a key's pose").toStdString()));
}

void RecordedMotion::save(const QString& file) {
  const bool done = workspace_.guarded([&] {
    motion::writeSequence(file.toStdString(), motion::sequenceFile(workspace_.document().state()));
  });
  if (done)
    workspace_.note(tr("Sequence saved as %1").arg(file));
}

void RecordedMotion::open(const QString& file) {
  workspace_.guarded(
      [&] { workspace_.undo().perform(motion::openSequence(motion::readSequence(file.toStdString()))); });
}

} // namespace viscera::app
