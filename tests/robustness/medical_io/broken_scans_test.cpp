#include <atomic>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <zlib.h>

#include "dicom_slices.h"
#include "memory_use.h"
#include "packed_bytes.h"
#include "packed_dicom.h"
#include "phantom_scan.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/scan.h"

/// Scans of every format and packing, broken in many ways. Reading in this process: a crash ends the test.
namespace viscera::medical_io {
namespace {

using tests::kMostExtraKilobytes;
using tests::peakKilobytes;
using tests::TemporaryFolder;

constexpr int kCuts = 25, kFlips = 40;

tests::LabelImage phantom() {
  tests::LabelImage image = tests::orientedPhantomGrid(0, {0, 1, 2});
  tests::fillPhantom(image);
  return image;
}

/// What becomes of a file: read, or refused with a reason that names it.
bool tryReading(const std::filesystem::path& file) {
  Progress progress;
  try {
    const Scan scan = readScan(file, {}, progress);
    EXPECT_EQ(std::visit([](const auto& all) { return all.size(); }, scan.samples), scan.voxelCount());
    EXPECT_TRUE(scan.indexToLps.matrix().allFinite());
    return true;
  } catch (const Error& error) {
    EXPECT_GT(error.problem().english().size(), 10U);
    EXPECT_FALSE(error.where().empty()) << error.what();
    return false;
  }
}

class BrokenScans : public testing::TestWithParam<std::string> {
protected:
  static std::string goodBytes(const std::string& kind) {
    if (kind == "a.nii")
      return tests::niftiFile(phantom());
    if (kind == "a.nii.gz")
      return tests::gzipped(tests::niftiFile(phantom()));
    if (kind == "a.nrrd")
      return tests::nrrdFile(phantom());
    if (kind == "a.mha")
      return tests::metaImageFile(phantom());
    if (kind == "enhanced.dcm")
      return tests::dicomBytes(tests::enhancedDicom(phantom()));
    const std::string plain = tests::dicomBytes(tests::dicomSlice(phantom(), 3));
    return kind == "plain.dcm" ? plain : tests::packedDicom(plain, kind.substr(0, kind.find('.')));
  }
};

TEST_P(BrokenScans, AreRefusedWithAReasonAndTakeLittleMemory) {
  const TemporaryFolder folder;
  const std::string good = goodBytes(GetParam());
  ASSERT_TRUE(tryReading(folder.put(GetParam(), good)));
  const long before = peakKilobytes();
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  int refused = 0;
  for (int cut = 0; cut < kCuts; ++cut)
    refused +=
        tryReading(folder.put(GetParam(), good.substr(0, good.size() * std::size_t(cut) / kCuts))) ? 0 : 1;
  EXPECT_GE(refused, kCuts - 1) << "a part of a file is not a file";
  std::mt19937 random(11);
  for (int flip = 0; flip < kFlips; ++flip) {
    std::string damaged = good;
    // Headers are where damage does most.
    const std::size_t within = flip % 2 == 0 ? std::min<std::size_t>(good.size(), 1200) : good.size();
    for (int byte = 0; byte < 1 + flip % 4; ++byte)
      damaged[random() % within] = static_cast<char>(random());
    tryReading(folder.put(GetParam(), damaged));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_LT(peakKilobytes() - before, kMostExtraKilobytes) << "memory was taken for what a header promised";
}

INSTANTIATE_TEST_SUITE_P(OfEveryFormat, BrokenScans,
                         testing::Values("a.nii", "a.nii.gz", "a.nrrd", "a.mha", "plain.dcm", "rle.dcm",
                                         "jpeg.dcm", "jpeg-lossless.dcm", "jpeg-ls.dcm", "jpeg-2000.dcm",
                                         "deflated.dcm", "enhanced.dcm"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == '.' || c == '-'; }, '_');
                           return name;
                         });

TEST(BrokenScanHeaders, PromisesOfHugePicturesTakeNoMemory) {
  const TemporaryFolder folder;
  const long before = peakKilobytes();
  tests::DicomElements e = tests::dicomSlice(phantom(), 3);
  e[0x00280010] = tests::us(65000);
  e[0x00280011] = tests::us(65000);
  EXPECT_FALSE(tryReading(folder.put("huge.dcm", tests::dicomBytes(e))));
  const std::string packed = tests::packedDicom(tests::dicomBytes(tests::dicomSlice(phantom(), 3)), "rle");
  std::string damaged = packed;
  const std::string rows = tests::dicomElement(0x00280010, tests::us(phantom().size[1]));
  ASSERT_NE(damaged.find(rows), damaged.npos);
  damaged.replace(damaged.find(rows), rows.size(), tests::dicomElement(0x00280010, tests::us(65000)));
  EXPECT_FALSE(tryReading(folder.put("huge.dcm", damaged)));
  tests::LabelImage image = phantom();
  image.size = {32000, 32000, 32000};
  const std::string header = tests::niftiFile(image);
  EXPECT_FALSE(tryReading(folder.put("huge.nii", header)));
  EXPECT_FALSE(tryReading(folder.put("huge.nii.gz", tests::gzipped(header))));
  EXPECT_LT(peakKilobytes() - before, kMostExtraKilobytes);
}

constexpr std::uint32_t kZeros = 400U << 20U;

/// `begin` with 400 MB of zeros behind it, packed: half a megabyte. Made in pieces, which take no memory.
std::string packedWithZeros(const std::string& begin, int windowBits) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
  std::string file, packed(1 << 16, '\0');
  const auto pack = [&](std::string bytes, int flush) {
    stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_out = static_cast<uInt>(packed.size());
      deflate(&stream, flush);
      file.append(packed.data(), packed.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  };
  pack(begin, Z_NO_FLUSH);
  for (std::uint32_t done = 0; done < kZeros; done += 1U << 20U)
    pack(std::string(1U << 20U, '\0'), Z_NO_FLUSH);
  pack({}, Z_FINISH);
  deflateEnd(&stream);
  return file;
}

/// A deflated DICOM file that unpacks to 400 MB of zeros in one element.
std::string deflatedBomb() {
  std::string file(128, '\0');
  file += "DICM" + std::string("\x02\0\x10\0UI", 6) + '\x16' + '\0' + "1.2.840.10008.1.2.1.99";
  std::string element("\x09\0\x10\x10OB\0\0", 8);
  for (unsigned byte = 0; byte < 4; ++byte)
    element.push_back(static_cast<char>(kZeros >> (8 * byte) & 0xffU));
  return file + packedWithZeros(element, -MAX_WBITS);
}

/// What lies behind the voxels that the header promises is not unpacked.
TEST(PackedScans, TakeNoMemoryForWhatLiesBehindTheirVoxels) {
  const TemporaryFolder folder;
  const auto withPacking = [](std::string file, const std::string& was, const std::string& is) {
    const std::size_t at = file.find(was);
    EXPECT_NE(at, std::string::npos) << was;
    const std::string header = file.replace(at, was.size(), is);
    const std::string voxels = tests::voxelBytes(phantom().voxels);
    return header.substr(0, header.size() - voxels.size()) + packedWithZeros(voxels, MAX_WBITS + 16);
  };
  const std::vector<std::filesystem::path> files = {
      folder.put("a.nii.gz", packedWithZeros(tests::niftiFile(phantom()), MAX_WBITS + 16)),
      folder.put("a.nrrd", withPacking(tests::nrrdFile(phantom()), "encoding: raw", "encoding: gzip")),
      folder.put("a.mha", withPacking(tests::metaImageFile(phantom()), "CompressedData = False",
                                      "CompressedData = True"))};
  for (const std::filesystem::path& file : files) {
    const long before = peakKilobytes();
    EXPECT_TRUE(tryReading(file)) << file;
    EXPECT_LT(peakKilobytes() - before, kMostExtraKilobytes / 2) << file;
  }
}

TEST(DeflatedDicom, ThatUnpacksToFarMoreThanAScanIsRefusedWithoutItsMemory) {
  const TemporaryFolder folder;
  const std::string bomb = deflatedBomb();
  EXPECT_LT(bomb.size(), std::size_t{4} << 20U);
  const auto file = folder.put("bomb.dcm", bomb);
  const long before = peakKilobytes();
  Progress progress;
  try {
    readScan(file, {}, progress);
    ADD_FAILURE() << "it was read";
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("unpacked"), std::string::npos) << error.what();
  }
  EXPECT_LT(peakKilobytes() - before, kMostExtraKilobytes / 2);
}

