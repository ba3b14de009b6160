#include <cmath>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cine_pictures.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/cine_study.h"

namespace viscera::medical_io {
namespace {

using tests::CinePicture;
using tests::DicomElements;
using Random = std::mt19937;
/// Damages the bytes of one file.
using Damage = std::function<void(std::string&, Random&)>;

std::size_t upTo(Random& random, std::size_t last) {
  return std::uniform_int_distribution<std::size_t>(0, last)(random);
}

/// A damage that writes other elements than the picture's.
Damage otherElements(const std::function<void(DicomElements&, Random&)>& change) {
  return [change](std::string& bytes, Random& random) {
    CinePicture picture = tests::shortAxisPicture(1, 10, 800);
    picture.phases = 4;
    picture.phase = int(upTo(random, 3));
    DicomElements list = tests::cineElements(picture);
    change(list, random);
    bytes = tests::dicomBytes(list);
  };
}

Damage withoutElement(std::uint32_t tag) {
  return otherElements([tag](DicomElements& list, Random&) { list.erase(tag); });
}

Damage withElement(std::uint32_t tag, const std::string& value) {
  return otherElements([tag, value](DicomElements& list, Random&) { list[tag] = value; });
}

/// Thirty kinds.
std::vector<Damage> damages() {
  return {
      [](std::string& bytes, Random& random) { bytes.resize(upTo(random, bytes.size() - 1)); },
      [](std::string& bytes, Random& random) { bytes.resize(bytes.size() - 1 - upTo(random, 60)); },
      [](std::string& bytes, Random& random) { bytes.resize(132 + upTo(random, 200)); },
      [](std::string& bytes, Random&) { bytes.clear(); },
      [](std::string& bytes, Random& random) { bytes[upTo(random, bytes.size() - 1)] ^= char(0x41); },
      [](std::string& bytes, Random& random) {
        for (int i = 0; i < 40; ++i)
          bytes[upTo(random, bytes.size() - 1)] = char(upTo(random, 255));
      },
      [](std::string& bytes, Random& random) {
        std::fill_n(bytes.begin() + std::ptrdiff_t(upTo(random, bytes.size() - 33)), 32, '\0');
      },
      [](std::string& bytes, Random& random) {
        std::fill_n(bytes.begin() + std::ptrdiff_t(upTo(random, bytes.size() - 33)), 32, '\xFF');
      },
      [](std::string& bytes, Random& random) { bytes.erase(132 + upTo(random, 300), 1 + upTo(random, 9)); },
      [](std::string& bytes, Random& random) { bytes.insert(132 + upTo(random, 300), "12345"); },
      [](std::string& bytes, Random&) { bytes += bytes; },
      [](std::string& bytes, Random&) { bytes.erase(0, 128); },
      withoutElement(0x0020000E),
      withoutElement(0x00200032),
      withoutElement(0x00200037),
      withoutElement(0x00280030),
      withoutElement(0x00181060),
      withoutElement(0x00181062),
      withoutElement(0x7FE00010),
      withElement(0x00181060, "DSnan"),
      withElement(0x00181060, "DS1e308"),
      withElement(0x00181060, "DS-5"),
      withElement(0x00181062, "IS-1"),
      withElement(0x00181090, "IS2147483647"),
      withElement(0x00200032, "DS1e30\\0\\0"),
      withElement(0x00200037, "DS1\\0\\0\\1\\0\\0"),
      withElement(0x00280030, "DS0\\0"),
      withElement(0x00280010, tests::us(60000)),
      withElement(0x00280100, tests::us(32)),
      withElement(0x00180050, "DS-3"),
  };
}

void expectSound(const CineStudy& study) {
  for (const CineSlice& slice : study.slices) {
    ASSERT_GE(slice.fractions.size(), 2U);
    for (std::size_t phase = 0; phase < slice.fractions.size(); ++phase) {
      ASSERT_GE(slice.fractions[phase], phase == 0 ? 0 : std::nextafter(slice.fractions[phase - 1], 2));
      ASSERT_LT(slice.fractions[phase], 1);
      const auto image = slice.image(phase);
      ASSERT_EQ(image->rows(), slice.geometry.rows);
      ASSERT_EQ(image->cols(), slice.geometry.columns);
    }
    ASSERT_TRUE(std::isfinite(slice.interval) && slice.interval >= 0);
    ASSERT_GE(slice.geometry.thickness, 0);
    for (const double missing : slice.missing)
      ASSERT_TRUE(missing >= 0 && missing < 1) << missing;
  }
  for (const CineStack& stack : study.stacks) {
    ASSERT_EQ(stack.distances.size() + 1, stack.slices.size());
    for (const double gap : stack.gaps)
      ASSERT_GE(gap, 0);
  }
}

/// Two series of four phases; only files of the first one are damaged.
class DamagedCine : public testing::Test {
protected:
  DamagedCine() {
    for (const int series : {1, 2})
      for (int phase = 0; phase < 4; ++phase) {
        CinePicture picture = tests::shortAxisPicture(series, 10.0 * series, 800);
        picture.phases = 4;
        picture.phase = phase;
        const std::string bytes = tests::dicomBytes(tests::cineElements(picture));
        files_.emplace_back(folder_.put(tests::cineFileName(picture), bytes), bytes);
      }
  }

  /// Damages one file for each seed; gives how often the other series was read whole.
  int wholeAfter(unsigned first, unsigned last) {
    const std::vector<Damage> kinds = damages();
    EXPECT_EQ(kinds.size(), 30U);
    int whole = 0;
    for (unsigned seed = first; seed < last; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(seed);
      const auto& [file, bytes] = files_[upTo(random, 3)];
      std::string damaged = bytes;
      kinds[seed % kinds.size()](damaged, random);
      folder_.put(file.filename().string(), damaged);
      try {
        Progress progress;
        const CineStudy study = readCineStudy(folder_.path(), progress);
        expectSound(study);
        for (const CineSlice& slice : study.slices)
          whole += slice.number == 2 && slice.fractions.size() == 4 ? 1 : 0;
      } catch (const Error& error) {
        EXPECT_NE(error.problem().english(), "");
      }
      folder_.put(file.filename().string(), bytes);
    }
    return whole;
  }

  tests::TemporaryFolder folder_;
  std::vector<std::pair<std::filesystem::path, std::string>> files_;
};

// The rest is read, or an error says why not, as where the patient's number is damaged: never a crash, and
// never a picture that no file has.
TEST_F(DamagedCine, LeavesTheRestReadable) {
  EXPECT_GE(wholeAfter(0, 150), 135);
}

TEST_F(DamagedCine, LeavesTheRestReadableWithOtherSeeds) {
  EXPECT_GE(wholeAfter(150, 300), 135);
}

} // namespace
} // namespace viscera::medical_io
