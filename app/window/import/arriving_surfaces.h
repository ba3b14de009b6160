#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <mutex>
#include <vector>

#include "viscera/document/open_files.h"
#include "viscera/presentation/presenter.h"

namespace viscera::app {

class Picture;
class Playback;

/// Shows organs in the view one after another while a worker still reads the others, so that the user sees at
/// once whether it is the right patient. They are added to the document when all are read.
class ArrivingSurfaces final : public QObject {
  Q_OBJECT

  struct Box;

public:
  /// Identifies one job that reads files.
  using Ticket = std::shared_ptr<Box>;

  /// All have to live longer.
  ArrivingSurfaces(Playback& playback, Picture& picture, QObject* parent = nullptr);
  ~ArrivingSurfaces() override;

  /// Begins to show the organs of a new ticket, and stops showing those of older ones. `alone`: in place of
  /// the document's organs, whose sequence is paused meanwhile.
  Ticket begin(bool alone);
  /// The listener through which the worker passes organs. It may be called at any time; organs that it passes
  /// after `end` are not shown.
  static document::ArrivingOrganListener listener(const Ticket& ticket);
  /// Removes the surfaces. Nothing happens for an old ticket. Unless the organs are added to the document
  /// (`taken`), the previous organs are shown and played again.
  void end(const Ticket& ticket, bool taken);

private:
  /// Holds organs between the worker and the window.
  struct Box {
    std::mutex mutex;
    std::vector<document::ArrivingOrgan> organs;
  };

  void look();
  void show(const Bounds& whole);

  Playback& playback_;
  Picture& picture_;
  Ticket ticket_;
  QTimer timer_;
  std::vector<presentation::TransientSurface> transient_;
  bool alone_ = false;
  bool played_ = false; ///< Whether the document's motion was playing before the first organ arrived.
};

} // namespace viscera::app
