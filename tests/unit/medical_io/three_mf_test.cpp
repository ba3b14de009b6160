#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/surface_file.h"
#include "zip_files.h"

namespace viscera::medical_io {
namespace {

using test::warnsOf;
using testing::HasSubstr;
using tests::TemporaryFolder;
using tests::zipFile;

constexpr auto kPackageRelations =
    R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
    R"(<Relationship Type="http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail" )"
    R"(Target="/Metadata/thumbnail.png" Id="rel-2"/>)"
    R"(<Relationship Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" )"
    R"(Target="/3D/organs.model" Id="rel-1"/></Relationships>)";

/// The mesh of a box of that many units.
std::string boxMesh(double x, double y, double z, const std::string& lookOfTriangles = {}) {
  const geometry::TriangleMesh mesh = tests::box(x, y, z);
  std::string text = "<mesh><vertices>";
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    text += "<vertex x=\"" + std::to_string(mesh.points(v, 0)) + "\" y=\"" +
            std::to_string(mesh.points(v, 1)) + "\" z=\"" + std::to_string(mesh.points(v, 2)) + "\"/>";
  text += "</vertices><triangles>";
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    text += "<triangle v1=\"" + std::to_string(mesh.triangles(t, 0)) + "\" v2=\"" +
            std::to_string(mesh.triangles(t, 1)) + "\" v3=\"" + std::to_string(mesh.triangles(t, 2)) + "\"" +
            lookOfTriangles + "/>";
  return text + "</triangles></mesh>";
}

std::string objectXml(int id, const std::string& more, const std::string& contents) {
  return "<object id=\"" + std::to_string(id) + "\" type=\"model\" " + more + ">" + contents + "</object>";
}

std::string modelXml(const std::string& resources, const std::string& build,
                     const std::string& unit = "millimeter") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><model unit=\"" + unit +
         "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

/// A whole package, as slicers write it.
std::string packageOf(const std::string& text) {
  return zipFile(
      {{"[Content_Types].xml", "<Types/>"}, {"_rels/.rels", kPackageRelations}, {"3D/organs.model", text}});
}

/// The model alone.
std::string bareModel(const std::string& text) {
  return zipFile({{"3D/3dmodel.model", text, false}});
}

double volumeOfSurface(const SurfaceFile& surface) {
  return geometry::volume(surface.mesh.points, surface.mesh.triangles);
}

std::string problemOfThreeMf(const std::string& bytes, const std::string& name = "a.3mf") {
  const TemporaryFolder folder;
  const auto file = folder.put(name, bytes);
  try {
    readSurface(file);
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string()));
    return error.problem().english();
  }
  ADD_FAILURE() << "it was read";
  return {};
}

TEST(ThreeMf, SeveralObjectsAreSeveralOrgansWithNamesAndColours) {
  const TemporaryFolder folder;
  const std::string resources =
      R"(<basematerials id="1"><base name="red" displaycolor="#FF0000"/><base name="b" displaycolor="#0080FF80"/>)"
      R"(</basematerials><m:colorgroup id="2"><m:color color="#00FF00"/><m:color color="#FFFFFF"/></m:colorgroup>)" +
      objectXml(3, R"(name="Liver &amp; more" pid="1" pindex="0")", boxMesh(60, 50, 40)) +
      objectXml(4, R"(name="Gallbladder" pid="1" pindex="1")", boxMesh(10, 20, 30)) +
      objectXml(5, R"(name="Spleen")", boxMesh(10, 10, 10, R"( pid="2" p1="0")")) +
      objectXml(6, R"(partnumber="Kidney" pid="2" pindex="1")", boxMesh(20, 20, 20));
  const auto file = folder.put(
      "organs.3mf",
      packageOf(modelXml(resources, R"(<item objectid="3"/><item objectid="4" )"
                                    R"(transform="1 0 0 0 1 0 0 0 1 100 0 0"/><item objectid="5"/>)"
                                    R"(<item objectid="6"/>)")));
  const std::vector<SurfacePart> parts = readSurfaces(file);
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts[0].surface.name, "Liver & more");
  EXPECT_EQ(parts[0].color, Vec3(1, 0, 0));
  EXPECT_NEAR(volumeOfSurface(parts[0].surface), 120'000, 1e-6);
  EXPECT_EQ(parts[1].surface.name, "Gallbladder");
  EXPECT_EQ(parts[1].color, Vec3(0, 128 / 255.0, 1));
  EXPECT_NEAR(parts[1].opacity, 128 / 255.0, 1e-12);
  EXPECT_EQ(boundsOf(parts[1].surface.mesh.points).low, Vec3(100, 0, 0));
  EXPECT_EQ(parts[2].color, Vec3(0, 1, 0));
  EXPECT_EQ(parts[3].surface.name, "Kidney");
  EXPECT_EQ(parts[3].color, Vec3(1, 1, 1));
  EXPECT_TRUE(parts[0].surface.report.closed());
  EXPECT_EQ(readSurfacePart(file, "gallbladder").surface.name, "Gallbladder");
  EXPECT_THROW(readSurface(file), UsageError);
  const SurfaceFile all = readSurface(file, SeveralOrgans::join);
  EXPECT_NEAR(volumeOfSurface(all), 120'000 + 6'000 + 1'000 + 8'000, 1e-6);
}

