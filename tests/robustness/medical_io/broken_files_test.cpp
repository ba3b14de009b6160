#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "good_files.h"
#include "label_files.h"
#include "memory_use.h"
#include "packed_bytes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/surface_file.h"

/// Every file of every format, broken in many ways. Reading in this process: a crash ends the test as failed.
namespace viscera::medical_io {
namespace {

using tests::FileUse;
using tests::GoodFile;
using tests::kMostExtraKilobytes;
using tests::peakKilobytes;
using tests::TemporaryFolder;

enum class Outcome { read, readLess, refused };

/// Labelled voxels.
Eigen::Index sizeOfLabels(const std::filesystem::path& file) {
  Progress progress;
  const LabelMap read = readLabelMap(file, progress);
  Eigen::Index voxels = 0;
  EXPECT_FALSE(read.segments.empty()) << file;
  EXPECT_TRUE(read.indexToLps.matrix().allFinite()) << file;
  EXPECT_GT(read.voxelVolumeMm3(), 0) << file;
  for (const LabelLayer& layer : read.layers) {
    EXPECT_EQ(layer.size(), read.voxelCount()) << file;
    for (std::size_t voxel = 0; voxel < layer.size(); ++voxel) {
      EXPECT_LE(layer[voxel], read.segments.size()) << file;
      voxels += layer[voxel] != 0 ? 1 : 0;
    }
  }
  return voxels;
}

/// Triangles, handles or labelled voxels; throws what reading throws.
Eigen::Index sizeOf(const std::filesystem::path& file, FileUse use) {
  if (use == FileUse::labels)
    return sizeOfLabels(file);
  if (use == FileUse::handles) {
    const HandleFile read = readHandles(file);
    EXPECT_TRUE(read.positions().allFinite()) << file;
    return read.count();
  }
  Eigen::Index triangles = 0;
  for (const SurfacePart& part : readSurfaces(file)) {
    const geometry::TriangleMesh& mesh = part.surface.mesh;
    EXPECT_NO_THROW(geometry::requireValid(mesh, file.string()));
    EXPECT_GT(mesh.triangles.rows(), 0) << file;
    EXPECT_TRUE(mesh.colors.rows() == 0 || mesh.colors.rows() == mesh.points.rows()) << file;
    triangles += mesh.triangles.rows();
  }
  return triangles;
}

class BrokenFiles : public testing::Test {
protected:
  /// Calls `breakIt` for every good file, which is then `good_`, and watches what reading does beside
  /// throwing.
  template <typename Break>
  void forEachGoodFile(const Break& breakIt) {
    for (const GoodFile& good : tests::goodFiles()) {
      SCOPED_TRACE(good.name);
      good_ = good;
      if (!good.besideName.empty())
        folder_.put(good.besideName, good.besideBytes);
      whole_ = sizeOf(folder_.put(good.name, good.bytes), good.use);
      const long peakBefore = peakKilobytes();
      testing::internal::CaptureStderr();
      breakIt();
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "a reader printed something";
      EXPECT_LT(peakKilobytes() - peakBefore, kMostExtraKilobytes)
          << "memory was taken for what a header promised";
    }
    EXPECT_GT(tried_, 100);
    RecordProperty("files", tried_);
  }

  const std::string& bytes() const { return good_.bytes; }

  Outcome tryReading(const std::string& damaged, const std::string& name) {
    ++tried_;
    const std::filesystem::path file = folder_.put(name, damaged);
    EXPECT_NO_THROW(fileKind(file)) << file;
    try {
      const Eigen::Index size = sizeOf(file, good_.use);
      return size < whole_ ? Outcome::readLess : Outcome::read;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(file.string()), std::string::npos) << "the file is not named: " << what;
      EXPECT_FALSE(error.problem().empty());
      EXPECT_FALSE(error.tryThis().empty()) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << "one message, one line: " << what;
      EXPECT_LT(what.size(), 600U) << what;
      return Outcome::refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << file << " threw something else: " << error.what();
      return Outcome::refused;
    }
  }
  Outcome tryReading(const std::string& damaged) { return tryReading(damaged, good_.name); }

