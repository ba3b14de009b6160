#include "window/lecture/slides.h"

#include <algorithm>
#include <utility>

#include "viscera/presentation/presenter.h"

namespace viscera::app {

Slides::Slides(Workspace& workspace, ViewModel& view, ViewWidget& widget, Playback& playback,
               Actions& actions, QObject* parent)
    : QObject(parent), workspace_(workspace), view_(view), widget_(widget), playback_(playback) {
  actions.add("slides.add",
              {tr("&Keep this view as a slide"),
               "add",
               {tr("Ctrl+Shift+K")},
               tr("Keep the present view with its cut, names and hidden organs, and the instant of a paused "
                  "sequence")},
              [this] { add(); });
  actions.add("slides.remove",
              {tr("&Remove the slide"), "remove", {}, tr("Remove the slide that was shown last")},
              [this] { remove(current_); });
  actions.add("slides.next", {tr("&Next slide"), "step_forward", {QKeySequence(Qt::Key_PageDown)}, {}},
              [this] { next(); });
  actions.add("slides.previous", {tr("&Previous slide"), "step_back", {QKeySequence(Qt::Key_PageUp)}, {}},
              [this] { previous(); });
  actions.add(
      "slides.leave",
      {tr("&Back from the slides"), nullptr, {}, tr("Show, cut and name the organs as before the slides")},
      [this] { leave(); });
  actions.enableWhile({"slides.leave"}, [this] { return before_ || !view_.state().organsSeen.empty(); });
  actions.enableWhile({"slides.next"}, [this] { return current_ + 1 < static_cast<int>(all().size()); });
  actions.enableWhile({"slides.previous"}, [this] { return current_ > 0; });
  actions.enableWhile({"slides.remove"}, [this] { return current_ >= 0; });
  connect(&view, &ViewModel::changed, this, &Slides::onView);
  connect(this, &Slides::changed, &actions, &Actions::sync);
  subscription_ = workspace.onChange([this](const document::Change& change) { onDocument(change); });
}

void Slides::onView() {
  if (!editing_ && all() != known_)
    before_.reset();
  known_ = all();
  current_ = std::min(current_, static_cast<int>(all().size()) - 1);
  Q_EMIT changed();
}

/// When the user changes the look of an organ that a slide overrides, the new look is shown.
void Slides::onDocument(const document::Change& change) {
  const auto lookOf = [](const document::DocumentState& state, document::OrganId id) {
    const auto organ = state.organ(id);
    return organ ? std::optional(organ->look) : std::nullopt;
  };
  presentation::OrgansSeen still = view_.state().organsSeen;
  std::erase_if(still, [&](const auto& item) {
    return lookOf(change.before, item.first) != lookOf(change.after, item.first);
  });
  view_.change([&](presentation::ViewState& state) { state.organsSeen = std::move(still); });
}

void Slides::edit(const std::function<void(std::vector<presentation::Slide>&)>& change) {
  editing_ = true;
  view_.change([&](presentation::ViewState& state) { change(state.slides); });
  editing_ = false;
}

/// The visible organs, whether the document or a slide determines that.
presentation::SlideLook Slides::lookNow() const {
  const presentation::ViewState& view = view_.state();
  presentation::SlideLook look{view.cut, view.labels, view.partNames, view.organsSeen};
  for (const auto& organ : *workspace_.state().organs)
    look.organs.try_emplace(organ->id, presentation::OrganSeen{organ->look.visible, organ->look.opacity});
  return look;
}

/// Organs that the document shows in the same way are left to it.
void Slides::takeLook(const presentation::SlideLook& look) {
  presentation::OrgansSeen otherwise;
  for (const auto& [id, seen] : look.organs)
    if (const auto organ = workspace_.state().organ(id);
        organ && seen != presentation::OrganSeen{organ->look.visible, organ->look.opacity})
      otherwise[id] = seen;
  view_.change([&](presentation::ViewState& state) {
    state.cut = look.cut;
    state.labels = look.labels;
    state.partNames = look.partNames;
    state.organsSeen = std::move(otherwise);
  });
}

void Slides::showLook(const presentation::Slide& slide) {
  if (!slide.look)
    return leave();
  if (!before_) {
    before_ = lookNow();
    before_->organs.clear(); // As the document says.
  }
  takeLook(*slide.look);
}

void Slides::leave() {
  if (const auto before = std::exchange(before_, std::nullopt))
    takeLook(*before);
  else
    view_.change([](presentation::ViewState& state) { state.organsSeen.clear(); });
  Q_EMIT changed();
}

void Slides::resume() {
  if (current_ >= 0)
    showLook(all()[static_cast<std::size_t>(current_)]);
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
  slide.look = lookNow();
  const int place = current_ + 1;
  edit([&](std::vector<presentation::Slide>& slides) { slides.insert(slides.begin() + place, slide); });
  setCurrent(place);
  Q_EMIT kept(QString::fromStdString(slide.caption));
}

void Slides::remove(int slide) {
  if (slide < 0 || slide >= static_cast<int>(all().size()))
    return;
  edit([slide](std::vector<presentation::Slide>& slides) { slides.erase(slides.begin() + slide); });
}

void Slides::rename(int slide, const QString& caption) {
  if (slide < 0 || slide >= static_cast<int>(all().size()))
    return;
  edit([&](std::vector<presentation::Slide>& slides) {
    slides[static_cast<std::size_t>(slide)].caption = caption.toStdString();
  });
}

void Slides::move(int from, int to) {
  const int count = static_cast<int>(all().size());
  if (from < 0 || to < 0 || from >= count || to >= count || from == to)
    return;
  edit([from, to](std::vector<presentation::Slide>& slides) {
    const auto first = slides.begin();
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
  const presentation::Slide wanted = all()[static_cast<std::size_t>(slide)];
  showLook(wanted);
  presentation::lookFrom(wanted.camera, view_.state(), widget_.view());
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
