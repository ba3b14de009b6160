#pragma once

#include "viscera/core/job_queue.h"
#include "viscera/workbench/workbench.h"

namespace viscera::workbench {

/// The parts of a workbench, each after those that it reads.
struct Workbench::Impl {
  Impl(Setup with, Progress* told);

  /// Waits until no job is left; passes progress and cancelling on. Throws `Cancelled`.
  void settle();
  /// Ends a call that has changed something: everything agrees before observers hear of it.
  void finish();
  /// Does a command, and shows the document's pose.
  void perform(const document::Command& command);
  /// Puts a state in place of everything, with nothing to undo.
  void reset(document::SessionContents given);
  std::shared_ptr<const document::Organ> requireOrgan(const std::string& name) const;
  int requireRow(const std::string& label) const;
  std::shared_ptr<const sequences::Sequence> sequence();
  PlayedVolumes show(double seconds);

  Setup setup;
  Progress unheard;
  Progress* progress; ///< Never null.
  document::Document document;
  document::UndoStack undo{document};
  ManualEventLoop loop;
  JobQueue jobs{loop.post()};
  live::LiveBinding organs;
  live::LiveStress stress;
  live::LiveWarp warp;
  live::VolumeKeeper keeper;
  live::MotionRunner motion;
  document::MeasuringMemory memory;
  document::SessionContents contents; ///< As the session had them, for all but the state.
  bool sequenceKnown = false;         ///< The session's sequence was made, or another one was taken.
  Signal<> happened;
};

} // namespace viscera::workbench
