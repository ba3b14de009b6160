#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include "build_paths.h"
#include "viscera/scene/picture.h"

namespace viscera::tests {

/// The tolerance between a picture and its reference, because drivers differ in the last bits of colours and
/// in the pixels of edges.
inline constexpr double kMostDiffering = 0.006; ///< Part of the pixels.
inline constexpr double kMostMean = 1.0;        ///< Mean difference, of 255.

/// Compares with `<folder>/<name>.png`, docs/pictures for one that a page shows. What was drawn is left in
/// `pictures/` of the build folder. With VISCERA_UPDATE_PICTURES set in the environment it becomes the
/// reference instead: look at it before you commit it.
inline void expectLooksLikeReference(vtkImageData* picture, const std::string& name,
                                     const std::string& folder = "tests/image/reference") {
  namespace fs = std::filesystem;
  const fs::path reference = fs::path(VISCERA_SOURCE_DIR) / folder / (name + ".png");
  const fs::path drawn = fs::path(VISCERA_BINARY_DIR) / "pictures" / (name + ".png");
  fs::create_directories(drawn.parent_path());
  scene::writePng(drawn, picture);
  if (std::getenv("VISCERA_UPDATE_PICTURES")) {
    scene::writePng(reference, picture);
    return;
  }
  const auto difference = scene::comparePictures(picture, scene::readPng(reference));
  EXPECT_LT(difference.differing, kMostDiffering) << "compare " << drawn << " with " << reference;
  EXPECT_LT(difference.mean, kMostMean) << "compare " << drawn << " with " << reference;
}

} // namespace viscera::tests
