#include "viscera/scene/standing_slices.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "grey_square.h"
#include "viscera/scene/organ_view.h"

namespace viscera::scene {
namespace {

/// One picture in space.
class Standing {
public:
  Standing() {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(square_.data());
    actor_->SetMapper(mapper);
    square_.texture()->InterpolateOn();
    actor_->SetTexture(square_.texture());
    actor_->GetProperty()->LightingOff();
    actor_->PickableOff();
  }

  vtkActor* actor() { return actor_; }

  void show(const StandingSlices::Slice& slice) {
    square_.setCorners({slice.corner, slice.corner + slice.right, slice.corner + slice.right + slice.up,
                        slice.corner + slice.up});
    square_.setGrey(slice.width, slice.height, slice.grey);
  }

private:
  GreySquare square_;
  vtkNew<vtkActor> actor_;
};

} // namespace

struct StandingSlices::Parts {
  OrganView& view;
  std::vector<std::unique_ptr<Standing>> slices;
};

StandingSlices::StandingSlices(OrganView& view) : parts_(new Parts{view, {}}) {}

StandingSlices::~StandingSlices() {
  show({});
}

void StandingSlices::show(const std::vector<Slice>& slices) {
  auto& p = *parts_;
  while (p.slices.size() > slices.size()) {
    p.view.renderer()->RemoveViewProp(p.slices.back()->actor());
    p.slices.pop_back();
  }
  while (p.slices.size() < slices.size()) {
    p.slices.push_back(std::make_unique<Standing>());
    p.view.renderer()->AddViewProp(p.slices.back()->actor());
  }
  for (std::size_t i = 0; i < slices.size(); ++i)
    p.slices[i]->show(slices[i]);
}

std::size_t StandingSlices::count() const {
  return parts_->slices.size();
}

} // namespace viscera::scene