/// Whatever a JPEG 2000 stream or the header around it promises of its size, tiles and components.
TEST(Jpeg2000Dicom, ThatPromisesFarMoreThanItHasIsRefusedWithoutItsMemory) {
  const TemporaryFolder folder;
  const auto bigEndian = [](std::uint32_t value, int bytes) {
    std::string out;
    while (bytes-- > 0)
      out.push_back(static_cast<char>(value >> (8 * bytes) & 0xffU));
    return out;
  };
  const std::string plain = tests::dicomBytes(tests::dicomSlice(phantom(), 3));
  const std::string good = tests::packedDicom(plain, "jpeg-2000"), begin("\xFF\x4F\xFF\x51");
  // The size segment (ISO/IEC 15444-1, A.5.1): marks, length, capabilities, width, height, origin, tiles.
  constexpr std::size_t kWidth = 8, kTileWidth = 24, kComponents = 40;
  const std::size_t at = good.find(begin);
  ASSERT_NE(at, good.npos);
  const std::string huge = bigEndian(65000, 4) + bigEndian(65000, 4);
  std::string large = good, tiled = good, many = good, promised = good;
  large.replace(at + kWidth, huge.size(), huge).replace(at + kTileWidth, huge.size(), huge);
  tiled.replace(at + kWidth, huge.size(), huge)
      .replace(at + kTileWidth, huge.size(), bigEndian(255, 4) + bigEndian(255, 4));
  many.replace(at + kComponents, 2, bigEndian(16384, 2));
  promised = large;
  for (const auto& [tag, count] :
       {std::pair{0x00280010U, phantom().size[1]}, {0x00280011U, phantom().size[0]}}) {
    const std::string was = tests::dicomElement(tag, tests::us(count));
    ASSERT_NE(promised.find(was), promised.npos);
    promised.replace(promised.find(was), was.size(), tests::dicomElement(tag, tests::us(65000)));
  }
  for (const std::string& file : {large, tiled, many, promised}) {
    const long before = peakKilobytes();
    EXPECT_FALSE(tryReading(folder.put("bomb.dcm", file)));
    EXPECT_LT(peakKilobytes() - before, kMostExtraKilobytes / 2);
  }
}

/// Another program writes the file anew, shorter, longer or as another kind of image, while it is read.
TEST(ChangingScan, IsReadOrRefusedAndNeverMixedUp) {
  constexpr int kTries = 200;
  const TemporaryFolder folder;
  const std::string whole = tests::nrrdFile(phantom());
  const std::vector<std::string> forms = {whole, whole.substr(0, whole.size() / 2),
                                          tests::nrrdFile(tests::emptyLabels({70, 60, 50}))};
  const std::filesystem::path file = folder.put("a.nrrd", whole);
  std::atomic<bool> over = false;
  std::thread writer([&] {
    for (std::size_t turn = 0; !over; ++turn)
      std::ofstream(file, std::ios::binary | std::ios::trunc) << forms[turn % forms.size()];
  });
  int read = 0;
  for (int i = 0; i < kTries; ++i)
    read += tryReading(file) ? 1 : 0;
  over = true;
  writer.join();
  folder.put("a.nrrd", whole);
  EXPECT_TRUE(tryReading(file)) << "read " << read << " times while it changed";
}

} // namespace
} // namespace viscera::medical_io