TEST(ThreeMf, ComponentsAreMovedAndMirroredAndNamedAfterTheirAssembly) {
  const TemporaryFolder folder;
  const std::string resources =
      objectXml(1, "", boxMesh(10, 20, 30)) + objectXml(2, R"(name="Cyst")", boxMesh(2, 2, 2)) +
      objectXml(3, R"(name="Kidney")",
                R"(<components><component objectid="1" transform="0 1 0 -1 0 0 0 0 1 5 0 0"/>)"
                R"(<component objectid="2" transform="-1 0 0 0 1 0 0 0 1 0 0 7"/></components>)");
  const std::vector<SurfacePart> parts = readSurfaces(folder.put(
      "a.3mf",
      bareModel(modelXml(resources, R"(<item objectid="3" transform="2 0 0 0 2 0 0 0 2 0 0 1"/>)"))));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].surface.name, "Kidney");
  EXPECT_EQ(parts[1].surface.name, "Cyst");
  // (x, y, z) becomes (-y + 5, x, z) within the assembly, then twice of it and 1 up.
  EXPECT_EQ(boundsOf(parts[0].surface.mesh.points).low, Vec3(-30, 0, 1));
  EXPECT_EQ(boundsOf(parts[0].surface.mesh.points).high, Vec3(10, 20, 61));
  EXPECT_NEAR(volumeOfSurface(parts[0].surface), 8 * 6'000, 1e-6);
  EXPECT_NEAR(volumeOfSurface(parts[1].surface), 8 * 8, 1e-6) << "outward though mirrored";
  EXPECT_EQ(boundsOf(parts[1].surface.mesh.points).low, Vec3(-4, 0, 15));
}

TEST(ThreeMf, UnitsBecomeMillimetres) {
  const TemporaryFolder folder;
  for (const auto& [unit, mm] : std::vector<std::pair<std::string, double>>{{"micron", 1e-3},
                                                                            {"millimeter", 1},
                                                                            {"centimeter", 10},
                                                                            {"inch", 25.4},
                                                                            {"foot", 304.8},
                                                                            {"meter", 1e3}}) {
    const SurfaceFile read = readSurface(folder.put(
        "a.3mf", packageOf(modelXml(objectXml(1, "", boxMesh(1, 2, 3)), R"(<item objectid="1"/>)", unit))));
    EXPECT_NEAR(boundsOf(read.mesh.points).high.y(), 2 * mm, 1e-12 * mm) << unit;
    EXPECT_EQ(warnsOf(read, "converted from " + unit + " to mm"), mm != 1) << unit;
  }
  EXPECT_TRUE(warnsOf(
      readSurface(folder.put("a.3mf", packageOf(modelXml(objectXml(1, "", boxMesh(1, 2, 3)), "", "ell")))),
      "\"ell\""));
}

