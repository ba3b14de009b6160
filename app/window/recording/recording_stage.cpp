#include "window/recording/recording_stage.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include "viscera/scene/picture.h"
#include "window/measure/measure_scene.h"
#include "window/view/label_scene.h"

namespace viscera::app {
namespace {
constexpr int kCaptionSize = 18;
constexpr double kCaptionMargin = 16;
} // namespace

RecordingStage::RecordingStage(const Source& source)
    : sequence_(source.playback.motion().sequence), rate_(source.playback.player().ratePerMinute()) {
  live::LiveBinding& live = source.workspace.live();
  for (const auto& organ : source.workspace.document().organs()) {
    Surface surface{organ, nullptr, nullptr, live.volume(organ->id).nowMl};
    const deformation::Deformer* bound = live.deformer(organ->id);
    if (sequence_ && bound && bound->restHandles().rows() == sequence_->restHandles().rows())
      surface.deformer =
          std::make_shared<deformation::Deformer>(organ->mesh, bound->sharedBinding(), bound->restHandles());
    if (organ->look.tracked && organ->closed())
      names_.push_back(organ->name);
    surfaces_.push_back(std::move(surface));
  }
}

RecordingStage::~RecordingStage() {
  if (window_)
    window_->window()->MakeCurrent();
  labels_.reset();
  measurements_.reset();
  view_.reset(); // Leaves the window while that is there.
}

void RecordingStage::prepareView(const Source& source, const QSize& size, bool caption) {
  size_ = size;
  view_ = std::make_unique<scene::OrganView>();
  view_->setTheme(source.view.theme());
  addActors(source);
  view_->renderer()->GetActiveCamera()->DeepCopy(source.view.renderer()->GetActiveCamera());
  if (source.labels)
    addLabels(source.workspace.document());
  if (source.measurements && !source.workspace.document().measurements().empty()) {
    measurements_ = std::make_unique<scene::MeasurementGlyphs>(*view_);
    measured_ = source.workspace.state();
  }
  captionShown_ = caption;
  if (caption)
    addCaption(source.view.theme().text);
}

void RecordingStage::addLabels(const document::Document& document) {
  labels_ = std::make_unique<scene::OrganLabels>(*view_);
  labels_->setItems(labelItems(document, [this](document::OrganId id) {
    for (const Surface& surface : surfaces_)
      if (surface.organ->id == id)
        return std::shared_ptr<const scene::OrganActor>(surface.actor);
    return std::shared_ptr<const scene::OrganActor>();
  }));
  labels_->setShown(true);
}

void RecordingStage::addCaption(const Vec3& color) {
  vtkTextProperty* style = caption_->GetTextProperty();
  style->SetColor(color.x(), color.y(), color.z());
  style->SetFontFamilyToArial();
  style->SetFontSize(kCaptionSize);
  style->SetVerticalJustificationToTop();
  style->SetLineSpacing(1.3);
  caption_->SetPosition(kCaptionMargin, size_.height() - kCaptionMargin);
  view_->renderer()->AddActor2D(caption_);
}

void RecordingStage::openWindow() {
  window_ = std::make_unique<scene::SurfacelessWindow>(size_.width(), size_.height());
  view_->setWindow(window_->window());
}

void RecordingStage::addActors(const Source& source) {
  for (Surface& surface : surfaces_) {
    surface.actor = std::make_shared<scene::OrganActor>(surface.organ->mesh);
    const document::OrganLook& look = surface.organ->look;
    surface.actor->setColor(look.color);
    surface.actor->setVertexColorsShown(look.vertexColors);
    surface.actor->setOpacity(look.opacity);
    surface.actor->setVisible(look.visible);
    if (surface.deformer)
      surface.actor->setPoints(std::shared_ptr<const Points>(surface.deformer, &surface.deformer->points()));
    else
      surface.actor->setPoints(std::make_shared<Points>(source.workspace.live().points(surface.organ->id)));
    view_->add(surface.actor);
  }
}

double RecordingStage::periodSeconds() const {
  return sequence_ && rate_ > 0 ? 60.0 / rate_ : 0;
}

void RecordingStage::show(double seconds) {
  seconds_ = seconds;
  if (!sequence_)
    return;
  sequence_->poseAt(seconds, rate_, pose_);
  for (const Surface& surface : surfaces_)
    if (surface.deformer)
      surface.deformer->setPose(pose_);
}

std::vector<double> RecordingStage::volumes() {
  std::vector<double> milliliters;
  for (const Surface& surface : surfaces_)
    if (surface.organ->look.tracked && surface.organ->closed())
      milliliters.push_back(surface.deformer ? surface.deformer->volumeMm3() / kMm3PerMl : surface.stillMl);
  return milliliters;
}

void RecordingStage::writeCaption() {
  QString lines;
  if (sequence_) {
    lines = QCoreApplication::translate("viscera::app::RecordingStage", "%1, %2 / min")
                .arg(text(sequence_->name()))
                .arg(rate_, 0, 'f', 0);
    const double fraction = std::fmod(seconds_, periodSeconds()) / periodSeconds();
    for (const sequences::Phase& phase : sequence_->phases(rate_))
      if (fraction >= phase.begin && fraction < phase.end)
        lines += QLatin1Char('\n') + text(phase.name);
  }
  const std::vector<double> milliliters = volumes();
  for (std::size_t i = 0; i < names_.size(); ++i)
    lines += QStringLiteral("\n%1  %2").arg(text(names_[i]), formatMilliliters(milliliters[i]));
  caption_->SetInput(lines.trimmed().toUtf8().constData());
}

void RecordingStage::measure() {
  const auto isShown = [](document::OrganId id) {
    return [id](const Surface& surface) { return surface.organ->id == id; };
  };
  measurements_->setItems(measurementItems(measured_, [&](document::OrganId id) -> const Points& {
    return std::find_if(surfaces_.begin(), surfaces_.end(), isShown(id))->actor->points();
  }));
}

vtkSmartPointer<vtkImageData> RecordingStage::picture() {
  if (!window_)
    openWindow();
  window_->window()->MakeCurrent(); // Two views are drawn in turn.
  for (const Surface& surface : surfaces_)
    if (surface.deformer)
      surface.actor->pointsChanged();
  if (measurements_)
    measure();
  view_->renderer()->ResetCameraClippingRange();
  if (captionShown_)
    writeCaption();
  return scene::grabPicture(window_->window());
}

vtkSmartPointer<vtkImageData> besideEachOther(vtkImageData* left, vtkImageData* right) {
  const int* a = left->GetDimensions();
  const int* b = right->GetDimensions();
  auto both = vtkSmartPointer<vtkImageData>::New();
  both->SetDimensions(a[0] + b[0], std::min(a[1], b[1]), 1);
  both->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < both->GetDimensions()[1]; ++y) {
    auto* row = static_cast<unsigned char*>(both->GetScalarPointer(0, y, 0));
    std::copy_n(static_cast<unsigned char*>(left->GetScalarPointer(0, y, 0)), 3 * a[0], row);
    std::copy_n(static_cast<unsigned char*>(right->GetScalarPointer(0, y, 0)), 3 * b[0], row + 3 * a[0]);
  }
  return both;
}

} // namespace viscera::app
