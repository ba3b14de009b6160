#include <cstring>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {
namespace {

using nlohmann::json;
using test::warnsOf;
using testing::HasSubstr;
using tests::TemporaryFolder;

/// The tetrahedron of 100 mm as float points and 16-bit indices: 48 + 24 bytes.
std::string tetrahedronBuffer() {
  std::string bytes;
  for (const float value : {0.F, 0.F, 0.F, 100.F, 0.F, 0.F, 0.F, 100.F, 0.F, 0.F, 0.F, 100.F}) {
    char raw[4];
    std::memcpy(raw, &value, 4);
    bytes.append(raw, 4);
  }
  for (const int index : {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3})
    bytes += {static_cast<char>(index), '\0'};
  return bytes;
}

/// A scene as another program would write it, its buffer beside it.
json tetrahedronScene() {
  return json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"name": "Apex", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
    "buffers": [{"byteLength": 72, "uri": "the%20buffer.bin"}]})");
}

SurfaceFile readScene(const json& scene) {
  const TemporaryFolder folder;
  folder.put("the buffer.bin", tetrahedronBuffer());
  return readSurface(folder.put("scene.gltf", scene.dump()));
}

std::vector<SurfacePart> readParts(const json& scene) {
  const TemporaryFolder folder;
  folder.put("the buffer.bin", tetrahedronBuffer());
  return readSurfaces(folder.put("scene.gltf", scene.dump()));
}

std::string problemOf(const json& scene) {
  try {
    readScene(scene);
  } catch (const DataError& error) {
    return error.problem().english();
  }
  ADD_FAILURE() << scene << " was read";
  return {};
}

TEST(Gltf, ReadsASceneWithItsBufferBesideIt) {
  const SurfaceFile read = readScene(tetrahedronScene());
  EXPECT_TRUE(geometry::checkSurface(read.mesh).outward());
  EXPECT_NEAR(geometry::checkSurface(read.mesh).volumeMm3, 1e6 / 6, 1e-6);
  EXPECT_EQ(read.name, "Apex");
  EXPECT_FALSE(read.spaceStated);
  EXPECT_TRUE(warnsOf(read, "glTF does not say which axes"));
}

TEST(Gltf, ReadsABufferWithinTheFile) {
  json scene = tetrahedronScene();
  scene["meshes"][0]["primitives"][0].erase("indices");
  scene["accessors"][0]["count"] = 3;
  // 36 zero bytes but for one coordinate each of two points.
  scene["buffers"][0] = {{"byteLength", 72},
                         {"uri", "data:application/octet-stream;base64,"
                                 "AAAAAAAAAAAAAAAAAADIQgAAAAAAAAAAAAAAAAAAyEIAAAAAAAAAAAAAAAAAAAAA"
                                 "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"}};
  const SurfaceFile read = readScene(scene);
  EXPECT_EQ(read.mesh.triangles.rows(), 1);
  EXPECT_EQ(read.mesh.points.row(1).transpose(), Vec3(100, 0, 0));
}

TEST(Gltf, NodesMoveTurnAndScaleWhatIsBelowThem) {
  json scene = tetrahedronScene();
  // A quarter turn around z, then twice the size, then moved.
  scene["nodes"] = json::parse(R"([{"children": [1], "translation": [5, 6, 7], "scale": [2, 2, 2]},
                                   {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}])");
  const SurfaceFile read = readScene(scene);
  const Bounds bounds = boundsOf(read.mesh.points);
  EXPECT_TRUE(bounds.low.isApprox(Vec3(-195, 6, 7), 1e-12)) << bounds.low.transpose();
  EXPECT_TRUE(bounds.high.isApprox(Vec3(5, 206, 207), 1e-12)) << bounds.high.transpose();
  EXPECT_TRUE(geometry::checkSurface(read.mesh).outward());
}

TEST(Gltf, AMirroringNodeDoesNotTurnTheSurfaceInsideOut) {
  json scene = tetrahedronScene();
  scene["nodes"][0]["matrix"] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const SurfaceFile read = readScene(scene);
  EXPECT_EQ(boundsOf(read.mesh.points).low.x(), -100);
  EXPECT_TRUE(geometry::checkSurface(read.mesh).outward());
}