TEST(ThreeMf, AFileThatPlacesNothingIsReadWhole) {
  const TemporaryFolder folder;
  const std::vector<SurfacePart> parts = readSurfaces(folder.put(
      "liver.3mf",
      bareModel(modelXml(objectXml(7, "", boxMesh(60, 50, 40)) + objectXml(8, "", boxMesh(1, 1, 1)), ""))));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].surface.name, "Object 1");
  EXPECT_EQ(parts[1].surface.name, "Object 2");
  const std::vector<SurfacePart> one =
      readSurfaces(folder.put("liver.3mf", bareModel(modelXml(objectXml(7, "", boxMesh(60, 50, 40)), ""))));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].surface.name, "liver");
}

TEST(ThreeMf, WhatIsNotPlacedAndWhatOnlySupportsIsSaid) {
  const TemporaryFolder folder;
  const std::string resources = objectXml(1, R"(name="Liver")", boxMesh(60, 50, 40)) +
                                objectXml(2, R"(name="Draft")", boxMesh(1, 1, 1)) +
                                R"(<object id="3" type="support">)" + boxMesh(1, 1, 1) + "</object>";
  const std::vector<SurfacePart> parts = readSurfaces(
      folder.put("a.3mf", packageOf(modelXml(resources, R"(<item objectid="1"/><item objectid="3"/>)"))));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(warnsOf(parts[0].surface, "1 object that the file does not place is left out"));
  EXPECT_TRUE(warnsOf(parts[0].surface, "1 object that only supports a print is left out"));
}

TEST(ThreeMf, ModelsInOtherPartsOfThePackageAreFound) {
  const TemporaryFolder folder;
  const std::string root =
      modelXml(objectXml(2, R"(name="Liver")",
                         R"(<components><component p:path="/3D/Objects/object_1.model" )"
                         R"(objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 9"/></components>)"),
               R"(<item objectid="2"/>)");
  const std::string bytes =
      zipFile({{"Metadata/thumbnail.png", std::string(9000, 'x')},
               {"_rels/.rels", kPackageRelations},
               {"3D/organs.model", root},
               {"3D\\Objects\\Object_1.model", modelXml(objectXml(1, "", boxMesh(60, 50, 40)), "")}},
              "written by a slicer");
  const SurfaceFile read = readSurface(folder.put("a.3mf", bytes));
  EXPECT_EQ(read.name, "Liver");
  EXPECT_EQ(boundsOf(read.mesh.points).low.z(), 9);
  EXPECT_THAT(problemOfThreeMf(packageOf(root)), HasSubstr("\"/3D/Objects/object_1.model\" is missing"));
}

TEST(ThreeMf, VolumesOfPrusaSlicerAreOrgans) {
  const TemporaryFolder folder;
  // Two boxes of twelve triangles, and one that only changes the print, in one mesh.
  std::string points, triangles;
  for (int piece = 0; piece < 3; ++piece) {
    const std::string one = boxMesh(10 * (piece + 1), 10, 10);
    points += one.substr(one.find("<vertex "), one.find("</vertices>") - one.find("<vertex "));
    const geometry::TriangleMesh box = tests::box();
    for (Eigen::Index t = 0; t < box.triangles.rows(); ++t) {
      triangles += "<triangle";
      for (int k = 0; k < 3; ++k)
        triangles +=
            " v" + std::to_string(k + 1) + "=\"" + std::to_string(box.triangles(t, k) + 8 * piece) + "\"";
      triangles += "/>";
    }
  }
  const std::string root = modelXml(
      objectXml(1, "",
                "<mesh><vertices>" + points + "</vertices><triangles>" + triangles + "</triangles></mesh>"),
      R"(<item objectid="1"/>)");
  const auto settings = [](int lastOfSecond) {
    return R"(<config><object id="1"><metadata type="object" key="name" value="Abdomen"/>)"
           R"(<volume firstid="0" lastid="11"><metadata type="volume" key="name" value="Liver"/></volume>)"
           R"(<volume firstid="12" lastid=")" +
           std::to_string(lastOfSecond) +
           R"("><metadata type="volume" key="name" value="Gallbladder"/></volume><volume firstid="24" lastid="35">)"
           R"(<metadata type="volume" key="volume_type" value="ParameterModifier"/></volume></object></config>)";
  };
  const auto read = [&](const std::string& config) {
    return readSurfaces(folder.put(
        "a.3mf", zipFile({{"3D/3dmodel.model", root}, {"Metadata/Slic3r_PE_model.config", config}})));
  };
  const std::vector<SurfacePart> parts = read(settings(23));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].surface.name, "Liver");
  EXPECT_NEAR(volumeOfSurface(parts[0].surface), 1000, 1e-9);
  EXPECT_EQ(parts[1].surface.name, "Gallbladder");
  EXPECT_NEAR(volumeOfSurface(parts[1].surface), 2000, 1e-9);
  EXPECT_EQ(parts[1].surface.mesh.points.rows(), 8);
  EXPECT_FALSE(warnsOf(parts[1].surface, "without a triangle"));
  EXPECT_TRUE(warnsOf(parts[0].surface, "only supports a print"));
  for (const std::string& odd : {settings(22), settings(99), std::string("<config>"), std::string("x")}) {
    const std::vector<SurfacePart> whole = read(odd);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_NEAR(volumeOfSurface(whole[0].surface), 6000, 1e-9);
  }
}

