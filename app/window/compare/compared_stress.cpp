#include "window/compare/compared_stress.h"

namespace viscera::app {

ComparedStress::ComparedStress(const Side& first, const Side& second, ViewModel& view, QObject* parent)
    : QObject(parent), first_(first), second_(second), view_(view),
      cycle_(second.workspace, second.playback) {
  connect(&view, &ViewModel::changed, this, &ComparedStress::follow);
  connect(&first.picture, &Picture::changed, this, &ComparedStress::shareRange);
  connect(&second.picture, &Picture::changed, this, &ComparedStress::shareRange);
  subscriptions_.push_back(second.workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      follow();
  }));
  subscriptions_.push_back(first.workspace.selection().onChange([this] { follow(); }));
  follow();
}

ComparedStress::~ComparedStress() {
  first_.picture.disconnect(this); // Or its next picture would get the shared range back.
  first_.picture.setStressRange(std::nullopt);
}

/// The first view's organ if the second view has it too; else the second view's first organ.
void ComparedStress::follow() {
  const presentation::ViewState& state = view_.state();
  const auto wanted = first_.workspace.currentOrgan();
  document::OrganId organ;
  if (state.shown.stress) {
    if (const auto own = second_.workspace.currentOrgan())
      organ = own->id;
    const auto same = wanted ? second_.workspace.document().organ(wanted->id) : nullptr;
    if (same && same->mesh == wanted->mesh)
      organ = wanted->id;
  }
  second_.workspace.guarded([&] {
    second_.workspace.stress().setWanted(state.stress.witnesses);
    second_.workspace.stress().follow(organ);
  });
  // The worst of the second view's own cycle, where the first one shows that of its own.
  cycle_.setWanted(state.shown.stress && state.stress.peak ? std::optional(live::CycleParts::curveAndPeak)
                                                           : std::nullopt,
                   state.stress.material.poisson);
  shareRange();
}

void ComparedStress::shareRange() {
  const presentation::StressValues& first = first_.picture.presenter().stressValues();
  const presentation::StressValues& second = second_.picture.presenter().stressValues();
  const presentation::StressLook& look = view_.state().stress;
  const bool both =
      view_.state().shown.stress && first.ready() && second.ready() && first.quantity() == second.quantity();
  const bool shared = both && (look.sameRange || look.pinned);
  const auto range =
      shared ? std::optional(presentation::joined(first.ownRange(), second.ownRange())) : std::nullopt;
  first_.picture.setStressRange(range);
  second_.picture.setStressRange(range, !shared);
}

} // namespace viscera::app
