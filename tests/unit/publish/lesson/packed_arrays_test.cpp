#include "viscera/lesson/packed_arrays.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::lesson {
namespace {

std::vector<std::int32_t> randomIntegers(std::int32_t low, std::int32_t high) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int32_t> any(low, high);
  std::vector<std::int32_t> values(3001);
  for (std::int32_t& value : values)
    value = any(random);
  values[5] = low;
  values[6] = high;
  return values;
}

} // namespace

TEST(PackedArrays, ComeBackInEveryWidth) {
  const std::vector<std::pair<std::int32_t, int>> widths = {
      {127, 1}, {128, 2}, {32767, 2}, {32768, 3}, {8388607, 3}, {8388608, 4}, {2147483647, 4}};
  for (const auto& [most, width] : widths)
    for (const int stride : {1, 3}) {
      ArrayPacker packer;
      const std::vector<std::int32_t> values = randomIntegers(-most, most);
      packer.add(std::vector<std::int32_t>{1, 2, 3}, 1);
      const PackedArray array = packer.add(values, stride);
      EXPECT_EQ(array.width, width) << most;
      EXPECT_EQ(array.at % 4, 0u);
      const std::vector<double> found = unpacked(array, packer.bytes());
      ASSERT_EQ(found.size(), values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(found[i], values[i]) << most << " at " << i;
    }
}

TEST(PackedArrays, AreRoundedToTheStep) {
  ArrayPacker packer;
  const PackedArray array = packer.add({0.004, -0.006, 12.344, 12.347}, 1, 0.01);
  const std::vector<double> found = unpacked(array, packer.bytes());
  EXPECT_NEAR(found[0], 0, 1e-12);
  EXPECT_NEAR(found[1], -0.01, 1e-12);
  EXPECT_NEAR(found[2], 12.34, 1e-12);
  EXPECT_NEAR(found[3], 12.35, 1e-12);
}

TEST(PackedArrays, KeepFloatsToTheBit) {
  ArrayPacker packer;
  const std::vector<float> values = {1.5f, -0.0f, 3.1415927f, 1e-30f};
  const PackedArray array = packer.addFloats(values);
  const std::vector<double> found = unpacked(array, packer.bytes());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(static_cast<float>(found[i]), values[i]);
}

TEST(PackedArrays, RefuseWhatDoesNotFit) {
  ArrayPacker packer;
  EXPECT_THROW(packer.add({1e12}, 1, 0.01), DataError);
  EXPECT_THROW(packer.add({std::nan("")}, 1, 0.01), DataError);
  EXPECT_THROW(unpacked(PackedArray{0, 5, 4, 1, 1}, "short"), DataError);
}

TEST(PackedArrays, OfSmoothNumbersDeflateToLittle) {
  ArrayPacker packer;
  std::vector<double> smooth;
  for (int i = 0; i < 30000; ++i)
    smooth.push_back(40 * std::sin(1e-3 * i));
  packer.add(smooth, 3, 0.01);
  EXPECT_LT(deflated(packer.bytes()).size(), smooth.size());
  EXPECT_EQ(inflated(deflated(packer.bytes())), packer.bytes());
  EXPECT_THROW(inflated("no zlib stream"), DataError);
}

} // namespace viscera::lesson