TEST(ThreeMf, PartsOfBambuStudioHaveTheNamesOfItsSettings) {
  const TemporaryFolder folder;
  const std::string root =
      modelXml(objectXml(3, "",
                         R"(<components><component p:path="/3D/Objects/object_1.model" objectid="1"/>)"
                         R"(<component p:path="/3D/Objects/object_1.model" objectid="2"/></components>)"),
               R"(<item objectid="3"/>)");
  const std::string parts =
      modelXml(objectXml(1, "", boxMesh(10, 10, 10)) + objectXml(2, "", boxMesh(2, 2, 2)), "");
  const std::string settings =
      R"(<config><object id="3"><metadata key="name" value="organs.stl"/><part id="1" subtype="normal_part">)"
      R"(<metadata key="name" value="Liver"/></part><part id="2" subtype="support_blocker">)"
      R"(<metadata key="name" value="Cube"/></part></object></config>)";
  const std::vector<SurfacePart> read =
      readSurfaces(folder.put("a.3mf", zipFile({{"3D/3dmodel.model", root},
                                                {"3D/Objects/object_1.model", parts},
                                                {"Metadata/model_settings.config", settings}})));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].surface.name, "Liver");
}

TEST(ThreeMf, TrianglesOfSeveralColoursPaintTheirPoints) {
  const TemporaryFolder folder;
  std::string mesh = boxMesh(60, 50, 40);
  mesh.replace(mesh.find("/></triangles>"), 2, R"( pid="1" p1="1"/>)");
  const std::string resources =
      R"(<basematerials id="1"><base displaycolor="#FF0000"/><base displaycolor="#0000FF"/></basematerials>)" +
      objectXml(2, R"(pid="1" pindex="0")", mesh);
  const std::vector<SurfacePart> parts =
      readSurfaces(folder.put("a.3mf", packageOf(modelXml(resources, ""))));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_FALSE(parts[0].color);
  ASSERT_EQ(parts[0].surface.mesh.colors.rows(), 8);
  EXPECT_EQ(parts[0].surface.mesh.colors(0, 0), 255);
}

