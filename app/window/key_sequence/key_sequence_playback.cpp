#include "window/key_sequence/key_sequence_playback.h"

#include <algorithm>

#include "viscera/document/key_sequence.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/live/sequence_file.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

constexpr double kSecondsBetweenKeys = 0.5; ///< s

/// Whether any key moves a handle that there is: another rig leaves nothing of a recording.
bool movesAny(const document::KeySequence& keySequence, const document::Rig& rig) {
  return std::any_of(keySequence.keys.begin(), keySequence.keys.end(), [&](const document::SequenceKey& key) {
    return std::any_of(key.displacements.begin(), key.displacements.end(),
                       [&](const auto& moved) { return rig.indexOf(moved.first) >= 0; });
  });
}

/// The organ that a recording is offered with; none without organs.
document::OrganId firstOrgan(const document::DocumentState& state) {
  return state.organs->empty() ? document::OrganId{} : state.organs->front()->id;
}

} // namespace

KeySequencePlayback::KeySequencePlayback(Workspace& workspace, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback) {
  subscription_ = workspace.onChange([this](const document::Change& change) {
    // Another name or look of an organ leaves the motion where it is: a new sequence would begin at rest.
    if (change.keySequence() || change.rig() || firstOrgan(change.before) != firstOrgan(change.after))
      sync(change.keySequence());
  });
}

void KeySequencePlayback::sync(bool choose) {
  const document::KeySequence& keySequence = workspace_.document().keySequence();
  if (!present_ && keySequence.keys.empty())
    return;
  const bool present = present_ && playback_.sequence() == present_.get();
  if (present_)
    playback_.forget(present_.get());
  present_.reset();
  const auto& organs = workspace_.document().organs();
  if (organs.empty() || !movesAny(keySequence, workspace_.document().rig()))
    return;
  workspace_.guarded([&] { present_ = document::sequenceOf(keySequence, workspace_.document().rig()); });
  if (!present_)
    return;
  if (choose || present)
    playback_.setSequence(present_, organs.front()->id);
  else
    playback_.offer(present_, organs.front()->id);
}

double KeySequencePlayback::nextSeconds() const {
  const auto& keys = workspace_.document().keySequence().keys;
  return keys.empty() ? 0 : keys.back().seconds + kSecondsBetweenKeys;
}

bool KeySequencePlayback::addKey(double seconds, sequences::Easing easing) {
  std::vector<document::Command> commands;
  if (seconds >= workspace_.document().keySequence().periodSeconds) {
    document::KeySequenceEdit longer;
    longer.periodSeconds = seconds + kSecondsBetweenKeys;
    commands.push_back(document::editKeySequence(longer));
  }
  commands.push_back(document::recordKey(seconds, easing));
  return workspace_.perform(document::combined(
      tr("Record a key at %1 s").arg(formatNumber(seconds, 2)).toStdString(), std::move(commands)));
}

bool KeySequencePlayback::takePose(document::KeyId key) {
  const document::SequenceKey* found = workspace_.document().keySequence().key(key);
  if (!found)
    return false;
  return workspace_.perform(document::setPose(document::poseOf(*found, workspace_.document().rig()),
                                              tr("Use a key's pose").toStdString()));
}

void KeySequencePlayback::save(const QString& file) {
  const bool done = workspace_.guarded(
      [&] { live::writeSequence(file.toStdString(), live::sequenceFile(workspace_.document().state())); });
  if (done)
    workspace_.note(tr("Sequence saved as %1").arg(file));
}

void KeySequencePlayback::open(const QString& file) {
  workspace_.guarded(
      [&] { workspace_.undo().perform(live::openSequence(live::readSequence(file.toStdString()))); });
}

} // namespace viscera::app
