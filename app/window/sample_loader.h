#pragma once

#include <QObject>
#include <QStringList>

#include <memory>
#include <string>

#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/sequence.h"
#include "window/handle_placer.h"
#include "window/timeline/playback.h"
#include "window/workspace.h"

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
  /// The result of the worker.
  struct Sample {
    std::vector<document::NewOrgan> organs;
    std::shared_ptr<const sequences::Sequence> motion;
    live::MotionRecipe recipe; ///< Makes the motion again.
    document::Rig rig;         ///< The motion's handles.
    document::SystemChoice system;
  };

  static Sample make(const sample_organs::SampleLibrary& library, const std::string& name,
                     Progress& progress);
  void take(const Sample& sample, const QString& name);
  static void dress(std::vector<document::NewOrgan>& organs);

  Workspace& workspace_;
  HandlePlacer& placer_;
  Playback& playback_;
  sample_organs::SampleLibrary library_;
};

} // namespace viscera::app