TEST(ThreeMf, WhatIsDamagedOrNoModelIsRefusedWithAReason) {
  const std::string good =
      packageOf(modelXml(objectXml(1, "", boxMesh(60, 50, 40)), R"(<item objectid="1"/>)"));
  EXPECT_THAT(problemOfThreeMf(good.substr(0, good.size() / 2)), HasSubstr("cut off"));
  EXPECT_THAT(problemOfThreeMf(zipFile({{"word/document.xml", "<w/>"}})),
              HasSubstr("ZIP archive without a 3D model"));
  EXPECT_THAT(problemOfThreeMf("PK\x03\x04"), HasSubstr("cut off"));
  const auto withMesh = [](const std::string& mesh) {
    return bareModel(modelXml(objectXml(1, "", mesh), ""));
  };
  std::string mesh = boxMesh(1, 2, 3);
  mesh.replace(mesh.find("v1=\"0\""), 6, "v1=\"8\"");
  EXPECT_THAT(problemOfThreeMf(withMesh(mesh)), HasSubstr("triangle 0 refers to point 8, but there are 8"));
  mesh.replace(mesh.find("v1=\"8\""), 6, "v1=\"x\"");
  EXPECT_THAT(problemOfThreeMf(withMesh(mesh)), HasSubstr("number of a point"));
  mesh.replace(mesh.find("v1=\"x\""), 6, "v1=\"-1\"");
  EXPECT_THAT(problemOfThreeMf(withMesh(mesh)), HasSubstr("point -1"));
  EXPECT_THAT(problemOfThreeMf(withMesh("<mesh><vertices/><triangles/></mesh>")), HasSubstr("no triangles"));
  EXPECT_THAT(problemOfThreeMf(bareModel("<model><resources>")), HasSubstr("damaged"));
  EXPECT_THAT(
      problemOfThreeMf(bareModel(modelXml(objectXml(1, "", boxMesh(1, 1, 1)), R"(<item objectid="4"/>)"))),
      HasSubstr("no object \"4\""));
  EXPECT_THAT(
      problemOfThreeMf(bareModel(modelXml(objectXml(1, "", boxMesh(1, 1, 1)) + objectXml(1, "", ""), ""))),
      HasSubstr("two objects"));
  EXPECT_THAT(problemOfThreeMf(bareModel(
                  modelXml(objectXml(1, "", boxMesh(1, 1, 1)), R"(<item objectid="1" transform="1 0 0"/>)"))),
              HasSubstr("twelve numbers"));
  std::string changed =
      zipFile({{"3D/3dmodel.model", modelXml(objectXml(1, "", boxMesh(60, 50, 40)), ""), false}});
  changed.replace(changed.find("x=\"60."), 6, "x=\"61.");
  EXPECT_THAT(problemOfThreeMf(changed), HasSubstr("checksum"));
  EXPECT_THAT(problemOfThreeMf(zipFile({{"3D/3dmodel.model", "<model/>", true, 1}})), HasSubstr("encrypted"));
  EXPECT_THAT(problemOfThreeMf(zipFile({{"3D/3dmodel.model", "<model/>", true, 0, 12}})),
              HasSubstr("method 12"));
}

