#include "viscera/document/open_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_slices.h"
#include "label_files.h"
#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::document {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A folder of its own for each test.
class OpenFiles : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("viscera_open_files_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path surface(const std::string& name, double radius) {
    medical_io::writeSurface(folder_ / name, viscera::tests::sphere(3, radius));
    return folder_ / name;
  }
  fs::path handles(const std::string& name, const std::vector<Vec3>& places) {
    medical_io::HandleFile file;
    file.groups.push_back({"Mine", {0, 0.5, 1}, {}});
    for (std::size_t i = 0; i < places.size(); ++i)
      file.groups[0].handles.push_back({"P" + std::to_string(i), places[i], "", i == 0, true});
    medical_io::writeHandles(folder_ / name, file);
    return folder_ / name;
  }
  static std::vector<Vec3> corners() {
    std::vector<Vec3> places;
    for (const NewHandle& handle : tests::cubeHandles())
      places.push_back(handle.rest);
    return places;
  }
  /// The message of what `openFiles` throws.
  template <class Expected>
  std::string refusal(const std::vector<fs::path>& files) {
    Progress progress;
    try {
      openFiles(files, progress);
    } catch (const Expected& error) {
      return error.what();
    }
    ADD_FAILURE() << "the files were opened";
    return {};
  }

  fs::path folder_;
};

TEST_F(OpenFiles, BringOrgansAndHandlesAsOneStep) {
  Document document;
  UndoStack undo(document);
  Progress progress;
  const OpenedFiles opened = openFiles(
      {surface("liver.vtp", 30), handles("rig.mrk.json", corners()), surface("kidney.stl", 20)}, progress);
  EXPECT_EQ(opened.organs.size(), 2u);
  EXPECT_EQ(opened.rig->handles.size(), 10u);
  EXPECT_TRUE(document.organs().empty()) << "reading alone must not change a document";
  undo.perform(opened.command());
  EXPECT_EQ(inEnglish(undo.names()), std::vector<std::string>{"Open 3 files"});
  ASSERT_EQ(document.organs().size(), 2u);
  EXPECT_EQ(document.organs()[1]->file.filename(), "kidney.stl");
  EXPECT_TRUE(document.organs()[0]->closed());
  const Rig& rig = document.rig();
  ASSERT_EQ(rig.handles.size(), 10u);
  EXPECT_EQ(rig.handles[0].label, "P0");
  EXPECT_TRUE(rig.handles[0].locked);
  ASSERT_EQ(rig.groups.size(), 1u);
  EXPECT_EQ(rig.groups[0].name, "Mine");
  EXPECT_EQ(rig.groups[0].handles.size(), 10u);
  undo.undo();
  EXPECT_TRUE(document.organs().empty());
  EXPECT_TRUE(document.rig().handles.empty());
}

TEST_F(OpenFiles, LeaveOutThoseThatFailAndSayWhich) {
  std::ofstream(folder_ / "empty.stl").close();
  Progress progress;
  const OpenedFiles opened =
      openFiles({folder_ / "missing.stl", surface("liver.vtp", 30), folder_ / "empty.stl",
                 folder_ / "notes.docx", surface("kidney.stl", 20)},
                progress);
  ASSERT_EQ(opened.organs.size(), 2u);
  EXPECT_EQ(opened.organs[1].organ.name, "kidney");
  EXPECT_TRUE(opened.surfaces.count(1) == 1) << "as it was read";
  std::vector<std::string> said;
  for (const Error& failure : opened.failures)
    said.emplace_back(failure.what());
  EXPECT_THAT(said, ::testing::ElementsAre(HasSubstr("missing.stl"), HasSubstr("empty.stl"),
                                           HasSubstr("notes.docx")));
  EXPECT_THAT(opened.leftOut,
              ::testing::ElementsAre(folder_ / "missing.stl", folder_ / "empty.stl", folder_ / "notes.docx"));
}

