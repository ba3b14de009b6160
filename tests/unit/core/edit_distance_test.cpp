#include <algorithm>
#include <string_view>

#include <gtest/gtest.h>

#include "viscera/core/edit_distance.h"

namespace viscera {
namespace {

TEST(EditDistance, CountsWhatIsChangedAddedAndRemoved) {
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(editDistance("heart", "heart"), 0u);
  EXPECT_EQ(editDistance("heart", "haert"), 2u) << "two changes";
  EXPECT_EQ(editDistance("liver", "livers"), 1u);
  EXPECT_EQ(editDistance("spleen", "splen"), 1u);
}

TEST(EditDistance, OfAnEmptyTextIsTheLengthOfTheOther) {
  EXPECT_EQ(editDistance("", ""), 0u);
  EXPECT_EQ(editDistance("", "aorta"), 5u);
  EXPECT_EQ(editDistance("aorta", ""), 5u);
}

TEST(EditDistance, IsTheSameInBothDirectionsAndNeverLessThanTheDifferenceInLength) {
  const char* names[] = {"systemicCompliance", "pulmonaryCompliance", "laTau", "raTau", "rate"};
  for (const char* a : names)
    for (const char* b : names) {
      EXPECT_EQ(editDistance(a, b), editDistance(b, a)) << a << ", " << b;
      const std::string_view one = a, other = b;
      const std::size_t longer = std::max(one.size(), other.size());
      EXPECT_GE(editDistance(a, b), longer - std::min(one.size(), other.size()));
      EXPECT_LE(editDistance(a, b), longer);
    }
}

} // namespace
} // namespace viscera
