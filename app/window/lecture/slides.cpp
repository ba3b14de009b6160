#include "window/lecture/slides.h"

#include <algorithm>

#include "viscera/presentation/presenter.h"

namespace viscera::app {

Slides::Slides(ViewModel& view, ViewWidget& widget, Playback& playback, Actions& actions, QObject* parent)
    : QObject(parent), view_(view), widget_(widget), playback_(playback) {
  actions.add("slides.add",
              {tr("&Keep this view as a slide"),
               "add",
               {tr("Ctrl+Shift+K")},
               tr("Keep the present view, and the instant of a paused sequence")},
              [this] { add(); });
  actions.add("slides.remove",
              {tr("&Remove the slide"), "remove", {}, tr("Remove the slide that was shown last")},
              [this] { remove(current_); });
  actions.add("slides.next", {tr("&Next slide"), "step_forward", {QKeySequence(Qt::Key_PageDown)}, {}},
              [this] { next(); });
  actions.add("slides.previous", {tr("&Previous slide"), "step_back", {QKeySequence(Qt::Key_PageUp)}, {}},
              [this] { previous(); });
  actions.enableWhile({"slides.next"}, [this] { return current_ + 1 < static_cast<int>(all().size()); });
  actions.enableWhile({"slides.previous"}, [this] { return current_ > 0; });
  actions.enableWhile({"slides.remove"}, [this] { return current_ >= 0; });
  connect(&view, &ViewModel::changed, this, [this] {
    current_ = std::min(current_, static_cast<int>(all().size()) - 1); // Another session has its own.
    Q_EMIT changed();
  });
  connect(this, &Slides::changed, &actions, &Actions::sync);
}

void Slides::setCurrent(int slide) {
  current_ = slide;
  Q_EMIT changed();
}

void Slides::add() {
  presentation::Slide slide;
  slide.caption = tr("Slide %1").arg(all().size() + 1).toStdString();
  slide.camera = presentation::cameraOf(widget_.view());
  if (playback_.showing() && !playback_.player().playing())
    slide.fraction = playback_.player().fraction();
  const int place = current_ + 1;
  view_.change(
      [&](presentation::ViewState& state) { state.slides.insert(state.slides.begin() + place, slide); });
  setCurrent(place);
}

void Slides::remove(int slide) {
  if (slide < 0 || slide >= static_cast<int>(all().size()))
    return;
  view_.change([slide](presentation::ViewState& state) { state.slides.erase(state.slides.begin() + slide); });
}

void Slides::rename(int slide, const QString& caption) {
  if (slide < 0 || slide >= static_cast<int>(all().size()))
    return;
  view_.change([&](presentation::ViewState& state) {
    state.slides[static_cast<std::size_t>(slide)].caption = caption.toStdString();
  });
}

void Slides::move(int from, int to) {
  const int count = static_cast<int>(all().size());
  if (from < 0 || to < 0 || from >= count || to >= count || from == to)
    return;
  view_.change([from, to](presentation::ViewState& state) {
    const auto first = state.slides.begin();
    if (from < to)
      std::rotate(first + from, first + from + 1, first + to + 1);
    else
      std::rotate(first + to, first + from, first + from + 1);
  });
  setCurrent(to);
}

void Slides::show(int slide) {
  if (slide < 0 || slide >= static_cast<int>(all().size()))
    return;
  const presentation::Slide& wanted = all()[static_cast<std::size_t>(slide)];
  presentation::lookFrom(wanted.camera, widget_.view());
  widget_.scheduleRender();
  if (playback_.sequence()) {
    if (wanted.fraction)
      playback_.seek(*wanted.fraction); // Pauses.
    else if (!playback_.player().playing())
      playback_.play();
  }
  setCurrent(slide);
}

} // namespace viscera::app
