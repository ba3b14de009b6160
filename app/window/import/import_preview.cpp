#include "window/import/import_preview.h"

#include "window/panels/color_palette.h"
#include "window/view/picture.h"
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
  std::vector<presentation::Guest> guests;
  Bounds box;
  for (const document::DraftOrgan& organ : draft.organs) {
    if (!organ.included)
      continue;
    presentation::Guest guest{organ.mesh, document::OrganLook().color, kGlass};
    if (const auto color = tissueColor(text(organ.name)))
      guest.color = asVec3(*color);
    const Bounds own = boundsOf(organ.mesh->points);
    box = guests.empty() ? own : Bounds{box.low.cwiseMin(own.low), box.high.cwiseMax(own.high)};
    guests.push_back(std::move(guest));
  }
  const double moved = (box.low - shown_.low).norm() + (box.high - shown_.high).norm();
  const bool elsewhere = !guests.empty() && moved > kElsewhere * box.diagonal();
  picture_.setGuests(std::move(guests));
  if (!elsewhere)
    return;
  picture_.view().frame(box);
  shown_ = box;
}

void ImportPreview::clear() {
  picture_.setGuests({});
}

} // namespace viscera::app