TEST(Gltf, TwoNodesOfOneMeshAreTwoSurfaces) {
  json scene = tetrahedronScene();
  scene["scenes"][0]["nodes"] = {0, 1};
  scene["nodes"].push_back({{"mesh", 0}, {"translation", {500, 0, 0}}});
  EXPECT_THROW(readScene(scene), UsageError);
  const std::vector<SurfacePart> parts = readParts(scene);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].surface.name, "Apex");
  EXPECT_EQ(parts[1].surface.name, "Apex 2");
  EXPECT_EQ(boundsOf(parts[1].surface.mesh.points).low.x(), 500);
}

TEST(Gltf, CyclesIndicesAndSizesAreChecked) {
  json scene = tetrahedronScene();
  scene["nodes"][0]["children"] = {0};
  EXPECT_THAT(problemOf(scene), HasSubstr("twice"));
  scene = tetrahedronScene();
  scene["nodes"][0]["mesh"] = 7;
  EXPECT_THAT(problemOf(scene), HasSubstr("number 7 of \"meshes\""));
  scene = tetrahedronScene();
  scene["accessors"][0]["count"] = 5;
  EXPECT_THAT(problemOf(scene), HasSubstr("5 elements"));
  scene = tetrahedronScene();
  scene["accessors"][0]["count"] = 3;
  EXPECT_THAT(problemOf(scene), HasSubstr("refers to point 3"));
  scene = tetrahedronScene();
  scene["accessors"][0]["count"] = 1e300;
  EXPECT_THAT(problemOf(scene), HasSubstr("count"));
  scene = tetrahedronScene();
  scene["accessors"][0]["count"] = 18446744073709551615ULL;
  EXPECT_THAT(problemOf(scene), HasSubstr("more than its buffer holds"));
  scene = tetrahedronScene();
  scene["bufferViews"][1]["byteOffset"] = 1000;
  EXPECT_THAT(problemOf(scene), HasSubstr("behind the end"));
  scene = tetrahedronScene();
  scene["buffers"][0]["byteLength"] = 73;
  EXPECT_THAT(problemOf(scene), HasSubstr("cut off"));
  scene = tetrahedronScene();
  scene["buffers"][0]["uri"] = "missing.bin";
  EXPECT_THAT(problemOf(scene), HasSubstr("missing.bin"));
  scene["buffers"][0]["uri"] = "/etc/hostname";
  EXPECT_THAT(problemOf(scene), HasSubstr("only files beside it"));
}