TEST_F(OpenFiles, SayNothingOfSessionsWhereNoneCanBeOpened) {
  Progress progress;
  const auto said = [&](const char* name) {
    try {
      openFiles({folder_ / name}, progress, {}, Sessions::nowhere);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_THAT(said("case.viscera"), HasSubstr("beside another"));
}

TEST_F(OpenFiles, ThrowWhatTheFirstThrowsWhenNothingIsLeft) {
  std::ofstream(folder_ / "empty.stl").close();
  EXPECT_THAT(refusal<DataError>({folder_ / "empty.stl", folder_ / "missing.stl"}), HasSubstr("empty.stl"));
  EXPECT_THAT(refusal<NoInputError>({folder_ / "missing.stl"}), HasSubstr("missing.stl"));
  std::ofstream(folder_ / "notes.docx") << "some bytes";
  EXPECT_THAT(refusal<DataError>({folder_ / "notes.docx"}),
              AllOf(HasSubstr("not supported"), HasSubstr("a document")));
  std::ofstream(folder_ / "notes.qqq") << "some bytes";
  EXPECT_THAT(refusal<DataError>({folder_ / "notes.qqq"}), HasSubstr("not supported"));
  EXPECT_THAT(refusal<UsageError>({folder_ / "case.viscera"}), HasSubstr("alone"));
  refusal<UsageError>({});
}

TEST_F(OpenFiles, TellAllThatFailedBesideAScan) {
  std::ofstream(folder_ / "empty.stl").close();
  Progress progress;
  tests::LabelImage image = tests::emptyLabels();
  image.voxels.front() = -1000;
  const auto scan = folder_ / "ct.nii";
  std::ofstream(scan, std::ios::binary) << tests::niftiFile(image);
  const OpenedFiles opened = openPatient({folder_ / "empty.stl", scan, folder_ / "missing.stl"}, progress);
  EXPECT_TRUE(opened.organs.empty());
  ASSERT_TRUE(opened.scan);
  ASSERT_EQ(opened.failures.size(), 2u);
  EXPECT_THAT(opened.failures[0].what(), HasSubstr("empty.stl"));
  EXPECT_THAT(opened.leftOut, ::testing::ElementsAre(folder_ / "empty.stl", folder_ / "missing.stl"));
}

TEST_F(OpenFiles, LeaveOutOneThatDoesNotFitIntoMemoryAndSayWhich) {
  Progress progress;
  const ArrivingOrganListener hungry = [](const ArrivingOrgan& organ) {
    if (organ.name == "liver")
      throw std::bad_alloc();
  };
  const OpenedFiles opened =
      openFiles({surface("liver.vtp", 30), surface("kidney.vtp", 20)}, progress, hungry);
  ASSERT_EQ(opened.organs.size(), 1u);
  EXPECT_EQ(opened.organs[0].organ.name, "kidney");
  ASSERT_EQ(opened.failures.size(), 1u);
  EXPECT_THAT(opened.failures[0].what(), AllOf(HasSubstr("liver.vtp"), HasSubstr("not enough memory")));
}

TEST_F(OpenFiles, LeaveOutASessionAndASecondHandleFileAmongOthers) {
  Progress progress;
  const OpenedFiles opened =
      openFiles({folder_ / "case.viscera", handles("a.mrk.json", corners()), surface("liver.vtp", 30),
                 handles("b.mrk.json", {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}})},
                progress);
  ASSERT_EQ(opened.organs.size(), 1u);
  ASSERT_TRUE(opened.rig);
  EXPECT_EQ(opened.rig->handles.size(), corners().size()) << "those of the first file";
  ASSERT_EQ(opened.failures.size(), 2u);
  EXPECT_THAT(opened.failures[0].what(), AllOf(HasSubstr("case.viscera"), HasSubstr("alone")));
  EXPECT_THAT(opened.failures[1].what(), AllOf(HasSubstr("b.mrk.json"), HasSubstr("Two handle files")));
}

TEST_F(OpenFiles, TakeTheSecondHandleFileWhereTheFirstCannotBeRead) {
  std::ofstream(folder_ / "empty.mrk.json").close();
  Progress progress;
  const OpenedFiles opened =
      openFiles({folder_ / "empty.mrk.json", handles("b.mrk.json", corners())}, progress);
  ASSERT_TRUE(opened.rig);
  ASSERT_EQ(opened.failures.size(), 1u);
  EXPECT_THAT(opened.failures[0].what(), HasSubstr("empty.mrk.json"));
}

TEST_F(OpenFiles, RefuseHandlesThatNothingCanBeBoundTo) {
  EXPECT_THAT(refusal<DataError>({handles("three.mrk.json", {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}})}),
              HasSubstr("three.mrk.json"));
  EXPECT_THAT(refusal<DataError>({handles("flat.mrk.json", {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {9, 9, 0}})}),
              HasSubstr("flat.mrk.json"));
  auto twice = corners();
  twice.push_back(twice[2]);
  EXPECT_THAT(refusal<DataError>({handles("twice.mrk.json", twice)}), HasSubstr("P2 and P10"));
}

TEST_F(OpenFiles, CallASurfaceAsItsFileWhereItsOwnNameSaysNothing) {
  const fs::path file = folder_ / "left_kidney.obj";
  const auto nameOf = [&](const std::string& object) {
    std::ofstream(file) << "o " << object << "\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
                        << "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    Progress progress;
    return openFiles({file}, progress).organs.front().organ.name;
  };
  for (const char* object : {"Mesh1", "default", "Object_1", "object", "42", "Untitled.003"})
    EXPECT_EQ(nameOf(object), "left_kidney") << object;
  for (const char* object : {"Spleen", "Mesh1_liver", "segment_4"})
    EXPECT_EQ(nameOf(object), object);
}

