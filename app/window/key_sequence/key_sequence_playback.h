#pragma once

#include <QObject>

#include <memory>

#include "viscera/sequences/keyframes.h"
#include "window/timeline/playback.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Makes the document's key sequence available for playing, and updates it after every change of its keys.
class KeySequencePlayback final : public QObject {
  Q_OBJECT

public:
  KeySequencePlayback(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  /// The key sequence as a sequence to play; null without keys for the handles there are.
  const sequences::Sequence* sequence() const { return present_.get(); }

  /// The time proposed for the next key: 0 for the first one, else a step after the last one.
  double nextSeconds() const;
  /// Takes the document's pose as a key at `seconds`; a later time than the key sequence lasts makes it
  /// longer. One undo step.
  bool addKey(double seconds, sequences::Easing easing);
  /// Sets the document's pose to that of a key, so that it can be edited.
  bool takePose(document::KeyId key);
  void save(const QString& file);
  void open(const QString& file);

private:
  void sync(bool choose);

  Workspace& workspace_;
  Playback& playback_;
  std::shared_ptr<const sequences::Sequence> present_;
  Subscription subscription_;
};

} // namespace viscera::app
