#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

namespace fs = std::filesystem;
using sample_organs::Resolution;

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files.push_back(entry.path());
  return files;
}

geometry::TriangleMesh make(const sample_organs::SampleLibrary& library) {
  Progress progress;
  return *sample_organs::sampleOrgan(library, "ball", Resolution::low, progress).surfaces.front().mesh;
}

/// Puts the numbers of a kept surface to the test: a cached mesh with its first point moved is only returned
/// as such when the cache is really read.
void overwrite(const fs::path& file, std::streamoff at, char value) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(at);
  stream.put(value);
}

class SurfaceCache : public testing::Test {
protected:
  void SetUp() override {
    files_.writeRoot("ball", kBall);
    first_ = make(files_.library());
    ASSERT_EQ(filesIn(files_.library().cache).size(), 1U);
    file_ = filesIn(files_.library().cache).front();
  }

  void expectMended() {
    const geometry::TriangleMesh again = make(files_.library());
    EXPECT_TRUE(again.points == first_.points);
    EXPECT_TRUE(again.triangles == first_.triangles);
    EXPECT_EQ(fs::file_size(file_), size_);
  }

  void remember() { size_ = fs::file_size(file_); }

  TemporaryLibrary files_;
  geometry::TriangleMesh first_;
  fs::path file_;
  std::uintmax_t size_ = 0;
};

} // namespace

TEST_F(SurfaceCache, GivesBackWhatWasMade) {
  const auto written = fs::last_write_time(file_);
  const geometry::TriangleMesh again = make(files_.library());
  EXPECT_TRUE(again.points == first_.points);
  EXPECT_TRUE(again.triangles == first_.triangles);
  EXPECT_TRUE(again.colors == first_.colors);
  EXPECT_EQ(fs::last_write_time(file_), written) << "the surface was made again";
}

TEST_F(SurfaceCache, IsMendedWhenAByteIsWrong) {
  remember();
  for (const std::streamoff at :
       {std::streamoff{0}, std::streamoff{8}, std::streamoff{17}, std::streamoff{30}, std::streamoff{44},
        static_cast<std::streamoff>(size_) - 1}) {
    overwrite(file_, at, '\x5a');
    SCOPED_TRACE(at);
    expectMended();
  }
}

TEST_F(SurfaceCache, IsMendedWhenTheFileIsCutOff) {
  remember();
  for (const std::uintmax_t length : {std::uintmax_t{0}, std::uintmax_t{10}, size_ / 2, size_ - 1}) {
    fs::resize_file(file_, length);
    SCOPED_TRACE(length);
    expectMended();
  }
}

TEST_F(SurfaceCache, IsNotUsedForAChangedDefinition) {
  files_.writeRoot("ball", R"({"type": "ellipsoid", "center": [1, 2, 3], "radii": [20, 20, 21]})");
  EXPECT_FALSE(make(files_.library()).points == first_.points);
}

TEST_F(SurfaceCache, MayBeAFolderThatCannotBeMade) {
  sample_organs::SampleLibrary library = files_.library();
  library.cache = file_ / "below a file";
  EXPECT_TRUE(make(library).points == first_.points);
}

} // namespace viscera::tests
