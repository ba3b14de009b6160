#pragma once

#include <QColor>
#include <QImage>
#include <QString>

#include <cmath>
#include <cstdlib>
#include <string>

namespace viscera::app::cli {

/// The strip of the textbook's beat below pictures 480 pixels high: at 0.8 of its usual size, with all its
/// parts 78 pixels high, with the electrocardiogram alone 32.
constexpr int kWholeStrip = 78, kEcgStrip = 32;
/// The margin beside a strip.
constexpr double kStripMargin = 8;

inline int differenceOf(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

/// The fraction of the cycle at which the line of the instant stands in a strip so many pixels high below a
/// picture: in its highest row nothing else is drawn. -1 where no line is.
inline double instantIn(const QImage& picture, int strip) {
  constexpr int kSeen = 60;
  const int row = picture.height() - strip;
  const QColor ground = picture.pixelColor(1, row);
  int best = -1, most = kSeen;
  for (int x = 0; x < picture.width(); ++x)
    if (const int difference = differenceOf(picture.pixelColor(x, row), ground); difference > most) {
      most = difference;
      best = x;
    }
  return best < 0 ? -1 : (best + 0.5 - kStripMargin) / (picture.width() - 2 * kStripMargin);
}

inline QImage imageOf(const std::string& file) {
  return QImage(QString::fromStdString(file));
}

} // namespace viscera::app::cli
