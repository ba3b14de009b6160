#pragma once

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

#include "window/timeline/playback.h"
#include "window/view/view_model.h"
#include "window/view/view_widget.h"
#include "window/workspace.h"

namespace viscera::app {

/// Manages the slides of the session: kept views, each with a caption, an instant of a sequence, and which
/// organs are seen, cut or whole, with or without names. They are part of the view's state, which a session
/// keeps. Showing one does not change the document: what it hides is hidden in the view's state.
class Slides final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer. Adds "slides.add", "slides.remove", "slides.next" (Page Down, as remotes of
  /// presentations send it), "slides.previous" and "slides.leave".
  Slides(Workspace& workspace, ViewModel& view, ViewWidget& widget, Playback& playback, Actions& actions,
         QObject* parent = nullptr);

  const std::vector<presentation::Slide>& all() const { return view_.state().slides; }
  /// The one shown last; -1: none.
  int current() const { return current_; }

  /// Keeps the present view after the current slide, and makes it the current one. A sequence that stands
  /// still keeps its instant; one that plays goes on playing when the slide is shown. Organs are kept as they
  /// are seen.
  void add();
  void remove(int slide);
  void rename(int slide, const QString& caption);
  void move(int from, int to);
  /// Brings the view to a slide.
  void show(int slide);
  /// Organs, cut and names are again as before the first slide that had some of its own; the camera stays.
  void leave();
  /// After `leave`, they are those of the current slide again.
  void resume();
  /// What `leave` goes back to; none while no slide has changed it.
  const std::optional<presentation::SlideLook>& lookBefore() const { return before_; }
  void next() { show(current_ + 1); }
  void previous() { show(current_ - 1); }

Q_SIGNALS:
  /// Other slides, other captions, or another current one.
  void changed();
  /// The present view is a slide now.
  void kept(const QString& caption);

private:
  void setCurrent(int slide);
  presentation::SlideLook lookNow() const;
  void takeLook(const presentation::SlideLook& look);
  void showLook(const presentation::Slide& slide);
  void edit(const std::function<void(std::vector<presentation::Slide>&)>& change);
  void onView();
  void onDocument(const document::Change& change);

  Workspace& workspace_;
  ViewModel& view_;
  ViewWidget& widget_;
  Playback& playback_;
  int current_ = -1;
  /// As it was before the first slide with a look of its own.
  std::optional<presentation::SlideLook> before_;
  std::vector<presentation::Slide> known_; ///< Others than these came with another session.
  bool editing_ = false;
  Subscription subscription_;
};

} // namespace viscera::app
