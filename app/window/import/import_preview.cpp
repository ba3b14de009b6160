#include "window/import/import_preview.h"

#include "window/panels/color_palette.h"
#include "window/view/view_widget.h"
#include "window/workspace.h"

namespace viscera::app {
namespace {

constexpr double kGlass = 0.5;
/// Of the diagonal: less is not worth a jump of the camera.
constexpr double kElsewhere = 0.01;

} // namespace

ImportPreview::~ImportPreview() {
  clear();
}

void ImportPreview::show(const document::ImportDraft& draft) {
  clear();
  Bounds box;
  for (const document::DraftOrgan& organ : draft.organs) {
    if (!organ.included)
      continue;
    auto ghost = std::make_shared<scene::OrganActor>(organ.mesh);
    ghost->setOpacity(kGlass);
    if (const auto color = tissueColor(text(organ.name)))
      ghost->setColor(asVec3(*color));
    const Bounds own = ghost->bounds();
    box = ghosts_.empty() ? own : Bounds{box.low.cwiseMin(own.low), box.high.cwiseMax(own.high)};
    view_.view().add(ghost);
    ghosts_.push_back(std::move(ghost));
  }
  const double moved = (box.low - shown_.low).norm() + (box.high - shown_.high).norm();
  if (!ghosts_.empty() && moved > kElsewhere * box.diagonal()) {
    view_.view().frame(box);
    shown_ = box;
  }
  view_.scheduleRender();
}

void ImportPreview::clear() {
  for (const auto& ghost : ghosts_)
    view_.view().remove(ghost);
  ghosts_.clear();
  view_.scheduleRender();
}

} // namespace viscera::app
