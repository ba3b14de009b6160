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
/// once whether it is the right patient. The document gets them when all are read.
class ArrivingSurfaces final : public QObject {
  Q_OBJECT

  struct Box;

public:
  /// Of one job that reads files.
  using Ticket = std::shared_ptr<Box>;

  /// All have to live longer.
  ArrivingSurfaces(Playback& playback, Picture& picture, QObject* parent = nullptr);
  ~ArrivingSurfaces() override;

  /// Begins to show what arrives by this ticket, and nothing of other tickets any more. `alone`: in place of
  /// what the document holds, which rests meanwhile.
  Ticket begin(bool alone);
  /// What the worker tells. It may do so as long as it likes; what comes after the end is not shown.
  static document::ArrivingOrganListener listener(const Ticket& ticket);
  /// Takes the surfaces away. Nothing happens for an old ticket. Unless the organs themselves follow
  /// (`taken`), what was there before is seen and plays again.
  void end(const Ticket& ticket, bool taken);

private:
  /// Where organs lie between the worker and the window.
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
  bool played_ = false; ///< The document's motion, before the first organ arrived.
};

} // namespace viscera::app
