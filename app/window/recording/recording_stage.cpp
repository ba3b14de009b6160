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
    : state_(source.workspace.state()), organs_(source.workspace.live().copy()), runner_(state_, organs_) {
  const motion::MotionRunner& played = source.playback.player().runner();
  if (source.playback.sequence()) {
    runner_.setSequence(played.sequence());
    runner_.setRatePerMinute(played.ratePerMinute());
    runner_.prescribe(played.prescribed());
  }
  for (const auto& organ : *state_.organs) {
    if (organ->look.tracked && organ->closed())
      names_.push_back(organ->name);
    surfaces_.push_back({organ, nullptr});
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
  addActors();
  view_->renderer()->GetActiveCamera()->DeepCopy(source.view.renderer()->GetActiveCamera());
  if (source.labels)
    addLabels(source.workspace.document());
  if (source.measurements && !state_.measurements->empty())
    measurements_ = std::make_unique<scene::MeasurementGlyphs>(*view_);
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

void RecordingStage::addActors() {
  for (Surface& surface : surfaces_) {
    surface.actor = std::make_shared<scene::OrganActor>(surface.organ->mesh);
    const document::OrganLook& look = surface.organ->look;
    surface.actor->setColor(look.color);
    surface.actor->setVertexColorsShown(look.vertexColors);
    surface.actor->setOpacity(look.opacity);
    surface.actor->setVisible(look.visible);
    surface.actor->setPoints(organs_.sharedPoints(surface.organ->id));
    view_->add(surface.actor);
  }
}

double RecordingStage::periodSeconds() const {
  return runner_.periodSeconds();
}

const std::vector<double>& RecordingStage::show(double seconds) {
  seconds_ = seconds;
  const std::vector<double> all = runner_.show(seconds);
  milliliters_.clear();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (surfaces_[i].organ->look.tracked && surfaces_[i].organ->closed())
      milliliters_.push_back(all[i]);
  return milliliters_;
}

void RecordingStage::writeCaption() {
  QString lines;
  if (const sequences::Sequence* sequence = runner_.sequence().get()) {
    lines = QCoreApplication::translate("viscera::app::RecordingStage", "%1, %2 / min")
                .arg(text(sequence->name()))
                .arg(runner_.ratePerMinute(), 0, 'f', 0);
    const double fraction = std::fmod(seconds_, periodSeconds()) / periodSeconds();
    for (const sequences::Phase& phase : sequence->phases(runner_.ratePerMinute()))
      if (fraction >= phase.begin && fraction < phase.end)
        lines += QLatin1Char('\n') + text(phase.name);
  }
  for (std::size_t i = 0; i < names_.size(); ++i)
    lines += QStringLiteral("\n%1  %2").arg(text(names_[i]), formatMilliliters(milliliters_[i]));
  caption_->SetInput(lines.trimmed().toUtf8().constData());
}

void RecordingStage::measure() {
  const auto isShown = [](document::OrganId id) {
    return [id](const Surface& surface) { return surface.organ->id == id; };
  };
  measurements_->setItems(measurementItems(state_, [&](document::OrganId id) -> const Points& {
    return std::find_if(surfaces_.begin(), surfaces_.end(), isShown(id))->actor->points();
  }));
}

vtkSmartPointer<vtkImageData> RecordingStage::picture() {
  if (!window_)
    openWindow();
  window_->window()->MakeCurrent(); // Two views are drawn in turn.
  for (const Surface& surface : surfaces_)
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
