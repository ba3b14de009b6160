#include "window/import/arriving_surfaces.h"

#include <utility>

#include "window/timeline/playback.h"
#include "window/view/picture.h"

namespace viscera::app {
namespace {
/// ms: often enough to show progress, seldom enough to leave the processor to the reading.
constexpr int kInterval = 200;
} // namespace

ArrivingSurfaces::ArrivingSurfaces(Playback& playback, Picture& picture, QObject* parent)
    : QObject(parent), playback_(playback), picture_(picture) {
  timer_.setInterval(kInterval);
  connect(&timer_, &QTimer::timeout, this, &ArrivingSurfaces::look);
}

ArrivingSurfaces::~ArrivingSurfaces() = default;

ArrivingSurfaces::Ticket ArrivingSurfaces::begin(bool alone) {
  end(ticket_, false);
  ticket_ = std::make_shared<Box>();
  alone_ = alone;
  timer_.start();
  return ticket_;
}

document::ArrivingOrganListener ArrivingSurfaces::listener(const Ticket& ticket) {
  if (!ticket)
    return {};
  return [ticket](document::ArrivingOrgan organ) {
    const std::lock_guard lock(ticket->mutex);
    ticket->organs.push_back(std::move(organ));
  };
}

void ArrivingSurfaces::look() {
  std::vector<document::ArrivingOrgan> arrived;
  {
    const std::lock_guard lock(ticket_->mutex);
    arrived.swap(ticket_->organs);
  }
  if (arrived.empty())
    return;
  const bool first = transient_.empty();
  for (document::ArrivingOrgan& organ : arrived) {
    transient_.push_back({std::move(organ.mesh), organ.color, 1});
  }
  if (first)
    show(arrived.front().whole);
  picture_.setTransientSurfaces(transient_, alone_);
}

/// Hidden organs need not move, and between two updates there is no time for a smooth frame.
void ArrivingSurfaces::show(const Bounds& whole) {
  played_ = alone_ && playback_.player().playing();
  if (played_)
    playback_.pause();
  picture_.view().setMoving(true);
  if (alone_)
    picture_.view().lookFrom(scene::StandardView::anterior, whole);
}

void ArrivingSurfaces::end(const Ticket& ticket, bool taken) {
  if (!ticket || ticket != ticket_)
    return;
  ticket_.reset();
  timer_.stop();
  if (transient_.empty())
    return;
  transient_.clear();
  if (std::exchange(played_, false) && !taken)
    playback_.play();
  picture_.view().setMoving(playback_.player().playing());
  picture_.setTransientSurfaces({});
}

} // namespace viscera::app
