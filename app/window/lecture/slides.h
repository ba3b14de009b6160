#pragma once

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

#include "window/timeline/playback.h"
#include "window/view/view_model.h"
#include "window/view/view_widget.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Manages the slides of the session: kept views, each with a caption, an instant of a sequence, and which
/// organs are seen, cut or whole, with or without names. They are part of the view's state, which a session
/// keeps. Showing a slide does not change the document: organs are hidden in the view's state only.
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
  /// still keeps its instant; one that plays goes on playing when the slide is shown. The visibility of
  /// organs is kept as shown.
  void add();
  void remove(int slide);
  void rename(int slide, const QString& caption);
  void move(int from, int to);
  /// Shows a slide in the view.
  void show(int slide);
  /// Restores organs, cut and names to what they were before the first slide that changed them; the camera
  /// stays.
  void leave();
  /// After `leave`, applies those of the current slide again.
  void resume();
  /// The look that `leave` restores; none while no slide has changed it.
  const std::optional<presentation::SlideLook>& lookBefore() const { return before_; }
  void next() { show(current_ + 1); }
  void previous() { show(current_ - 1); }

Q_SIGNALS:
  /// The slides, their captions or the current slide have changed.
  void changed();
  /// The present view was added as a slide.
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
  /// The look before the first slide that has one of its own.
  std::optional<presentation::SlideLook> before_;
  std::vector<presentation::Slide> known_; ///< The slides known so far; different ones come from another
                                           ///< session.
  bool editing_ = false;
  Subscription subscription_;
};

} // namespace viscera::app
