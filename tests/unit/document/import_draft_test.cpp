#include "viscera/document/import_draft.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/document/document.h"
#include "viscera/document/undo_stack.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::document {
namespace {

using geometry::TriangleMesh;

class ImportDrafts : public testing::Test {
protected:
  /// A ball of a normal liver's volume on the right side.
  static TriangleMesh liver() { return tests::sphere(3, 71.8, {-80, 10, 300}); }
  static TriangleMesh insideOut() {
    TriangleMesh mesh = liver();
    mesh.triangles.col(1).swap(mesh.triangles.col(2));
    return mesh;
  }

  static TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh both;
    both.points.resize(a.points.rows() + b.points.rows(), 3);
    both.points << a.points, b.points;
    both.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
    both.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.points.rows())).matrix();
    return both;
  }

  ImportDraft draft(const std::vector<std::pair<std::string, TriangleMesh>>& surfaces) {
    std::vector<std::filesystem::path> files;
    for (const auto& [name, mesh] : surfaces) {
      files.push_back(folder_ / name);
      medical_io::writeSurface(files.back(), mesh);
    }
    return draftOf(openFiles(files, progress_), progress_);
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(ImportDrafts, AGoodSurfaceIsNotQuestionable) {
  const ImportDraft good = draft({{"liver.ply", liver()}});
  EXPECT_FALSE(good.questionable());
  EXPECT_EQ(good.organs.at(0).file, "liver.ply");
  EXPECT_EQ(accepted(good).organs.at(0).organ.mesh->points, liver().points);
}

TEST_F(ImportDrafts, SeesASurfaceThatIsInsideOutAsItIsInTheFile) {
  const ImportDraft bad = draft({{"liver.ply", insideOut()}});
  ASSERT_TRUE(bad.questionable());
  const ImportDraft good = repaired(bad, {0}, "orient", progress_);
  EXPECT_FALSE(good.questionable());
  EXPECT_TRUE(bad.questionable()) << "a draft is a value";
  const OpenedFiles files = accepted(good);
  EXPECT_EQ(files.organs.at(0).organ.mesh->triangles.rows(), liver().triangles.rows());
  EXPECT_GT(files.organs.at(0).organ.restVolumeMm3, 0);
  EXPECT_THAT(inEnglish(files.organs.at(0).organ.warnings),
              testing::ElementsAre("repaired on import: orient"));
  EXPECT_EQ(files.organs.at(0).organ.file.filename(), "liver.ply");
}

TEST_F(ImportDrafts, RepairsAreTakenBackOneOrganAtATime) {
  ImportDraft both = draft({{"liver.ply", geometry::scaled(liver(), 0.001)}, {"spleen.ply", insideOut()}});
  both = repaired(both, {0}, "unit-m", progress_);
  both = repaired(both, {1}, "orient", progress_);
  both = reverted(both, 0, progress_);
  EXPECT_TRUE(both.organs[0].repairs.empty());
  EXPECT_TRUE(both.organs[0].assessment.questionable());
  EXPECT_THAT(both.organs[1].repairs, testing::ElementsAre("orient"));
}

TEST_F(ImportDrafts, AMirroredPatientIsNoticedByHowTheOrgansLie) {
  const TriangleMesh spleen = tests::sphere(3, 36, {90, 40, 300});
  const ImportDraft right = draft({{"liver.ply", liver()}, {"spleen.ply", spleen}});
  EXPECT_EQ(right.arrangement, std::nullopt);
  const ImportDraft wrong =
      draft({{"liver.ply", geometry::mirrored(liver())}, {"spleen.ply", geometry::mirrored(spleen)}});
  ASSERT_TRUE(wrong.arrangement);
  EXPECT_EQ(repaired(wrong, {0, 1}, "mirror", progress_).arrangement, std::nullopt);
  EXPECT_EQ(withIncluded(wrong, {1}, false).arrangement, std::nullopt);
}

TEST_F(ImportDrafts, WhatIsLeftOutDoesNotComeAndTheRestIsOneUndoStep) {
  ImportDraft both = draft({{"liver.ply", liver()}, {"bad.ply", geometry::scaled(liver(), 0.001)}});
  both = withIncluded(both, {1}, false);
  EXPECT_FALSE(both.questionable());
  Document document;
  UndoStack undo(document);
  undo.perform(accepted(both).command());
  ASSERT_EQ(document.organs().size(), 1u);
  EXPECT_EQ(document.organs()[0]->name, "liver");
  EXPECT_EQ(inEnglish(undo.names()), std::vector<std::string>{"Open 2 files"});
  EXPECT_TRUE(withIncluded(both, {0}, false).empty());
}

TEST_F(ImportDrafts, WhatIsWrongWithSeveralOrgansAlikeIsSaidOnce) {
  const TriangleMesh spleen = tests::sphere(3, 36, {90, 40, 300});
  TriangleMesh open = spleen;
  open.triangles = open.triangles.bottomRows(open.triangles.rows() - 9).eval();
  const ImportDraft two = draft({{"liver.ply", insideOut()}, {"a.ply", insideOut()}, {"spleen.ply", open}});
  const auto shared = sharedFindings(two);
  ASSERT_EQ(shared.size(), 1u) << "one organ alone is not a crowd";
  EXPECT_EQ(shared[0].subject, medical_io::FindingSubject::facing);
  EXPECT_EQ(shared[0].severity, medical_io::FindingSeverity::fault);
  EXPECT_THAT(shared[0].organs, testing::ElementsAre(0, 1));
  EXPECT_THAT(shared[0].repairable, testing::ElementsAre(0, 1));
  EXPECT_THAT(shared[0].repairs, testing::ElementsAre("orient"));
  EXPECT_TRUE(sharedFindings(withIncluded(two, {1}, false)).empty()) << "what is left out does not count";
  EXPECT_TRUE(sharedFindings(repaired(two, shared[0].repairable, "orient", progress_)).empty());
}

TEST_F(ImportDrafts, TheUnitOfLengthIsOneForAPatient) {
  const TriangleMesh spleen = tests::sphere(3, 36, {90, 40, 300});
  // 0.9 m across: as a thing of no name it could well be 900 mm.
  const TriangleMesh body = tests::sphere(2, 450, {0, 0, 200});
  const auto metres = [](const TriangleMesh& mesh) { return geometry::scaled(mesh, 0.001); };
  const ImportDraft patient =
      draft({{"liver.ply", metres(liver())}, {"spleen.ply", metres(spleen)}, {"trunk.ply", metres(body)}});
  const auto shared = sharedFindings(patient);
  ASSERT_FALSE(shared.empty());
  ASSERT_EQ(shared[0].subject, medical_io::FindingSubject::size);
  EXPECT_THAT(shared[0].repairs, testing::ElementsAre("unit-m"));
  EXPECT_THAT(shared[0].repairable, testing::ElementsAre(0, 1, 2)) << "every surface of the patient";
  EXPECT_TRUE(shared[0].ofThePatient);
  const ImportDraft mended = repaired(patient, shared[0].repairable, "unit-m", progress_);
  EXPECT_TRUE(sharedFindings(mended).empty());
  EXPECT_NEAR(mended.organs[2].assessment.sizeMm.x(), 900, 1);

  // A label map states its unit: organs of a child are each of their own size.
  OpenedFiles child;
  for (const char* name : {"liver", "spleen"})
    child.organs.push_back({makeOrgan(name, tests::sphere(2, 12)), -1});
  const auto small = sharedFindings(draftOf(child, progress_));
  ASSERT_EQ(small.size(), 1u);
  EXPECT_FALSE(small[0].ofThePatient);
  EXPECT_TRUE(small[0].repairs.empty());

  const ImportDraft mixed = draft({{"liver.ply", metres(liver())},
                                   {"a.ply", metres(liver())},
                                   {"spleen.ply", spleen},
                                   {"b.ply", spleen},
                                   {"c.ply", spleen}});
  EXPECT_THAT(sharedFindings(mixed).at(0).repairable, testing::ElementsAre(0, 1))
      << "where most are of the right size only the others are in doubt";
}

TEST_F(ImportDrafts, ACavityComesWithTheOrganThatItIsIn) {
  OpenedFiles files;
  for (const double radius : {60.0, 50.0, 30.0})
    files.organs.push_back({makeOrgan("ball", tests::sphere(2, radius)), -1});
  files.organs[2].parentInBatch = 1;
  ImportDraft all = draftOf(files, progress_);
  const OpenedFiles later = accepted(withIncluded(all, {0}, false));
  ASSERT_EQ(later.organs.size(), 2u);
  EXPECT_EQ(later.organs[1].parentInBatch, 0);
  EXPECT_EQ(accepted(withIncluded(all, {1}, false)).organs.size(), 1u)
      << "without its organ a cavity is nothing";
}

TEST_F(ImportDrafts, SayWhatRemeshingHasChanged) {
  // A ball with a vessel of 1 mm, which the grid of the new surface does not see.
  const TriangleMesh ball = tests::sphere(3, 40), vessel = tests::sphere(2, 1, {0, 0, 60});
  const ImportDraft first = draft({{"liver.ply", together(ball, vessel)}});
  EXPECT_FALSE(first.organs[0].change);
  const ImportDraft anew = repaired(first, {0}, "remesh", progress_);
  const auto& change = anew.organs[0].change;
  ASSERT_TRUE(change);
  EXPECT_EQ(change->trianglesBefore, ball.triangles.rows() + vessel.triangles.rows());
  EXPECT_EQ(change->trianglesAfter, anew.organs[0].mesh->triangles.rows());
  EXPECT_NEAR(change->maximumMm, 21, 1) << "the far end of the lost vessel";
  EXPECT_LT(change->meanMm, 6);
  EXPECT_THAT(inEnglish(accepted(anew).organs.at(0).organ.warnings),
              testing::ElementsAre("repaired on import: remesh", testing::HasSubstr("triangles instead of"),
                                   testing::HasSubstr("remeshing lost a detail")));
  EXPECT_FALSE(repaired(anew, {0}, "mirror", progress_).organs[0].change) << "of the last repair";
  EXPECT_FALSE(reverted(anew, 0, progress_).organs[0].change);
}

TEST_F(ImportDrafts, ALostDetailIsAFindingUntilAFinerSurfaceHasIt) {
  TriangleMesh vessel = tests::sphere(3, 1.3, {0, 0, 0});
  vessel.points.col(0) += 12.7 * vessel.points.col(0).cwiseSign(); // A rod with round ends.
  vessel.points.rowwise() += Eigen::RowVector3d(52, 0, 0);
  const ImportDraft first = draft({{"liver.ply", together(tests::sphere(4, 40), vessel)}});
  const auto lost = [](const ImportDraft& draft) {
    const auto& all = draft.organs[0].assessment.findings;
    return std::find_if(all.begin(), all.end(),
                        [](const auto& f) { return f.subject == medical_io::FindingSubject::detail; });
  };
  ImportDraft anew = repaired(first, {0}, "remesh", progress_);
  ASSERT_NE(lost(anew), anew.organs[0].assessment.findings.end());
  EXPECT_TRUE(anew.questionable()) << "not \"No problems found\"";
  EXPECT_NE(lost(repaired(anew, {0}, "orient", progress_)),
            repaired(anew, {0}, "orient", progress_).organs[0].assessment.findings.end())
      << "another repair does not bring it back";
  int tries = 0;
  while (lost(anew) != anew.organs[0].assessment.findings.end() && !lost(anew)->repairs.empty() &&
         ++tries < 4)
    anew = repaired(anew, {0}, lost(anew)->repairs.front(), progress_);
  EXPECT_EQ(lost(anew), anew.organs[0].assessment.findings.end());
  EXPECT_EQ(anew.organs[0].repairs.size(), 1u) << "each begins with the surface as it was read";
}

TEST_F(ImportDrafts, ASizeThatNoUnitExplainsIsScaledToLifeSize) {
  const ImportDraft first = draft({{"stomach.ply", tests::sphere(4, 1350)}});
  const auto& findings = first.organs[0].assessment.findings;
  const auto size = std::find_if(findings.begin(), findings.end(),
                                 [](const auto& f) { return f.subject == medical_io::FindingSubject::size; });
  ASSERT_EQ(size->repairs.size(), 2u);
  EXPECT_EQ(size->repairs[1], "scale");
  const ImportDraft scaled = repaired(first, {0}, size->repairs[0], progress_);
  EXPECT_NEAR(scaled.organs[0].assessment.volumeMl, 895, 10) << "the middle of the range after a meal";
}

TEST_F(ImportDrafts, AnOrganThatCannotBeRepairedStaysAndTheOthersAreRepaired) {
  // Crumbs that lie far apart are smaller than what remeshing resolves.
  const TriangleMesh crumbs = together(tests::sphere(2, 1.2), tests::sphere(2, 1, {0, 160, 0}));
  const ImportDraft read = draft({{"crumbs.ply", crumbs}, {"liver.ply", liver()}});
  const ImportDraft tried = repaired(read, {0, 1}, "remesh", progress_);
  ASSERT_TRUE(tried.organs[0].refusal);
  EXPECT_EQ(tried.organs[0].refusal->where().english(), "crumbs");
  EXPECT_EQ(tried.organs[0].refusal->problem().english(),
            "Every piece of the surface is smaller than the 6.5 mm that remeshing resolves");
  EXPECT_EQ(tried.organs[0].refusal->tryThis().english(), "keep the largest piece first");
  EXPECT_EQ(tried.organs[0].mesh, read.organs[0].mesh);
  EXPECT_THAT(tried.organs[0].repairs, testing::IsEmpty());
  EXPECT_FALSE(tried.organs[1].refusal);
  EXPECT_THAT(tried.organs[1].repairs, testing::ElementsAre("remesh"));

  EXPECT_FALSE(reverted(tried, 0, progress_).organs[0].refusal);
  const ImportDraft one = repaired(tried, {0}, "keep-largest", progress_);
  EXPECT_FALSE(one.organs[0].refusal) << "of the last repair";
  EXPECT_THAT(repaired(one, {0}, "remesh", progress_).organs[0].repairs,
              testing::ElementsAre("keep-largest", "remesh"))
      << "the advice helps";
}

TEST_F(ImportDrafts, ARepairCanBeCancelledAndAnUnknownOneIsRefused) {
  const ImportDraft bad = draft({{"liver.ply", insideOut()}});
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(repaired(bad, {0}, "remesh", cancelled), Cancelled);
  EXPECT_THROW(repaired(bad, {0}, "magic", progress_), UsageError);
}

} // namespace
} // namespace viscera::document
