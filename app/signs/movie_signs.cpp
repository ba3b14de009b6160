#include "signs/movie_signs.h"

#include <QPainter>
#include <QTextDocument>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "signs/circulation_texts.h"
#include "signs/instant_marks.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"

namespace viscera::app {
namespace {

/// Pixels of a movie's height whose strip has its usual size.
constexpr double kUsualMovieHeight = 600;
constexpr double kLeastStripScale = 0.6;
constexpr int kMovieMargin = 8;

QColor inkOf(const Vec3& color) {
  return QColor::fromRgbF(color.x(), color.y(), color.z());
}

/// Pictures of VTK begin with their lowest row.
QImage imageOfVtk(vtkImageData* picture) {
  const int* size = picture->GetDimensions();
  QImage image(size[0], size[1], QImage::Format_RGB888);
  for (int y = 0; y < size[1]; ++y)
    std::memcpy(image.scanLine(size[1] - 1 - y), picture->GetScalarPointer(0, y, 0),
                static_cast<std::size_t>(3 * size[0]));
  return image;
}

vtkSmartPointer<vtkImageData> vtkPictureOf(const QImage& image) {
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(image.width(), image.height(), 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height(); ++y)
    std::memcpy(picture->GetScalarPointer(0, y, 0), image.constScanLine(image.height() - 1 - y),
                static_cast<std::size_t>(3 * image.width()));
  return picture;
}

int evenPart(double pixels) {
  return 2 * static_cast<int>(std::ceil(pixels / 2));
}

} // namespace

std::unique_ptr<MovieSigns> MovieSigns::of(Source source, const QSize& picture) {
  auto signs = std::unique_ptr<MovieSigns>(new MovieSigns(std::move(source), picture));
  const presentation::HeartSigns& chosen = signs->source_.signs;
  const bool drawn =
      signs->source_.curves ? chosen.anyOfCirculation() : signs->drawing_.hasBeat() && chosen.anyOfTextbook();
  return drawn ? std::move(signs) : nullptr;
}

MovieSigns::MovieSigns(Source source, const QSize& picture)
    : source_(std::move(source)),
      scale_(std::clamp(picture.height() / kUsualMovieHeight, kLeastStripScale, scene::kLectureTypeScale)) {
  if (source_.curves) {
    size_ = {picture.width(), evenPart(presentation::kCirculationSignsPart * picture.height())};
    return;
  }
  drawing_.setBeat(source_.beat);
  drawing_.setSigns(source_.signs);
  size_ = {picture.width(), evenPart(drawing_.height(scale_))};
}

/// The charts and above them the meaning of their colours.
void MovieSigns::drawCurves() {
  const presentation::ShownCirculation* before = source_.curves->before ? &*source_.curves->before : nullptr;
  ground_ = QImage(size_, QImage::Format_RGB888);
  ground_.fill(inkOf(source_.theme.panel));
  QTextDocument legend;
  QFont type = source_.type;
  type.setPointSizeF(presentation::stripTypeScale(size_.width(), size_.height()) * type.pointSizeF());
  legend.setDefaultFont(type);
  legend.setDocumentMargin(2);
  legend.setHtml(QStringLiteral("<span style=\"color:%1\">%2</span>")
                     .arg(inkOf(source_.theme.text).name(), circulationLegendText(before, source_.language)));
  legend.setTextWidth(size_.width() - 2 * kMovieMargin);
  legendHeight_ = std::min(static_cast<int>(std::ceil(legend.size().height())), size_.height() / 3);
  const int width = size_.width(), height = size_.height() - legendHeight_;
  scene::Theme theme = source_.theme;
  theme.typeScale = presentation::stripTypeScale(width, height);
  scene::CurvePanels panels;
  scene::SurfacelessWindow window(width, height);
  panels.setDecimalMark(source_.language.decimalMark.front());
  panels.setTheme(theme);
  panels.setWindow(window.window());
  places_ = circulationPanels(source_.curves->shown, before, {width, height, theme.typeScale, source_.signs},
                              source_.language);
  panels.setPanels(places_);
  panels.update();
  const QImage charts = imageOfVtk(scene::grabPicture(window.window()));
  panels.setWindow(nullptr);
  QPainter painter(&ground_);
  painter.drawImage(0, legendHeight_, charts);
  painter.translate(kMovieMargin, 0);
  legend.drawContents(&painter);
}

vtkSmartPointer<vtkImageData> MovieSigns::picture(double fraction) {
  if (ground_.isNull()) {
    if (source_.curves) {
      drawCurves();
    } else {
      ground_ = QImage(size_, QImage::Format_RGB888);
      ground_.fill(inkOf(source_.theme.panel));
    }
  }
  QImage image = ground_;
  QPainter painter(&image);
  if (!source_.curves) {
    QFont type = source_.type;
    type.setPointSizeF(scale_ * type.pointSizeF());
    drawing_.paint(
        painter, QRectF(QPointF(0, 0), QSizeF(size_)), fraction,
        {inkOf(source_.theme.text), inkOf(source_.theme.muted), inkOf(source_.theme.panel), type, scale_});
  } else if (source_.curves->marked) {
    painter.translate(0, legendHeight_);
    paintMarks(painter, presentation::instantMarks(places_, source_.curves->shown, fraction),
               QSizeF(size_.width(), size_.height() - legendHeight_), inkOf(source_.theme.text));
  }
  painter.end();
  return vtkPictureOf(image);
}

vtkSmartPointer<vtkImageData> aboveEachOther(vtkImageData* upper, vtkImageData* lower) {
  const int* a = upper->GetDimensions();
  const int* b = lower->GetDimensions();
  const int width = std::min(a[0], b[0]);
  auto both = vtkSmartPointer<vtkImageData>::New();
  both->SetDimensions(width, a[1] + b[1], 1);
  both->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < a[1] + b[1]; ++y) {
    const bool below = y < b[1];
    std::memcpy(both->GetScalarPointer(0, y, 0),
                below ? lower->GetScalarPointer(0, y, 0) : upper->GetScalarPointer(0, y - b[1], 0),
                static_cast<std::size_t>(3 * width));
  }
  return both;
}

} // namespace viscera::app