TEST(Gltf, CompressedAndOldScenesAreRefusedByName) {
  json scene = tetrahedronScene();
  scene["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  EXPECT_THAT(problemOf(scene), HasSubstr("KHR_draco_mesh_compression"));
  scene = tetrahedronScene();
  scene["asset"]["version"] = "1.0";
  EXPECT_THAT(problemOf(scene), HasSubstr("1.0"));
  scene = tetrahedronScene();
  scene["accessors"][0]["sparse"] = json::object();
  EXPECT_THAT(problemOf(scene), HasSubstr("sparse"));
  scene = tetrahedronScene();
  scene.erase("meshes");
  scene["nodes"][0].erase("mesh");
  EXPECT_THAT(problemOf(scene), HasSubstr("no triangles"));
}

TEST(Gltf, WhatOnlyConcernsPicturesDoesNotKeepAShapeFromOpening) {
  for (const char* extension : {"EXT_texture_webp", "KHR_texture_basisu", "KHR_texture_transform",
                                "KHR_materials_pbrSpecularGlossiness", "KHR_materials_unlit",
                                "EXT_texture_avif", "MSFT_texture_dds", "KHR_mesh_quantization"}) {
    json scene = tetrahedronScene();
    scene["extensionsUsed"] = {extension};
    scene["extensionsRequired"] = {extension};
    EXPECT_TRUE(geometry::checkSurface(readScene(scene).mesh).outward()) << extension;
  }
  json scene = tetrahedronScene();
  scene["extensionsRequired"] = {"VENDOR_points_elsewhere"};
  EXPECT_THAT(problemOf(scene), HasSubstr("VENDOR_points_elsewhere"));
}

TEST(Gltf, CompressedGeometryIsCalledSo) {
  for (const char* extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    json scene = tetrahedronScene();
    scene["extensionsRequired"] = {extension};
    EXPECT_THAT(problemOf(scene), HasSubstr("compressed"));
  }
  // Not required, but without other points; and with them.
  json scene = tetrahedronScene();
  scene["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  scene["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  EXPECT_NEAR(readScene(scene).report.volumeMm3, 1e6 / 6, 1e-6);
  scene["accessors"][0].erase("bufferView");
  scene["accessors"][1].erase("bufferView");
  EXPECT_THAT(problemOf(scene), HasSubstr("compressed"));
  scene = tetrahedronScene();
  scene["buffers"].push_back(
      {{"byteLength", 48}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  scene["bufferViews"][0]["buffer"] = 1;
  scene["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  EXPECT_THAT(problemOf(scene), HasSubstr("compressed"));
}

TEST(Gltf, QuantizedPointsAreScaledByTheirNode) {
  // Corners 0 and 32767 as normalised 16-bit numbers: 0 and 1, times 100.
  std::string bytes;
  for (const int corner : {0, 1, 2, 3})
    for (int axis = 0; axis < 4; ++axis) // Each row is filled up to four bytes.
      bytes += corner == axis + 1 && axis < 3 ? std::string("\xff\x7f") : std::string(2, '\0');
  for (const int index : {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3})
    bytes += {static_cast<char>(index), '\0'};
  json scene = tetrahedronScene();
  scene["extensionsRequired"] = {"KHR_mesh_quantization"};
  scene["accessors"][0] = {
      {"bufferView", 0}, {"componentType", 5122}, {"normalized", true}, {"count", 4}, {"type", "VEC3"}};
  scene["bufferViews"] = {{{"buffer", 0}, {"byteLength", 32}, {"byteStride", 8}},
                          {{"buffer", 0}, {"byteOffset", 32}, {"byteLength", 24}}};
  scene["buffers"][0] = {{"byteLength", 56}, {"uri", "q.bin"}};
  scene["nodes"][0]["scale"] = {100, 100, 100};
  const TemporaryFolder folder;
  folder.put("q.bin", bytes);
  EXPECT_NEAR(readSurface(folder.put("q.gltf", scene.dump())).report.volumeMm3, 1e6 / 6, 1e-6);
}

TEST(Gltf, NodesOfOtherProgramsAreOrgansWithTheirColours) {
  json scene = tetrahedronScene();
  scene["scenes"][0]["nodes"] = {0, 1};
  scene["nodes"] = {{{"mesh", 0}, {"name", "Liver"}}, {{"mesh", 1}, {"translation", {500, 0, 0}}}};
  scene["meshes"].push_back(scene["meshes"][0]);
  scene["meshes"][0]["name"] = "mesh0";
  scene["meshes"][1]["name"] = "Spleen";
  scene["meshes"][1]["primitives"][0]["material"] = 0;
  scene["materials"] = {{{"name", "red"},
                         {"alphaMode", "BLEND"},
                         {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 0.5}}}}}};
  const std::vector<SurfacePart> parts = readParts(scene);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].surface.name, "Liver");
  EXPECT_FALSE(parts[0].color.has_value());
  EXPECT_EQ(parts[1].surface.name, "Spleen");
  ASSERT_TRUE(parts[1].color.has_value());
  EXPECT_TRUE(parts[1].color->isApprox(Vec3(1, 0, 0), 1e-9));
  EXPECT_EQ(parts[1].opacity, 0.5);
}

/// The JSON of a GLB.
json jsonOf(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  return json::parse(glb.substr(20, length));
}

TEST(Glb, StandsUprightInMetresForOtherPrograms) {
  const TemporaryFolder folder;
  for (const Space space : {Space::lps, Space::ras}) {
    geometry::TriangleMesh mesh = test::organ();
    writeSurface(folder / "a.glb", mesh, {space, "Heart"});
    const json scene = jsonOf(tests::contentsOf(folder / "a.glb"));
    EXPECT_EQ(scene["meshes"][0]["name"], "Heart");
    const auto matrix = scene["nodes"][0]["matrix"].get<std::vector<double>>();
    const auto apply = [&](Vec3 lps) {
      const Vec3 p = space == Space::lps ? lps : Vec3(-lps.x(), -lps.y(), lps.z());
      Vec3 out;
      for (int row = 0; row < 3; ++row)
        out[row] = matrix[static_cast<std::size_t>(row)] * p.x() +
                   matrix[static_cast<std::size_t>(4 + row)] * p.y() +
                   matrix[static_cast<std::size_t>(8 + row)] * p.z();
      return out;
    };
    EXPECT_EQ(apply({0, 0, 1000}), Vec3(0, 1, 0)) << "the head is up";
    EXPECT_EQ(apply({0, -1000, 0}), Vec3(0, 0, 1)) << "the face looks at the viewer";
    EXPECT_EQ(apply({1000, 0, 0}), Vec3(1, 0, 0)) << "the patient's left is on the right";
  }
}

