#include <array>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include "viscera/scene/legend.h"

#include "measured_beat.h"
#include "picture_check.h"
#include "view_fixture.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using tests::MeasuredBeat;

constexpr double kWallOpacity = 0.3;
constexpr double kMostMm = 2; ///< The end of the colours of distances.

/// A heart with a transparent wall and its ventricles.
vtkSmartPointer<vtkImageData> drawn(const std::array<TriangleMesh, 3>& surfaces,
                                    const std::vector<Values>& apart = {}) {
  tests::ViewInWindow window(420, 360);
  window.view.setTheme(scene::lightTheme());
  const std::array<Vec3, 3> colors = {Vec3(0.80, 0.46, 0.42), Vec3(0.81, 0.23, 0.20), Vec3(0.29, 0.40, 0.72)};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    auto organ = window.addOrgan(surfaces[i]);
    organ->setColor(colors[i]);
    if (i == 0)
      organ->setOpacity(kWallOpacity);
    if (!apart.empty())
      organ->showScalars(std::make_shared<const Values>(apart[i]), scene::viridis(), {0, kMostMm});
  }
  if (!apart.empty())
    window.view.legend().show("Distance", "mm", scene::viridis(), {0, kMostMm});
  window.view.lookFrom(scene::StandardView::anterior);
  window.view.frame();
  window.view.renderer()->GetActiveCamera()->Zoom(0.9); // Room for the scale.
  return scene::grabPicture(window.surface.window());
}

/// docs/pictures/measured_heart.png: the sample heart's own beat, given as voxels of 1.5 x 1.5 x 8 mm, beside
/// what comes back of it, in the phases in which the left ventricle holds most and least.
TEST(MeasuredHeart, LooksLikeTheHeartThatItsVoxelsWereMadeOf) {
  constexpr std::size_t kPhases = 6;
  const MeasuredBeat beat(kPhases, sample_organs::Resolution::low);
  Progress progress;
  const PatientMotion found = trackMotion(beat.voxels({1.5, 1.5, 8}), {}, progress);
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  std::array<std::size_t, 2> fullAndEmpty{};
  for (std::size_t phase = 1; phase < kPhases; ++phase) {
    if (beat.trueMl(phase, 1) > beat.trueMl(fullAndEmpty[0], 1))
      fullAndEmpty[0] = phase;
    if (beat.trueMl(phase, 1) < beat.trueMl(fullAndEmpty[1], 1))
      fullAndEmpty[1] = phase;
  }
  for (const std::size_t phase : fullAndEmpty) {
    std::array<TriangleMesh, 3> truth, back;
    std::vector<Values> apart;
    for (std::size_t surface = 0; surface < truth.size(); ++surface) {
      truth[surface] = beat.truth[surface].at(phase);
      back[surface] = *found.sequence.organs[surface].mesh;
      back[surface].points = MeasuredBeat::foundAt(found, surface, phase);
      apart.push_back(beat.apartMm(back[surface].points, surface, phase));
    }
    pictures.push_back(drawn(truth));
    pictures.push_back(drawn(back));
    pictures.push_back(drawn(back, apart));
  }
  tests::expectLooksLikeReference(scene::contactSheet(pictures, 3), "measured_heart", "docs/pictures");
}

} // namespace
} // namespace viscera::live
