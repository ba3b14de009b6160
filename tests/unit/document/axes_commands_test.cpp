#include "viscera/document/axes_commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/plausible_size.h"

namespace viscera::document {
namespace {

using testing::HasSubstr;
using tests::ball;
using tests::row;

/// A liver to the right of a spleen, with handles, a pose, a recorded key and a measured point.
struct Patient : tests::Session {
  Patient() {
    undo.perform(removeAllOrgans());
    undo.perform(addOrgans({ball("liver", 72, 3, {-80, 10, 300}), ball("spleen", 36, 3, {90, 40, 310})}));
    undo.perform(moveHandles({handle(3)}, row(61, 62, -7)));
    undo.perform(recordKey(0.5));
    Measurement distance;
    distance.id = MeasurementId{900};
    distance.name = "Across";
    distance.points = {surfacePoint(*document.organs()[0], 5, {0.5, 0.3, 0.2}),
                       surfacePoint(*document.organs()[1], 7, {0.1, 0.2, 0.7})};
    DocumentState state = document.state();
    state.measurements = std::make_shared<const MeasurementList>(MeasurementList{distance});
    KeySequence keys = *state.keySequence;
    keys.corrections = {{4, 2, "liver", {Vec3(1, 2, 3)}}};
    state.keySequence = std::make_shared<const KeySequence>(std::move(keys));
    undo.reset(state);
  }

  Vec3 middle(std::size_t place) const { return boundsOf(document.organs()[place]->mesh->points).center(); }

  /// Measured points lie on the surfaces on which they were.
  void expectPointsOnSurfaces() const {
    for (const MeasuredPoint& point : document.measurements()[0].points) {
      const MeasuredPoint again =
          surfacePoint(*document.state().organ(point.organ), point.triangle, point.weights);
      EXPECT_LT((again.rest - point.rest).norm(), 1e-12 * (1e3 + point.rest.norm())); // Kilometres are large.
    }
  }
};

TEST(AxesCommands, FromRasToLpsTurnsOrgansHandlesKeysAndMeasurements) {
  Patient s;
  const DocumentState before = s.document.state();
  const Vec3 rest = s.document.rig().handles[3].rest;
  const Vec3 moved = s.document.keySequence().keys[0].displacements.begin()->second;
  s.undo.perform(convertCoordinates("ras-to-lps"));
  const Eigen::Matrix3d turn = Vec3(-1, -1, 1).asDiagonal();
  EXPECT_LT((s.middle(0) - Vec3(80, -10, 300)).norm(), 1e-9);
  EXPECT_EQ(s.document.rig().handles[3].rest, turn * rest);
  EXPECT_EQ(Vec3(s.document.pose().row(3).transpose()), Vec3(-61, -62, -7));
  EXPECT_EQ(s.document.keySequence().keys[0].displacements.begin()->second, turn * moved);
  EXPECT_TRUE(s.document.keySequence().corrections.empty()) << "they lie in the planes of the images";
  s.expectPointsOnSurfaces();
  const Organ& liver = *s.document.organs()[0];
  EXPECT_GT(geometry::volume(liver.mesh->points, liver.mesh->triangles), 0);
  EXPECT_THAT(inEnglish(liver.warnings), testing::Contains(HasSubstr("converted after the import")));
  EXPECT_TRUE(liver.origin.fileHash.empty()) << "a session has to hold it";
  s.undo.perform(convertCoordinates("ras-to-lps"));
  EXPECT_EQ(s.document.organs()[0]->mesh->points, before.organs->front()->mesh->points) << "to the last bit";
  s.undo.undo();
  s.undo.undo();
  EXPECT_TRUE(identical(s.document.state(), before));
}

TEST(AxesCommands, AMirrorImageFacesOutwardAndKeepsItsMeasuredPoints) {
  for (const char* mirror : {"mirror", "flip-y", "flip-z", "flip-xyz"}) {
    Patient s;
    const double volume = s.document.organs()[0]->restVolumeMm3;
    s.undo.perform(convertCoordinates(mirror));
    const Organ& liver = *s.document.organs()[0];
    EXPECT_NEAR(geometry::volume(liver.mesh->points, liver.mesh->triangles), volume, 1e-6) << mirror;
    EXPECT_NEAR(liver.restVolumeMm3, volume, 1e-6);
    s.expectPointsOnSurfaces();
  }
}

TEST(AxesCommands, AScaledPatientHasItsSizeAndNoRemarkOnTheOldOne) {
  tests::Session s;
  s.undo.perform(removeAllOrgans());
  NewOrgan small = ball("liver", 7.2);
  small.organ.warnings = {*medical_io::doubtAboutVolume("liver", small.organ.restVolumeMm3 / kMm3PerMl)};
  s.undo.perform(addOrgans({small}));
  s.undo.perform(scaleCoordinates(10));
  const Organ& liver = *s.document.organs()[0];
  EXPECT_NEAR(liver.restVolumeMm3, 1000 * small.organ.restVolumeMm3, 1);
  EXPECT_NEAR(s.document.rig().handles[0].rest.x(), -600, 1e-9);
  EXPECT_THAT(inEnglish(liver.warnings), testing::ElementsAre("scaled after the import by 10"));
  s.undo.perform(convertCoordinates("unit-cm"));
  EXPECT_NEAR(s.document.rig().handles[0].rest.x(), -6000, 1e-9);
  EXPECT_EQ(inEnglish(s.undo.names()).back(), "Convert the unit");
}

TEST(AxesCommands, EveryConversionOfTheImportIsThereAndNoOther) {
  const std::vector<std::string> ids = coordinateRepairs();
  EXPECT_THAT(ids, testing::IsSupersetOf({"ras-to-lps", "mirror", "y-up", "y-up-ras", "flip-z", "unit-m"}));
  for (const std::string& id : ids) {
    Patient s;
    s.undo.perform(convertCoordinates(id));
    s.expectPointsOnSurfaces();
  }
  EXPECT_THROW(convertCoordinates("remesh"), UsageError);
  EXPECT_THROW(convertCoordinates("LPS"), UsageError);
  EXPECT_THROW(scaleCoordinates(0), UsageError);
  EXPECT_THROW(scaleCoordinates(-1), UsageError);
  Document empty;
  UndoStack undo(empty);
  EXPECT_THROW(undo.perform(convertCoordinates("mirror")), UsageError);
}

} // namespace
} // namespace viscera::document