  TemporaryFolder folder_;
  GoodFile good_;
  Eigen::Index whole_ = 0;
  int tried_ = 0;
};

TEST_F(BrokenFiles, ThatAreCutOffAreRefused) {
  forEachGoodFile([&] {
    std::vector<std::size_t> lengths;
    for (std::size_t length = 1; length < std::min<std::size_t>(bytes().size(), 100); ++length)
      lengths.push_back(length);
    for (std::size_t part = 1; part < 100; ++part)
      lengths.push_back(bytes().size() * part / 100);
    for (std::size_t missing = 1; missing < std::min<std::size_t>(bytes().size(), 40); ++missing)
      lengths.push_back(bytes().size() - missing);
    for (const std::size_t length : lengths) {
      const Outcome outcome = tryReading(bytes().substr(0, length));
      EXPECT_TRUE(outcome != Outcome::readLess || good_.partsLookWhole)
          << "the first " << length << " bytes became a part of the surface";
    }
  });
}

TEST_F(BrokenFiles, WithAByteChangedAreReadOrRefused) {
  forEachGoodFile([&] {
    std::mt19937 random(20240607);
    for (int i = 0; i < 300; ++i) {
      std::string damaged = bytes();
      // Half of the changes where headers are.
      const std::size_t range = i % 2 == 0 ? damaged.size() : std::min<std::size_t>(damaged.size(), 400);
      const std::size_t at = random() % range;
      damaged[at] = static_cast<char>(static_cast<unsigned char>(damaged[at]) ^ (1U << (random() % 8)));
      tryReading(damaged);
    }
  });
}

TEST_F(BrokenFiles, WithWordsOfExtremeBitsAreReadOrRefused) {
  forEachGoodFile([&] {
    std::mt19937 random(7);
    const std::vector<std::string> words = {std::string(4, '\xff'),          std::string(4, '\0'),
                                            std::string("\xff\xff\xff\x7f"), std::string("\0\0\0\x80", 4),
                                            std::string(8, '\xff'),          std::string("\0\0\xc0\x7f", 4)};
    for (int i = 0; i < 150; ++i) {
      std::string damaged = bytes();
      const std::string& word = words[static_cast<std::size_t>(i) % words.size()];
      if (damaged.size() <= word.size())
        continue;
      damaged.replace(random() % (damaged.size() - word.size()), word.size(), word);
      tryReading(damaged);
    }
  });
}

TEST_F(BrokenFiles, WithNumbersThatPromiseTooMuchAreReadOrRefused) {
  forEachGoodFile([&] {
    const std::vector<std::string> numbers = {"99999999999999999999999",
                                              "9223372036854775807",
                                              "4294967296",
                                              "2147483648",
                                              "-1",
                                              "1e308",
                                              "nan",
                                              "0"};
    // Every number of the first part of the file in turn; data behind it are more of the same.
    const std::string_view text = std::string_view(bytes()).substr(0, 3000);
    std::size_t replaced = 0;
    for (std::size_t at = 0; at < text.size() && replaced < 60;) {
      const bool begins = std::isdigit(static_cast<unsigned char>(text[at])) != 0;
      if (!begins) {
        ++at;
        continue;
      }
      std::size_t end = at;
      while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0)
        ++end;
      std::string damaged = bytes();
      damaged.replace(at, end - at, numbers[replaced % numbers.size()]);
      tryReading(damaged);
      damaged = bytes();
      damaged.replace(at, end - at, numbers[0]);
      tryReading(damaged);
      ++replaced;
      at = end;
    }
  });
}

TEST_F(BrokenFiles, WithPartsMissingTwiceOrZeroedAreReadOrRefused) {
  forEachGoodFile([&] {
    std::mt19937 random(11);
    for (int i = 0; i < 100; ++i) {
      std::string damaged = bytes();
      const std::size_t at = random() % damaged.size();
      const std::size_t length = 1 + random() % std::min<std::size_t>(damaged.size() - at, 200);
      if (i % 3 == 0)
        damaged.erase(at, length);
      else if (i % 3 == 1)
        damaged.insert(at, damaged.substr(at, length));
      else
        damaged.replace(at, length, length, '\0');
      tryReading(damaged);
    }
    tryReading(bytes() + bytes());
  });
}

TEST_F(BrokenFiles, OfRandomBytesBehindTheRightBeginningAreReadOrRefused) {
  forEachGoodFile([&] {
    std::mt19937 random(13);
    for (int i = 0; i < 60; ++i) {
      std::string damaged = bytes().substr(0, random() % std::min<std::size_t>(bytes().size(), 500));
      const std::size_t length = random() % 3000;
      for (std::size_t k = 0; k < length; ++k)
        damaged += static_cast<char>(random());
      tryReading(damaged);
    }
  });
}

TEST_F(BrokenFiles, UnderTheNamesOfOtherFormatsAreRefused) {
  forEachGoodFile([&] {
    const std::string own = std::filesystem::path(good_.name).extension();
    for (const char* extension : {".stl", ".obj", ".ply", ".off", ".vtk", ".vtp", ".vtm", ".glb", ".gltf"})
      if (extension != own) {
        ++tried_;
        EXPECT_THROW(readSurface(folder_.put(std::string("wrong") + extension, bytes())), DataError)
            << extension;
      }
    if (good_.use != FileUse::handles) {
      EXPECT_THROW(readHandles(folder_.put("wrong.mrk.json", bytes())), DataError);
    }
    Progress progress;
    for (const char* extension : {".nii", ".nii.gz", ".nrrd", ".mha", ".dcm"})
      if (good_.use != FileUse::labels ||
          good_.name.find(std::string(extension).substr(0, 4)) == std::string::npos) {
        ++tried_;
        // Half an image is no bad one: the other half is not there.
        EXPECT_THROW(readLabelMap(folder_.put(std::string("wrong") + extension, bytes()), progress), Error)
            << extension;
      }
  });
}