TEST_F(OpenFiles, TakeASinglePaintForTheOrgansOwnColour) {
  geometry::TriangleMesh mesh = viscera::tests::sphere(3, 30);
  mesh.colors = Colors::Constant(mesh.points.rows(), 3, 51);
  medical_io::writeSurface(folder_ / "plain.vtp", mesh);
  mesh.colors(7, 2) = 102;
  medical_io::writeSurface(folder_ / "spotted.vtp", mesh);
  Progress progress;
  const OpenedFiles opened =
      openFiles({folder_ / "plain.vtp", folder_ / "spotted.vtp", surface("bare.vtp", 30)}, progress);
  ASSERT_EQ(opened.organs.size(), 3u);
  EXPECT_FALSE(opened.organs[0].organ.look.vertexColors);
  EXPECT_LT((opened.organs[0].organ.look.color - Vec3::Constant(0.2)).norm(), 1e-9);
  EXPECT_TRUE(opened.organs[1].organ.look.vertexColors);
  EXPECT_EQ(opened.organs[2].organ.look, OrganLook());
}

TEST_F(OpenFiles, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(openFiles({surface("liver.vtp", 30)}, progress), Cancelled);
}

TEST_F(OpenFiles, WarnOnceOfEachFaultWithTheFilesName) {
  geometry::TriangleMesh mesh = viscera::tests::sphere(3, 0.05);
  mesh.triangles.col(0).swap(mesh.triangles.col(1));
  medical_io::writeSurface(folder_ / "odd.vtp", mesh);
  Progress progress;
  const OpenedFiles opened = openFiles({folder_ / "odd.vtp"}, progress);
  EXPECT_THAT(inEnglish(opened.warnings),
              ::testing::UnorderedElementsAre(HasSubstr("odd.vtp: the size of 0.173 mm is implausible"),
                                              HasSubstr("odd.vtp: the surface is inside out"),
                                              HasSubstr("turned around")));
}

TEST_F(OpenFiles, KeepHandlesInSeveralGroupsThroughAFile) {
  tests::Session s;
  s.undo.perform(addGroup("A", {1, 0, 0}, {s.handle(0), s.handle(1), s.handle(8)}));
  s.undo.perform(addGroup("B", {0, 1, 0}, {s.handle(1), s.handle(9)}));
  medical_io::writeHandles(folder_ / "rig.mrk.json", handleFile(s.document.rig()));
  const Rig back = rigFrom(medical_io::readHandles(folder_ / "rig.mrk.json"), "rig.mrk.json");
  ASSERT_EQ(back.handles.size(), 10u);
  ASSERT_EQ(back.groups.size(), 3u);
  EXPECT_EQ(back.groups[0].handles.size(), 3u);
  EXPECT_EQ(back.groups[1].handles.size(), 2u);
  EXPECT_EQ(back.groups[1].handles[0], back.groups[0].handles[1]) << "one handle, two groups";
  EXPECT_EQ(back.groups[2].name, "Handles");
  EXPECT_EQ(back.groups[2].handles.size(), 6u);
  for (const Handle& handle : back.handles) {
    const int row = s.document.rig().indexOf(handle.label);
    ASSERT_GE(row, 0) << handle.label;
    EXPECT_EQ(s.document.rig().handles[static_cast<std::size_t>(row)].rest, handle.rest);
  }
}

TEST(SampleOrgans, BecomeAnOrganWithItsCavities) {
  sample_organs::SampleOrgan heart;
  heart.name = "heart";
  for (const std::string name : {"outer", "lv", "rv"}) {
    const double radius = heart.surfaces.empty() ? 40 : 15;
    heart.surfaces.push_back(
        {name,
         std::make_shared<const geometry::TriangleMesh>(viscera::tests::sphere(2, radius)),
         {0.7, 0.2, 0.2},
         {}});
  }
  Document document;
  UndoStack undo(document);
  undo.perform(addOrgans(organsFrom(heart)));
  ASSERT_EQ(document.organs().size(), 3u);
  EXPECT_EQ(document.organs()[0]->name, "Heart");
  EXPECT_EQ(document.organs()[1]->name, "LV");
  EXPECT_EQ(document.organs()[2]->parent, document.organs()[0]->id);
  EXPECT_EQ(document.organs()[1]->look.color, Vec3(0.7, 0.2, 0.2));
}

