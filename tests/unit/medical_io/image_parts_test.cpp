#include <cstdio>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "label_files.h"
#include "packed_bytes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"

/// NRRD and MetaImage with their voxels in several files, and longs of two sizes.
namespace viscera::medical_io {
namespace {

using testing::HasSubstr;
using tests::LabelImage;

std::string with(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), by);
}

class ImageParts : public testing::Test {
protected:
  ImageParts() {
    image_ = tests::emptyLabels({6, 5, 4});
    image_.fill({1, 1, 1}, {3, 3, 2}, 5);
    image_.fill({5, 0, 3}, {5, 4, 3}, 9);
    header_ = tests::nrrdFile(image_);
    header_.resize(header_.size() - tests::voxelBytes(image_.voxels).size() - 1); // Without the empty line.
  }

  /// The slices of one file, from 0 to 3.
  std::string slices(std::size_t first, std::size_t count) const {
    return tests::voxelBytes(image_.voxels).substr(2 * 30 * first, 2 * 30 * count);
  }

  void expectImage(const std::filesystem::path& file) {
    SCOPED_TRACE(file);
    const LabelMap map = readLabelMap(file, progress_);
    ASSERT_EQ(map.segments.size(), 2U);
    EXPECT_EQ(map.segments[0].label, 5);
    EXPECT_EQ(map.segments[0].voxels, 18);
    EXPECT_EQ(map.segments[1].low, (std::array<int, 3>{5, 0, 3}));
    const Scan scan = readScan(file, {}, progress_);
    EXPECT_EQ(scan.value(3, 3, 2), 5);
    EXPECT_EQ(scan.value(5, 4, 3), 9);
    EXPECT_EQ(scan.value(0, 0, 0), 0);
  }

  LabelImage image_;
  std::string header_;
  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(ImageParts, OfANrrdFileAreListed) {
  folder_.put("lower.raw", slices(0, 2));
  folder_.put("upper part.raw", slices(2, 2));
  expectImage(folder_.put("a.nhdr", header_ + "data file: LIST 3\nlower.raw\nupper part.raw\n"));
  expectImage(folder_.put("b.nhdr", header_ + "datafile: LIST\nlower.raw\r\nupper part.raw"));
}

TEST_F(ImageParts, AreNumbered) {
  for (std::size_t k = 0; k < 4; ++k) {
    char name[32];
    std::snprintf(name, sizeof name, "s%03zu.raw", 10 - 2 * k);
    folder_.put(name, slices(k, 1));
    std::snprintf(name, sizeof name, "t%zu.raw.gz", k + 1);
    folder_.put(name, tests::gzipped(slices(k, 1)));
  }
  expectImage(folder_.put("a.nhdr", header_ + "data file: s%03d.raw 10 4 -2\n"));
  expectImage(folder_.put("b.nhdr", header_ + "data file: s%03d.raw 10 4 -2 2\n"));
  expectImage(folder_.put("c.nhdr", with(header_, "encoding: raw", "encoding: gzip") +
                                        "data file: t%d.raw.gz 1 4 1\n"));
}

TEST_F(ImageParts, OfAMetaImageAreListedOrNumbered) {
  for (std::size_t k = 0; k < 4; ++k)
    folder_.put("m" + std::to_string(k + 1) + ".raw", slices(k, 1));
  expectImage(
      folder_.put("a.mhd", tests::metaImageHeader(image_, "LIST") + "m1.raw\nm2.raw\nm3.raw\nm4.raw\n"));
  expectImage(folder_.put("b.mhd", tests::metaImageHeader(image_, "m%d.raw 1 4 1")));
}

TEST_F(ImageParts, ThatAreMissingOrShortAreNamed) {
  folder_.put("one.raw", slices(0, 2));
  const auto problem = [&](const std::string& fields) {
    try {
      readLabelMap(folder_.put("a.nhdr", header_ + fields), progress_);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("it was read");
  };
  EXPECT_THAT(problem("data file: LIST\none.raw\nother.raw\n"), HasSubstr("other.raw"));
  folder_.put("other.raw", slices(0, 1));
  EXPECT_THAT(problem("data file: LIST\none.raw\nother.raw\n"), HasSubstr("other.raw"));
  EXPECT_THAT(problem("data file: LIST\n"), HasSubstr("list of files is empty"));
  EXPECT_THAT(problem("data file: s%d.raw 1 1000000000 1\n"), HasSubstr("no series of files"));
  EXPECT_THAT(problem("data file: s%d.raw 1 7 1\n"), HasSubstr("equal files"));
  EXPECT_THAT(problem("data file: /etc/passwd\n"), HasSubstr("another folder"));
  folder_.put("50%dose.raw", slices(0, 4));
  expectImage(folder_.put("b.nhdr", header_ + "data file: 50%dose.raw\n"));
}

/// ITK means 32 bits by a long, and old programs on some systems 64.
TEST_F(ImageParts, AreLongsOfTheSizeThatTheDataHave) {
  const auto bytesOf = [&]<class T>(T) {
    std::string bytes;
    for (const std::int16_t voxel : image_.voxels) {
      const T value = voxel;
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return bytes;
  };
  for (const char* type : {"MET_LONG", "MET_ULONG"}) {
    const std::string local = with(tests::metaImageHeader(image_, "LOCAL"), "MET_SHORT", type);
    const std::string beside = with(tests::metaImageHeader(image_, "v.raw"), "MET_SHORT", type);
    const std::string packed = with(local, "CompressedData = False", "CompressedData = True");
    for (const std::string& bytes : {bytesOf(std::int32_t{}), bytesOf(std::int64_t{})}) {
      expectImage(folder_.put("a.mha", local + bytes));
      expectImage(folder_.put("b.mha", packed + tests::zlibPacked(bytes)));
      expectImage(folder_.put("c.mha.gz", tests::gzipped(local + bytes)));
      folder_.put("v.raw", bytes);
      expectImage(folder_.put("d.mhd", beside));
    }
    EXPECT_THROW(readLabelMap(folder_.put("e.mha", local + bytesOf(std::int16_t{})), progress_), DataError);
  }
}

TEST_F(ImageParts, OfAPackedFileAreReadLikePlainOnes) {
  const std::string nrrd = tests::nrrdFile(image_), voxels = tests::voxelBytes(image_.voxels);
  expectImage(folder_.put("a.nrrd.gz", tests::gzipped(nrrd)));
  std::string twice = with(nrrd, "encoding: raw", "encoding: gzip");
  twice.resize(twice.size() - voxels.size());
  expectImage(folder_.put("b.nrrd.gz", tests::gzipped(twice + tests::gzipped(voxels))));
  std::string text = with(twice, "encoding: gzip", "encoding: ascii");
  for (const std::int16_t voxel : image_.voxels)
    text += std::to_string(voxel) + "\n";
  expectImage(folder_.put("c.nrrd.gz", tests::gzipped(text)));
  const std::string whole = tests::gzipped(nrrd.substr(0, nrrd.size() - 1));
  EXPECT_THROW(readLabelMap(folder_.put("d.nrrd.gz", whole), progress_), DataError);
  EXPECT_THROW(readScan(folder_.put("e.mha.gz", tests::gzipped("nothing")), {}, progress_), DataError);
}

} // namespace
} // namespace viscera::medical_io
