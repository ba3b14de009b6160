#include "viscera/scene/depth_shading.h"

#include <algorithm>
#include <initializer_list>

#include <vtkCallbackCommand.h>
#include <vtkCameraPass.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkOverlayPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkSmartPointer.h>
#include <vtkToneMappingPass.h>
#include <vtkTranslucentPass.h>

#include "viscera/scene/organ_view.h"

namespace viscera::scene {
namespace {

/// How far around a point others darken it, and how near they are the point's own surface: of the organs'
/// size.
constexpr double kShadingReach = 0.05;
constexpr double kBias = 0.001;
constexpr int kSamplesAround = 64;
/// Exposure of the exponential curve: mid grey stays about what it was, and highlights are not burnt out.
constexpr double kExposure = 1.5;

void setPasses(vtkSequencePass* sequence, std::initializer_list<vtkRenderPass*> parts) {
  vtkNew<vtkRenderPassCollection> all;
  for (vtkRenderPass* part : parts)
    all->AddItem(part);
  sequence->SetPasses(all);
}

} // namespace

struct DepthShading::Parts {
  explicit Parts(OrganView& shaded) : view(shaded), renderer(shaded.renderer()) {}

  OrganView& view; ///< Only looked at while it draws.
  vtkSmartPointer<vtkRenderer> renderer;
  std::optional<bool> wanted;
  std::optional<bool> software; ///< None: no frame was drawn yet.
  vtkNew<vtkCallbackCommand> beforeFrame;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkSequencePass> solid;
  vtkNew<vtkCameraPass> camera;
  vtkNew<vtkSSAOPass> occlusion;
  vtkNew<vtkTranslucentPass> translucent; ///< Outlines and the like, which need the depth that is there.
  vtkNew<vtkSequencePass> space;
  vtkNew<vtkToneMappingPass> tones;
  vtkNew<vtkOpenGLFXAAPass> edges;
  vtkNew<vtkOverlayPass> overlay;
  vtkNew<vtkSequencePass> all;

  void build();
  bool suits() const;
  void prepare();
  void stop();
};

void DepthShading::Parts::build() {
  setPasses(solid, {lights, opaque});
  camera->SetDelegatePass(solid);
  occlusion->SetDelegatePass(camera);
  occlusion->SetKernelSize(kSamplesAround);
  occlusion->BlurOn();
  setPasses(space, {occlusion, translucent});
  tones->SetToneMappingType(vtkToneMappingPass::Exponential);
  tones->SetExposure(kExposure);
  tones->SetDelegatePass(space);
  setPasses(all, {edges, overlay});
}

bool DepthShading::Parts::suits() const {
  const auto& organs = view.organs();
  const auto seen = [](const auto& organ) { return organ->drawn(); };
  return std::any_of(organs.begin(), organs.end(), seen) && !view.legend().visible() &&
         !(view.isSlow() && view.moving()) &&
         std::none_of(organs.begin(), organs.end(), [](const auto& organ) {
           return organ->drawn() && (organ->opacity() < 1 || organ->scalarsShown());
         });
}

void DepthShading::Parts::prepare() {
  if (!software) // Only now the window surely has a context to ask.
    software = rendersInSoftware(renderer->GetRenderWindow());
  const bool on = wanted.value_or(!*software) && suits();
  if (!on) {
    stop();
    return;
  }
  const double size = view.bounds().diagonal();
  occlusion->SetRadius(kShadingReach * size);
  occlusion->SetBias(kBias * size);
  // The curve of tones would only make everything grey on a light background.
  vtkRenderPass* under = view.theme().dark ? static_cast<vtkRenderPass*>(tones) : space;
  if (edges->GetDelegatePass() != under) {
    stop(); // The curve of tones is released with the others only while it is one of them.
    edges->SetDelegatePass(under);
  }
  renderer->SetPass(all);
}

void DepthShading::Parts::stop() {
  if (renderer->GetPass() && renderer->GetRenderWindow())
    all->ReleaseGraphicsResources(renderer->GetRenderWindow());
  renderer->SetPass(nullptr);
}

DepthShading::DepthShading(OrganView& view) : parts_(std::make_unique<Parts>(view)) {
  auto& p = *parts_;
  p.build();
  p.beforeFrame->SetClientData(&p);
  p.beforeFrame->SetCallback(
      [](vtkObject*, unsigned long, void* parts, void*) { static_cast<Parts*>(parts)->prepare(); });
  p.renderer->AddObserver(vtkCommand::StartEvent, p.beforeFrame);
}

DepthShading::~DepthShading() {
  auto& p = *parts_;
  p.renderer->RemoveObserver(p.beforeFrame);
  p.stop();
}

void DepthShading::setWanted(std::optional<bool> wanted) {
  parts_->wanted = wanted;
}

bool DepthShading::wanted() const {
  return parts_->wanted.value_or(parts_->software && !*parts_->software);
}

bool DepthShading::drawn() const {
  return parts_->renderer->GetPass() != nullptr;
}

} // namespace viscera::scene
