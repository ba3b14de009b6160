#include "viscera/lesson/animated_gltf.h"

#include <cstring>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vtkCompositeDataIterator.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "lesson_scene.h"
#include "temporary_folder.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::lesson {
namespace {

/// A binary glTF taken apart.
struct Glb {
  nlohmann::json tree;
  std::string bytes;

  explicit Glb(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string all(std::istreambuf_iterator<char>(stream), {});
    std::uint32_t size = 0;
    std::memcpy(&size, all.data() + 12, 4);
    tree = nlohmann::json::parse(all.substr(20, size));
    bytes = all.substr(28 + size);
  }
  std::vector<float> floats(std::size_t accessor) const {
    const auto& described = tree["accessors"][accessor];
    const std::size_t each = described["type"] == "VEC3" ? 3 : 1;
    std::vector<float> values(described["count"].get<std::size_t>() * each);
    std::memcpy(
        values.data(),
        bytes.data() +
            tree["bufferViews"][described["bufferView"].get<std::size_t>()]["byteOffset"].get<std::size_t>(),
        values.size() * sizeof(float));
    return values;
  }
};

struct Written : BallScene {
  viscera::tests::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "ball.glb";
  LessonSource from = source(sway());
  LessonPlan plan = planLesson(from, {});
  WrittenGltf written = writeAnimatedGltf(file, plan, from, live, progress);
};

} // namespace

TEST(AnimatedGltf, PlaysTheMotion) {
  Written scene;
  const Glb glb(scene.file);
  const auto& primitive = glb.tree["meshes"][0]["primitives"][0];
  const auto& sampler = glb.tree["animations"][0]["samplers"][0];
  const std::vector<float> rest = glb.floats(primitive["attributes"]["POSITION"]);
  const std::vector<float> seconds = glb.floats(sampler["input"]), weights = glb.floats(sampler["output"]);
  const std::size_t modes = primitive["targets"].size();
  EXPECT_EQ(modes, scene.written.modes);
  EXPECT_EQ(seconds.size(), scene.written.frames + 1);
  EXPECT_FLOAT_EQ(seconds.back(), 1);
  std::vector<std::vector<float>> targets;
  for (const auto& target : primitive["targets"])
    targets.push_back(glb.floats(target["POSITION"]));
  double worst = 0;
  for (const std::size_t key : {0ul, 17ul, 50ul, 95ul}) {
    Points pose;
    scene.from.sequence->poseAt(seconds[key], scene.plan.rate, pose);
    scene.live.showPose(pose);
    const Points& truth = scene.live.points(scene.organ());
    for (std::size_t i = 0; i < rest.size(); ++i) {
      double value = rest[i];
      for (std::size_t k = 0; k < modes; ++k)
        value += weights[key * modes + k] * targets[k][i];
      worst = std::max(worst, std::abs(value - truth.data()[i]));
    }
  }
  EXPECT_LT(worst, 0.05);
  EXPECT_LT(scene.written.largestErrorMm, 0.05);
}

TEST(AnimatedGltf, SaysTheBoundsOfWhatIsStored) {
  Written scene;
  const Glb glb(scene.file);
  for (const auto& accessor : glb.tree["accessors"]) {
    if (!accessor.contains("min") || accessor["type"] != "VEC3")
      continue;
    const std::vector<float> values = glb.floats(&accessor - &glb.tree["accessors"][0]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float least = values[axis], most = values[axis];
      for (std::size_t i = axis; i < values.size(); i += 3) {
        least = std::min(least, values[i]);
        most = std::max(most, values[i]);
      }
      EXPECT_EQ(accessor["min"][axis].get<float>(), least);
      EXPECT_EQ(accessor["max"][axis].get<float>(), most);
    }
  }
}

TEST(AnimatedGltf, IsReadAtRestByUsAndByVtk) {
  Written scene;
  const Points rest = scene.document.organs().front()->mesh->points;
  const geometry::TriangleMesh ours = medical_io::readSurface(scene.file).mesh;
  ASSERT_EQ(ours.points.rows(), rest.rows());
  EXPECT_LT((ours.points - rest).cwiseAbs().maxCoeff(), 1e-4);

  vtkNew<vtkGLTFReader> reader; // VTK 9.1 knows morph targets, and plays animations of nodes only.
  reader->SetFileName(scene.file.c_str());
  reader->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  ASSERT_NE(blocks, nullptr);
  vtkPolyData* surface = nullptr;
  vtkSmartPointer<vtkCompositeDataIterator> leaves;
  leaves.TakeReference(blocks->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    if (auto* leaf = vtkPolyData::SafeDownCast(leaves->GetCurrentDataObject()))
      surface = leaf;
  ASSERT_NE(surface, nullptr);
  ASSERT_EQ(surface->GetNumberOfPoints(), rest.rows());
  EXPECT_EQ(surface->GetNumberOfPolys(), scene.document.organs().front()->mesh->triangles.rows());
  double box[6];
  surface->GetBounds(box);
  EXPECT_NEAR(box[1] - box[0], 0.06, 0.008) << "metres";
}

TEST(AnimatedGltf, OfStillOrgansHasNoAnimation) {
  BallScene scene;
  const viscera::tests::TemporaryFolder folder;
  const LessonSource source = scene.source(nullptr);
  const WrittenGltf written = writeAnimatedGltf(folder.path() / "still.glb", planLesson(source, {}), source,
                                                scene.live, scene.progress);
  const Glb glb(folder.path() / "still.glb");
  EXPECT_FALSE(glb.tree.contains("animations"));
  EXPECT_EQ(written.modes, 0u);
}

} // namespace viscera::lesson
