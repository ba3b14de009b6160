#include "window/movie/movie_stage.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include "viscera/heart/beating_heart.h"
#include "viscera/presentation/presenter.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {
constexpr int kCaptionSize = 18;
constexpr double kCaptionMargin = 16;
} // namespace

MovieStage::MovieStage(const Source& source, const QSize& size, bool caption)
    : systems_(source.workspace.registry()), state_(source.workspace.state()),
      organs_(source.workspace.live().copy()), stress_(source.workspace.stress().copy()),
      runner_(state_, organs_), view_(source.picture.state()), stressRange_(source.picture.stressRange()),
      stressLegend_(source.picture.stressLegend()), heartTissue_(source.picture.heartTissue()),
      segments_(source.segments), theme_(source.picture.view().theme()), size_(size),
      captionWanted_(caption) {
  view_.camera = presentation::cameraOf(source.picture.view());
  if (const auto& values = source.picture.presenter().stressValues(); values.ready())
    view_.stress.range = values.range();
  const live::MotionRunner& played = source.playback.player().runner();
  if (source.playback.sequence()) {
    runner_.setSequence(played.sequence());
    runner_.setRatePerMinute(played.ratePerMinute());
    runner_.prescribe(played.prescribed());
  }
  for (const auto& organ : *state_.organs)
    if (organ->look.tracked && organ->closed())
      names_.push_back(organ->name);
}

void MovieStage::openStage() {
  stage_ =
      std::make_unique<presentation::Stage>(size_.width(), size_.height(), theme_, Threads(), translated);
  stage_->view().setDecimalMark(decimalMark());
  presentation::lookFrom(*view_.camera, stage_->view());
  if (captionWanted_)
    addCaption();
}

void MovieStage::addCaption() {
  vtkTextProperty* style = caption_->GetTextProperty();
  style->SetColor(theme_.text.x(), theme_.text.y(), theme_.text.z());
  style->SetFontSize(kCaptionSize);
  style->SetVerticalJustificationToTop();
  style->SetLineSpacing(1.3);
  caption_->SetPosition(kCaptionMargin, size_.height() - kCaptionMargin);
  stage_->view().renderer()->AddActor2D(caption_);
}

const std::vector<double>& MovieStage::show(double seconds) {
  seconds_ = seconds;
  if (runner_.sequence()) // Images over time stand in the picture in the phase of its instant.
    view_.scan.cine.fraction = std::fmod(seconds_, periodSeconds()) / periodSeconds();
  runner_.show(seconds);
  const std::vector<double> all = runner_.volumesMl();
  milliliters_.clear();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (const document::Organ& organ = *(*state_.organs)[i]; organ.look.tracked && organ.closed())
      milliliters_.push_back(all[i]);
  return milliliters_;
}

void MovieStage::writeCaption() {
  QString lines;
  if (const sequences::Sequence* sequence = runner_.sequence().get()) {
    lines = QCoreApplication::translate("viscera::app::MovieStage", "%1, %2 / min")
                .arg(inWords(sequence->name()))
                .arg(formatNumber(runner_.ratePerMinute(), 0));
    const double fraction = std::fmod(seconds_, periodSeconds()) / periodSeconds();
    for (const sequences::Phase& phase : sequence->phases(runner_.ratePerMinute()))
      if (fraction >= phase.begin && fraction < phase.end)
        lines += QLatin1Char('\n') + inWords(phase.name);
  }
  for (std::size_t i = 0; i < names_.size(); ++i)
    lines += QStringLiteral("\n%1  %2").arg(inWords(names_[i]), formatMilliliters(milliliters_[i]));
  caption_->SetInput(lines.trimmed().toUtf8().constData());
}

vtkSmartPointer<vtkImageData> MovieStage::picture() {
  if (!stage_)
    openStage();
  const live::StressFrame& stress = stress_.at(organs_.shownPose());
  presentation::Scene scene{state_, organs_, view_, systems_, &stress};
  std::optional<presentation::SurfaceMap> segments;
  if (segments_)
    scene.map = &segments.emplace(segments_(seconds_));
  scene.stressRange = stressRange_;
  scene.stressLegend = stressLegend_;
  scene.heartTissue = heartTissue_;
  if (runner_.sequence()) {
    scene.valves = heart::valvesAt(*runner_.sequence(), seconds_, runner_.ratePerMinute());
    scene.clock = heart::clockAt(*runner_.sequence(), seconds_, runner_.ratePerMinute());
  }
  stage_->presenter().update(scene);
  if (captionWanted_)
    writeCaption();
  return stage_->picture();
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
