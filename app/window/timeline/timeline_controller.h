#pragma once

#include <QObject>

#include "window/actions.h"
#include "window/timeline/playback.h"
#include "window/timeline/timeline_bar.h"

class QAction;

namespace viscera::app {

/// Ties the timeline and the actions of the transport to a playback.
class TimelineController final : public QObject {
  Q_OBJECT

public:
  /// Adds "play.toggle", "play.start", "play.back", "play.forward" and "play.loop". All have to live longer.
  TimelineController(Playback& playback, TimelineBar& bar, Actions& actions, QObject* parent = nullptr);

private:
  void addTo(Actions& actions);
  void connectBar();
  void sync();
  void syncCourse();
  void syncInstant();

  Playback& playback_;
  TimelineBar& bar_;
  std::vector<QAction*> transport_; ///< Usable while there is a sequence.
  QAction* loop_ = nullptr;
};

} // namespace viscera::app