TEST(ThreeMf, ArchivesAndScenesThatUnfoldWithoutEndAreRefused) {
  EXPECT_THAT(problemOfThreeMf(
                  zipFile({{"3D/3dmodel.model", "<model>" + std::string(20'000'000, ' ') + "</model>"}})),
              HasSubstr("would unpack from"));
  EXPECT_THAT(problemOfThreeMf(zipFile({{"3D/3dmodel.model", "<model/>", true, 0, 0, 4'000'000'000}})),
              HasSubstr("would unpack from"));
  EXPECT_THAT(problemOfThreeMf(zipFile({{"3D/3dmodel.model", "<model/>", true, 0, 0, 9}})),
              HasSubstr("packed data"));
  // An object in itself, and objects that double with every level.
  EXPECT_THAT(problemOfThreeMf(bareModel(
                  modelXml(objectXml(1, "", R"(<components><component objectid="1"/></components>)"),
                           R"(<item objectid="1"/>)"))),
              HasSubstr("too many"));
  std::string resources = objectXml(1, "", boxMesh(1, 1, 1));
  for (int id = 2; id < 40; ++id) {
    const std::string use = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    resources += objectXml(id, "", "<components>" + use + use + "</components>");
  }
  EXPECT_THAT(problemOfThreeMf(bareModel(modelXml(resources, R"(<item objectid="39"/>)"))),
              HasSubstr("too many"));
}

TEST(ThreeMf, ItsKindIsToldByItsContents) {
  const TemporaryFolder folder;
  const std::string bytes =
      packageOf(modelXml(objectXml(1, "", boxMesh(60, 50, 40)), R"(<item objectid="1"/>)"));
  EXPECT_EQ(fileKind(folder.put("a.3mf", bytes)), FileKind::surface);
  EXPECT_EQ(fileKind(folder.put("a.zip", bareModel(modelXml("", "")))), FileKind::surface);
  EXPECT_EQ(fileKind(folder.put("b.zip", zipFile({{"a.txt", "text"}}))), FileKind::unknown);
  EXPECT_THAT(problemOfThreeMf(bareModel(modelXml("", "")), "a.stl"), HasSubstr("looks like 3MF"));
}

TEST(WriteThreeMf, KeepsEveryBitNameAxesAndColours) {
  const TemporaryFolder folder;
  const geometry::TriangleMesh mesh = test::organ();
  writeSurface(folder / "a.3mf", mesh, {Space::ras, "Liver <left> & \"right\""});
  const SurfaceFile read = readSurface(folder / "a.3mf");
  EXPECT_EQ(read.name, "Liver <left> & \"right\"");
  EXPECT_TRUE(read.spaceStated);
  EXPECT_EQ(read.space, Space::ras);
  EXPECT_EQ(read.mesh.points, mesh.points);
  EXPECT_EQ(read.mesh.triangles, mesh.triangles);
  EXPECT_EQ(read.mesh.colors, mesh.colors);
  writeSurface(folder / "b.3mf", mesh, {Space::ras, "Liver <left> & \"right\""});
  EXPECT_EQ(tests::contentsOf(folder / "a.3mf"), tests::contentsOf(folder / "b.3mf"));
}

std::shared_ptr<const geometry::TriangleMesh> ballAt(double radius, const Vec3& center) {
  return std::make_shared<const geometry::TriangleMesh>(tests::sphere(3, radius, center));
}

TEST(WriteThreeMf, CavitiesAreHollowInTheObjectOfTheirOrgan) {
  const TemporaryFolder folder;
  const auto outer = ballAt(50, {0, 0, 0}), left = ballAt(15, {20, 0, 0}), right = ballAt(10, {-20, 0, 0});
  auto turned = std::make_shared<geometry::TriangleMesh>(*right);
  turned->triangles.col(1).swap(turned->triangles.col(2)); // A cavity may already be inward.
  const auto stone = ballAt(3, {20, 0, 0}), spleen = ballAt(20, {200, 0, 0});
  writeSurfaces(folder / "heart.3mf", {{outer, "Heart", {0.8, 0.2, 0.2}, 1, -1},
                                       {left, "LV", {1, 0, 0}, 1, 0},
                                       {turned, "RV", {0, 0, 1}, 1, 0},
                                       {stone, "Stone", {1, 1, 1}, 1, 1},
                                       {spleen, "Spleen", {0.4, 0, 0.4}, 0.5, -1}});
  const std::vector<SurfacePart> parts = readSurfaces(folder / "heart.3mf");
  ASSERT_EQ(parts.size(), 2U);
  const auto volume = [](const auto& mesh) { return geometry::volume(mesh->points, mesh->triangles); };
  EXPECT_EQ(parts[0].surface.name, "Heart");
  EXPECT_NEAR(volumeOfSurface(parts[0].surface), volume(outer) - volume(left) - volume(right) + volume(stone),
              1e-6);
  EXPECT_EQ(parts[0].surface.report.components, 4);
  EXPECT_TRUE(parts[0].surface.report.closed());
  EXPECT_EQ(parts[0].color, Vec3(204, 51, 51) / 255.0);
  EXPECT_EQ(parts[1].surface.name, "Spleen");
  EXPECT_NEAR(parts[1].opacity, 0.5, 0.003);
  EXPECT_THROW(writeSurfaces(folder / "a.3mf", {{left, "LV", {1, 0, 0}, 1, 1}, {outer, "Heart"}}), DataError);
  EXPECT_THROW(writeSurfaces(folder / "none.3mf", {}), DataError);
}

TEST(WriteThreeMf, OtherProgramsFindThePartsOfThePackage) {
  const TemporaryFolder folder;
  writeSurface(folder / "a.3mf", *ballAt(10, {0, 0, 0}), {Space::lps, "Ball"});
  const std::string bytes = tests::contentsOf(folder / "a.3mf");
  EXPECT_TRUE(bytes.starts_with("PK\x03\x04"));
  for (const char* part : {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"})
    EXPECT_THAT(bytes, HasSubstr(part));
}

} // namespace
} // namespace viscera::medical_io