/// Of a file one paint becomes the organ's colour; a sample's colour is that of the tissue around the blood.
TEST(SampleOrgans, ShowTheirPaintAlsoWhereItIsOneColour) {
  geometry::TriangleMesh blood = tests::sphere(1);
  blood.colors = Colors::Constant(blood.points.rows(), 3, 90);
  const sample_organs::SampleSurface surface{
      "lv", std::make_shared<const geometry::TriangleMesh>(blood), {0.7, 0.2, 0.2}, {}};
  EXPECT_FALSE(makeOrgan("lv", surface.mesh).look.vertexColors);
  const Organ organ = organFrom(surface, "lv");
  EXPECT_TRUE(organ.look.vertexColors);
  EXPECT_EQ(organ.look.color, Vec3(0.7, 0.2, 0.2));
}

TEST(SampleOrgans, WithNamesOfTheirOwnStandBesideTheFirst) {
  sample_organs::SampleOrgan system{"digestive_system", sample_organs::Resolution::low, {}};
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(tests::sphere(1));
  for (const std::string name : {"outer", "lumen", "liver"})
    system.surfaces.push_back({name, mesh, {0.7, 0.2, 0.2}, {}});
  system.surfaces[0].organ = "Stomach and bowel";
  system.surfaces[2].organ = "Liver";
  system.surfaces[2].hidden = true;
  const std::vector<NewOrgan> organs = organsFrom(system);
  ASSERT_EQ(organs.size(), 3U);
  EXPECT_EQ(organs[0].organ.name, "Stomach and bowel");
  EXPECT_EQ(organs[1].parentInBatch, 0) << "a cavity";
  EXPECT_EQ(organs[2].organ.name, "Liver");
  EXPECT_EQ(organs[2].parentInBatch, -1);
  EXPECT_EQ(organs[2].organ.origin.surface, "liver");
  EXPECT_TRUE(organs[0].organ.look.visible);
  EXPECT_FALSE(organs[2].organ.look.visible) << "hidden until it is switched on";
}

TEST_F(OpenFiles, GroupsOfASurfaceFileAreOrgansThatASessionHolds) {
  std::ofstream(folder_ / "a.mtl") << "newmtl m\nKd 1 0.5 0\nd 0.5\nnewmtl n\nKd 0 0 1\n";
  const std::string points = "v 0 0 0\nv 90 0 0\nv 0 90 0\nv 0 0 90\n";
  const std::string faces = "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n";
  std::ofstream(folder_ / "a.obj") << "mtllib a.mtl\ng Tissue_a\nusemtl m\n" + points + faces +
                                          "g Tissue_b\nusemtl n\nv 200 0 0\nv 230 0 0\nv 200 30 0\n"
                                          "v 200 0 30\n" +
                                          faces;
  Progress progress;
  const OpenedFiles opened = openFiles({folder_ / "a.obj"}, progress);
  ASSERT_EQ(opened.organs.size(), 2u);
  const Organ& first = opened.organs[0].organ;
  EXPECT_EQ(first.name, "Tissue_a");
  EXPECT_EQ(first.look.color, Vec3(1, 0.5, 0));
  EXPECT_EQ(first.look.opacity, 0.5);
  EXPECT_NEAR(first.restVolumeMm3, 90.0 * 90 * 90 / 6, 1e-6);
  EXPECT_EQ(first.origin.fileHash, "") << "the file alone does not give this organ";
  EXPECT_EQ(opened.surfaces.size(), 2u);
  EXPECT_THROW(readOrgan(folder_ / "a.obj"), UsageError);
  EXPECT_EQ(readOrgan(folder_ / "a.obj", medical_io::SeveralOrgans::join).mesh->triangles.rows(), 8);
  EXPECT_EQ(readOrgans(folder_ / "a.obj", "tissue b").front().organ.name, "Tissue_b");
}

/// A DICOM object with an STL file of one closed surface within, or of another class.
std::string dicomObject(const std::string& kind, const std::string& document) {
  return tests::dicomBytes({{0x00080016, "UI1.2.840.10008.5.1.4.1.1." + kind},
                            {0x00080018, "UI1.2.3.4"},
                            {0x00420010, "STLiver"},
                            {0x00420011, "OB" + document}});
}

TEST_F(OpenFiles, OpensADicomFileWithASurfaceAndNamesOtherKinds) {
  std::ifstream stl(surface("ball.stl", 40), std::ios::binary);
  const std::string document{std::istreambuf_iterator<char>(stl), std::istreambuf_iterator<char>()};
  std::ofstream(folder_ / "a.dcm", std::ios::binary) << dicomObject("104.3", document);
  Progress progress;
  const OpenedFiles opened = openFiles({folder_ / "a.dcm"}, progress);
  ASSERT_EQ(opened.organs.size(), 1U);
  EXPECT_EQ(opened.organs[0].organ.name, "Liver");
  std::ofstream(folder_ / "RP.1.2.3", std::ios::binary) << dicomObject("481.5", "");
  EXPECT_THAT(refusal<DataError>({folder_ / "RP.1.2.3"}), HasSubstr("RTPLAN"));
}

} // namespace
} // namespace viscera::document
