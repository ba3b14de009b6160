#pragma once

#include <QObject>

#include "viscera/lesson/lesson_plan.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/view/view_model.h"

class QWidget;

namespace viscera::app {

class Actions;
class Settings;

/// Exports the visible organs with the present motion as one file for a browser (File > Export lesson...).
class LessonExport final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window from which the lesson is made; all have to live longer.
  struct Window {
    Workspace& workspace;
    Playback& playback;
    const Picture& picture;
    const ViewModel& view;
    Settings& settings;
  };

  LessonExport(Window window, QWidget* parent);

  /// Adds "export.lesson".
  void addTo(Actions& actions);

  /// The present contents of the window that a lesson is made from.
  lesson::LessonSource source() const;
  /// The plan of the lesson, with the texts that the program has about the parts of sample organs. Throws
  /// `UsageError` when no organ is shown.
  lesson::LessonPlan plan() const;
  /// Makes the lesson on a worker and writes it: a page, or a .glb by the file's name.
  void write(const lesson::LessonPlan& plan, const QString& file);

private:
  void choose();

  Window window_;
  QWidget* parent_;
};

} // namespace viscera::app