TEST(Glb, StatesBoundsAndUnitNormals) {
  const TemporaryFolder folder;
  writeSurface(folder / "a.glb", test::organ());
  const std::string bytes = tests::contentsOf(folder / "a.glb");
  const json scene = jsonOf(bytes);
  const Bounds bounds = boundsOf(test::organ().points);
  EXPECT_FLOAT_EQ(scene["accessors"][0]["max"][0].get<float>(), static_cast<float>(bounds.high.x()));
  EXPECT_FLOAT_EQ(scene["accessors"][0]["min"][2].get<float>(), static_cast<float>(bounds.low.z()));
  for (const json& view : scene["bufferViews"])
    EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
  const std::size_t normals = 28 + scene["bufferViews"][1]["byteOffset"].get<std::size_t>() +
                              static_cast<std::size_t>(bytes[12] & 0xFF) +
                              256 * static_cast<std::size_t>(bytes[13] & 0xFF);
  for (std::size_t v = 0; v < 10; ++v) {
    Eigen::Vector3f normal;
    std::memcpy(normal.data(), bytes.data() + normals + 12 * v, 12);
    EXPECT_NEAR(normal.norm(), 1, 1e-6);
  }
}

TEST(Glb, ChunksHaveToFitTheFile) {
  const TemporaryFolder folder;
  writeSurface(folder / "a.glb", test::organ());
  const std::string bytes = tests::contentsOf(folder / "a.glb");
  const auto problem = [&](const std::string& damaged) {
    try {
      readSurface(folder.put("b.glb", damaged));
    } catch (const DataError& error) {
      return error.problem().english();
    }
    return std::string("it was read");
  };
  EXPECT_THAT(problem(bytes.substr(0, bytes.size() - 1)), HasSubstr("cut off"));
  EXPECT_THAT(problem(bytes.substr(0, 11)), HasSubstr("cut off"));
  std::string changed = bytes;
  changed.replace(12, 4, "\xff\xff\xff\x7f");
  EXPECT_THAT(problem(changed), HasSubstr("cut off"));
  changed = bytes;
  changed[4] = 1;
  EXPECT_THAT(problem(changed), HasSubstr("version 1"));
}

TEST(WriteSurfaces, PutsEveryOrganWithItsNameAndColourIntoOneGlb) {
  const TemporaryFolder folder;
  const auto colored = std::make_shared<const geometry::TriangleMesh>(test::organ());
  const auto plain = std::make_shared<const geometry::TriangleMesh>(tests::box(40, 50, 60));
  writeSurfaces(folder / "all.glb", {{colored, "Liver"}, {plain, "Spleen", {1, 0.5, 0}, 0.5}});
  const std::string glb = tests::contentsOf(folder / "all.glb");
  const json document = json::parse(glb.substr(20, glb.find("BIN", 20) - 24));
  ASSERT_EQ(document["nodes"].size(), 2u);
  EXPECT_EQ(document["nodes"][1]["name"], "Spleen");
  EXPECT_TRUE(document["meshes"][0]["primitives"][0]["attributes"].contains("COLOR_0"));
  EXPECT_FALSE(document["materials"][0]["pbrMetallicRoughness"].contains("baseColorFactor"));
  const json factor = document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_EQ(factor[0], 1.0);
  EXPECT_NEAR(factor[1].get<double>(), 0.214, 1e-3) << "linear, as the format asks";
  EXPECT_EQ(factor[3], 0.5);
  EXPECT_THROW(readSurface(folder / "all.glb"), UsageError);
  const SurfaceFile both = readSurface(folder / "all.glb", SeveralOrgans::join);
  EXPECT_EQ(both.mesh.triangles.rows(), colored->triangles.rows() + 12);
  EXPECT_TRUE(both.spaceStated);
  const std::vector<SurfacePart> apart = readSurfaces(folder / "all.glb");
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_EQ(apart[0].surface.name, "Liver");
  EXPECT_EQ(apart[0].surface.mesh.colors, colored->colors);
  EXPECT_EQ(apart[1].surface.name, "Spleen");
  EXPECT_EQ(apart[1].color, Vec3(1, 0.5, 0));
  EXPECT_EQ(apart[1].opacity, 0.5);
  EXPECT_EQ(apart[1].surface.mesh.triangles, plain->triangles);
  EXPECT_THROW(writeSurfaces(folder / "all.ply", {{plain, "Spleen"}}), CannotCreateError);
  EXPECT_THROW(writeSurfaces(folder / "none.glb", {}), DataError);
}

} // namespace
} // namespace viscera::medical_io
