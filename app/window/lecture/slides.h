#pragma once

#include <QObject>

#include "window/timeline/playback.h"
#include "window/view/view_model.h"
#include "window/view/view_widget.h"

namespace viscera::app {

/// Manages the slides of the session: kept views, each with a caption and an instant of a sequence. They are
/// part of the view's state, which a session keeps.
class Slides final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer. Adds "slides.add", "slides.remove", "slides.next" (Page Down, as remotes of
  /// presentations send it) and "slides.previous".
  Slides(ViewModel& view, ViewWidget& widget, Playback& playback, Actions& actions,
         QObject* parent = nullptr);

  const std::vector<presentation::Slide>& all() const { return view_.state().slides; }
  /// The one shown last; -1: none.
  int current() const { return current_; }

  /// Keeps the present view after the current slide, and makes it the current one. A sequence that stands
  /// still keeps its instant; one that plays goes on playing when the slide is shown.
  void add();
  void remove(int slide);
  void rename(int slide, const QString& caption);
  void move(int from, int to);
  /// Brings the view to a slide.
  void show(int slide);
  void next() { show(current_ + 1); }
  void previous() { show(current_ - 1); }

Q_SIGNALS:
  /// Other slides, other captions, or another current one.
  void changed();

private:
  void setCurrent(int slide);

  ViewModel& view_;
  ViewWidget& widget_;
  Playback& playback_;
  int current_ = -1;
};

} // namespace viscera::app
