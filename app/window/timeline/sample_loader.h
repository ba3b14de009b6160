#pragma once

#include <QObject>
#include <QStringList>

#include "viscera/sample_organs/sample_organ.h"
#include "viscera/workbench/loaded_sample.h"
#include "window/timeline/playback.h"
#include "window/work/handle_placer.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Loads sample organs into the document, with their handles and their motion. Making one for the first time
/// takes seconds: it is a task with progress that can be cancelled.
class SampleLoader final : public QObject {
  Q_OBJECT

public:
  /// The slot of its job, which is also that of opening files.
  static constexpr const char* kSlot = "open";

  SampleLoader(Workspace& workspace, HandlePlacer& placer, Playback& playback, QObject* parent = nullptr);

  /// The names of the installed samples.
  QStringList names() const;
  /// What a sample is called in the window's language, within a sentence and by itself: "left kidney" and
  /// "Left kidney" for "kidney_left".
  static QString nameInWords(const QString& name);
  static QString title(const QString& name);
  /// Replaces everything in the document by a sample, as one undo step. With `play` its motion starts at
  /// once, in a mode that shows motions.
  void load(const QString& name, bool play);
  /// Whether a sample, or a file in its place, is being loaded.
  bool loading() const;

Q_SIGNALS:
  /// A worker makes the sample; `ended` follows, whether there is one then or not.
  void began(const QString& name);
  void ended();
  /// `untouched`: the document held no unsaved work before. `first`: the document was empty before.
  void loaded(const QString& name, bool untouched, bool first);

private:
  void take(const workbench::LoadedSample& sample, const QString& name);

  Workspace& workspace_;
  HandlePlacer& placer_;
  Playback& playback_;
  sample_organs::SampleLibrary library_;
};

} // namespace viscera::app
