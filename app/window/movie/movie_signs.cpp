#include "window/movie/movie_signs.h"

#include <QApplication>
#include <QPainter>
#include <QTextDocument>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "viscera/heart/beating_heart.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"
#include "window/circulation/circulation_charts.h"
#include "window/language.h"
#include "window/timeline/chart_cursor.h"

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

std::unique_ptr<MovieSigns> MovieSigns::of(const Source& source, const QSize& movie) {
  auto signs = std::unique_ptr<MovieSigns>(new MovieSigns(source, movie));
  const bool drawn = signs->curves_ ? source.signs.anyOfCirculation()
                                    : signs->drawing_.hasBeat() && source.signs.anyOfTextbook();
  return drawn ? std::move(signs) : nullptr;
}

MovieSigns::MovieSigns(const Source& source, const QSize& movie)
    : signs_(source.signs), theme_(source.theme), type_(QApplication::font()),
      scale_(std::clamp(movie.height() / kUsualMovieHeight, kLeastStripScale, scene::kLectureTypeScale)) {
  if (const CirculationModel::Shown* shown = source.circulation.present()) {
    curves_ = Curves{*shown, std::nullopt, source.circulation.isPlayed()};
    if (const CirculationModel::Shown* kept = source.circulation.kept())
      curves_->before = *kept;
    size_ = {movie.width(), evenPart(presentation::kCirculationSignsPart * movie.height())};
    return;
  }
  const sequences::Sequence* sequence = source.playback.sequence();
  const heart::BeatingHeart* heart = sequence ? sequence->heart() : nullptr;
  drawing_.setBeat(heart ? heart->textbookBeat(source.playback.player().ratePerMinute()) : std::nullopt);
  drawing_.setSigns(signs_);
  size_ = {movie.width(), evenPart(drawing_.height(scale_))};
}

/// The charts and above them the meaning of their colours.
void MovieSigns::drawCurves() {
  ground_ = QImage(size_, QImage::Format_RGB888);
  ground_.fill(inkOf(theme_.panel));
  QTextDocument legend;
  QFont type = type_;
  type.setPointSizeF(presentation::stripTypeScale(size_.width(), size_.height()) * type.pointSizeF());
  legend.setDefaultFont(type);
  legend.setDocumentMargin(2);
  legend.setHtml(QStringLiteral("<span style=\"color:%1\">%2</span>")
                     .arg(inkOf(theme_.text).name(),
                          circulationLegendText(curves_->before ? &*curves_->before : nullptr)));
  legend.setTextWidth(size_.width() - 2 * kMovieMargin);
  legendHeight_ = std::min(static_cast<int>(std::ceil(legend.size().height())), size_.height() / 3);
  const int width = size_.width(), height = size_.height() - legendHeight_;
  scene::Theme theme = theme_;
  theme.typeScale = presentation::stripTypeScale(width, height);
  scene::CurvePanels panels;
  scene::SurfacelessWindow window(width, height);
  panels.setDecimalMark(decimalMark());
  panels.setTheme(theme);
  panels.setWindow(window.window());
  places_ = circulationPanels(curves_->shown, curves_->before ? &*curves_->before : nullptr,
                              {width, height, theme.typeScale, signs_});
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
    if (curves_) {
      drawCurves();
    } else {
      ground_ = QImage(size_, QImage::Format_RGB888);
      ground_.fill(inkOf(theme_.panel));
    }
  }
  QImage image = ground_;
  QPainter painter(&image);
  if (!curves_) {
    QFont type = type_;
    type.setPointSizeF(scale_ * type.pointSizeF());
    drawing_.paint(painter, QRectF(QPointF(0, 0), QSizeF(size_)), fraction,
                   {inkOf(theme_.text), inkOf(theme_.muted), inkOf(theme_.panel), type, scale_});
  } else if (curves_->marked) {
    painter.translate(0, legendHeight_);
    ChartCursor::paint(painter, presentation::instantMarks(places_, curves_->shown, fraction),
                       QSizeF(size_.width(), size_.height() - legendHeight_), inkOf(theme_.text));
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