LabelMap readLabels(const std::filesystem::path& file) {
  Progress progress;
  return readLabelMap(file, progress);
}

TEST(BrokenFile, RandomBytesUnderEveryNameAreRefused) {
  const TemporaryFolder folder;
  std::mt19937 random(17);
  for (const std::string& extension : endingsOf(FileKind::surface))
    for (const std::size_t length : {1U, 3U, 4U, 79U, 84U, 85U, 134U, 1000U, 20000U}) {
      std::string bytes;
      for (std::size_t k = 0; k < length; ++k)
        bytes += static_cast<char>(random());
      EXPECT_THROW(readSurface(folder.put("a" + extension, bytes)), DataError) << extension << " " << length;
      EXPECT_THROW(readHandles(folder.put("a.mrk.json", bytes)), DataError);
      EXPECT_THROW(readHandles(folder.put("a.fcsv", bytes)), DataError);
      for (const std::string& labels : endingsOf(FileKind::labelMap))
        EXPECT_THROW(readLabels(folder.put("a" + labels, bytes)), DataError) << labels << " " << length;
      std::fill(bytes.begin(), bytes.end(), '\0');
      EXPECT_THROW(readSurface(folder.put("a" + extension, bytes)), DataError) << extension << " " << length;
    }
}

/// Nested far deeper than a call stack: whoever walks through it by calling himself crashes.
TEST(BrokenFile, DeeplyNestedJsonIsReadOrRefused) {
  const TemporaryFolder folder;
  constexpr std::size_t kDepth = 1000000;
  const std::string deep = std::string(kDepth, '[') + std::string(kDepth, ']');
  const std::string head = R"({"asset":{"version":"2.0"},)";
  for (const std::string& text :
       {deep, deep.substr(0, kDepth), head + R"("nodes":)" + deep + "}", head + R"("scene":)" + deep + "}",
        head + R"("extensionsRequired":)" + deep + "}", head + R"("meshes":[{"primitives":)" + deep + "}]}"})
    EXPECT_THROW(readSurface(folder.put("a.gltf", text)), DataError);
  for (const std::string& text :
       {deep, R"({"markups":)" + deep + "}",
        R"({"markups":[{"type":"Fiducial","coordinateSystem":)" + deep + "}]}",
        R"({"markups":[{"type":"Fiducial","controlPoints":[{"position":)" + deep + "}]}]}"})
    EXPECT_THROW(readHandles(folder.put("a.mrk.json", text)), DataError);
}

/// Lines that go on and on, names that never end, polygons of many corners: all in time that grows with the
/// size.
TEST(BrokenFile, LongLinesAndPolygonsAreReadOrRefused) {
  const TemporaryFolder folder;
  std::string continued = "v 0 0 0\nf 1 ";
  for (int i = 0; i < 200000; ++i)
    continued += "\\\n";
  EXPECT_THROW(readSurface(folder.put("a.obj", continued)), DataError);
  std::string polygon;
  std::string corners = "f";
  for (int i = 1; i <= 100000; ++i) {
    polygon += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
    corners += " " + std::to_string(i);
  }
  EXPECT_THROW(readSurface(folder.put("b.obj", polygon + corners)), DataError) << "its edges cross";
  EXPECT_THROW(readSurface(folder.put("c.ply", "ply\ncomment " + std::string(3000000, 'x'))), DataError);
}

/// Headers that promise what no machine has, and little behind them: an error at once, and hardly any memory.
TEST(BrokenFile, HugeLabelMapsAreRefusedBeforeMemoryIsTaken) {
  const TemporaryFolder folder;
  const long before = peakKilobytes();
  tests::LabelImage image = tests::emptyLabels({2, 2, 2});
  image.fill({0, 0, 0}, {1, 1, 1}, 1);
  std::string nifti = tests::niftiFile(image);
  for (std::size_t d = 0; d < 3; ++d)
    tests::putBytes<std::int16_t>(nifti, 42 + 2 * d, 32767);
  EXPECT_THROW(readLabels(folder.put("a.nii", nifti)), DataError);
  EXPECT_THROW(readLabels(folder.put("a.nii.gz", tests::gzipped(nifti))), DataError);
  image.size = {60000, 60000, 60000};
  EXPECT_THROW(readLabels(folder.put("a.nrrd", tests::nrrdFile(image))), DataError);
  EXPECT_THROW(
      readLabels(folder.put("a.seg.nrrd", tests::nrrdFile(image, "left-posterior-superior", {}, 9000))),
      DataError);
  EXPECT_THROW(readLabels(folder.put("a.mha", tests::metaImageFile(image))), DataError);
  EXPECT_LT(peakKilobytes() - before, kMostExtraKilobytes);
}

} // namespace
} // namespace viscera::medical_io
