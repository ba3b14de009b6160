#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <limits>

#include "phantom_scan.h"
#include "picture_check.h"
#include "session_fixture.h"
#include "viscera/document/scan_item.h"
#include "viscera/presentation/slice_presenter.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"

namespace viscera::presentation {
namespace {

using tests::expectLooksLikeReference;

/// A patient of whom no side is like another: a body with an organ of 30 mm, a bone in front to the left, air
/// to the right, a vessel towards the head.
double patient(const Vec3& p) {
  const auto within = [&p](const Vec3& center, const Vec3& radii) {
    return (p - center).cwiseQuotient(radii).norm() < 1;
  };
  if (within({45, -35, 0}, {9, 9, 60}))
    return 700;
  if (within({-62, 5, 0}, {14, 22, 40}))
    return -900;
  if (within({0, 0, 60}, {7, 7, 40}))
    return 220;
  if (within(Vec3::Zero(), Vec3::Constant(30)))
    return 110;
  return within({0, 0, 10}, {90, 62, 88}) ? 20 : -1000;
}

struct SlicedPatient : tests::BoundSession {
  ViewState view;
  live::LiveWarp warp{
      document, live, registry, jobs, {.refineSeconds = std::numeric_limits<double>::infinity()}};

  SlicedPatient() {
    undo.perform(document::openScan(document::scanItem(
        tests::phantomScan({100, 75, 70}, Vec3(2, 2, 3), Vec3(-99, -74, -95), patient), {})));
    view.scan.focus = Vec3(4, -6, 12);
  }
  vtkSmartPointer<vtkImageData> picture(int direction) {
    std::optional<Warping> warping;
    if (view.scan.warped) {
      warp.setWanted(true);
      box.runUntil([this] { return warp.map() != nullptr; });
      warping = warpingOf(warp);
    }
    SlicePresenter slices;
    slices.update({document.state(), live, view, warping ? &*warping : nullptr}, {{direction, 420, 320}});
    scene::SurfacelessWindow window(420, 320);
    scene::SliceView drawn;
    drawn.setWindow(window.window());
    drawn.show(slices.picture(direction));
    auto image = scene::grabPicture(window.window());
    drawn.setWindow(nullptr);
    return image;
  }
};

TEST(SlicePicture, IsWhatARadiologistExpectsOfEachDirection) {
  SlicedPatient patient;
  expectLooksLikeReference(patient.picture(0), "slice_axial");
  expectLooksLikeReference(patient.picture(1), "slice_coronal");
  expectLooksLikeReference(patient.picture(2), "slice_sagittal");
}

TEST(SlicePicture, BendsWithThePoseUnderTheContours) {
  SlicedPatient patient;
  patient.undo.perform(document::moveHandles({patient.handle(8)}, tests::row(16, -4, 62)));
  patient.view.scan.warped = true;
  expectLooksLikeReference(patient.picture(1), "slice_bent");
}

TEST(SlicePicture, IsHatchedWhereThePoseFoldsTheTissue) {
  SlicedPatient patient;
  patient.undo.perform(document::moveHandles({patient.handle(8)}, tests::row(0, 0, -70)));
  patient.view.scan.warped = true;
  expectLooksLikeReference(patient.picture(1), "slice_folded");
}

} // namespace
} // namespace viscera::presentation
