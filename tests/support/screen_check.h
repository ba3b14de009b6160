#pragma once

#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"

namespace viscera::tests {

/// The factor by which reference pictures of screens are reduced. They keep layout and colours, but not
/// letters, which differ with the fonts of a machine.
inline constexpr int kScreenShrink = 4;
inline constexpr int kScreenColorStep = 8;
/// The side of a cell, in pixels of the reference; the means of cells are compared.
inline constexpr int kScreenCell = 8;
inline constexpr double kMostCellDifference = 24;
inline constexpr double kMostDifferentCells = 0.06; ///< Part of all.

inline QImage shrunkScreen(const QImage& screen) {
  QImage small = screen.convertToFormat(QImage::Format_RGB888)
                     .scaled(screen.size() / kScreenShrink, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                     .convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < small.height(); ++y) {
    uchar* line = small.scanLine(y);
    std::for_each(line, line + 3 * small.width(), [](uchar& value) {
      value = static_cast<uchar>(
          std::min(255, (value + kScreenColorStep / 2) / kScreenColorStep * kScreenColorStep));
    });
  }
  return small;
}

/// The part of the cells in which two pictures of one size differ.
inline double differentCells(const QImage& one, const QImage& other) {
  int cells = 0, different = 0;
  for (int top = 0; top < one.height(); top += kScreenCell)
    for (int left = 0; left < one.width(); left += kScreenCell) {
      std::array<double, 3> sum{};
      int pixels = 0;
      for (int y = top; y < std::min(top + kScreenCell, one.height()); ++y)
        for (int x = left; x < std::min(left + kScreenCell, one.width()); ++x) {
          const QRgb a = one.pixel(x, y), b = other.pixel(x, y);
          sum[0] += qRed(a) - qRed(b);
          sum[1] += qGreen(a) - qGreen(b);
          sum[2] += qBlue(a) - qBlue(b);
          ++pixels;
        }
      ++cells;
      different += std::any_of(sum.begin(), sum.end(), [&](double channel) {
        return std::abs(channel) / pixels > kMostCellDifference;
      });
    }
  return cells > 0 ? double(different) / cells : 0;
}

/// Compares with `tests/image/reference/screens/<name>.png`. The whole screen is left in `pictures/screens/`
/// of the build folder. With VISCERA_UPDATE_PICTURES set in the environment it becomes the reference instead:
/// look at it before you commit it.
inline void expectScreen(const QImage& screen, const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path reference = fs::path(VISCERA_SOURCE_DIR) / "tests/image/reference/screens" / (name + ".png");
  const fs::path drawn = fs::path(VISCERA_BINARY_DIR) / "pictures/screens" / (name + ".png");
  constexpr int kSmallestFile = 0; // Of Qt's scale of quality, which for PNG is that of compression.
  fs::create_directories(drawn.parent_path());
  screen.save(QString::fromStdString(drawn.string()), "PNG");
  const QImage small = shrunkScreen(screen);
  if (std::getenv("VISCERA_UPDATE_PICTURES")) {
    fs::create_directories(reference.parent_path());
    ASSERT_TRUE(small.save(QString::fromStdString(reference.string()), "PNG", kSmallestFile)) << reference;
    return;
  }
  const QImage wanted(QString::fromStdString(reference.string()));
  ASSERT_EQ(small.size(), wanted.size()) << reference;
  EXPECT_LT(differentCells(small, wanted), kMostDifferentCells)
      << "compare " << drawn << " with " << reference;
}

} // namespace viscera::tests
