#include "viscera/core/phrase.h"

#include <cstdint>
#include <string_view>

#include <gtest/gtest.h>

namespace viscera {

TEST(Phrase, PutsItsPartsInTheirPlaces) {
  EXPECT_EQ(phrase("%2 of %1", "heart", 4), "4 of heart");
  EXPECT_EQ(phrase("No places"), "No places");
  EXPECT_EQ(phrase("%1", std::uint64_t{1} << 40), "1099511627776");
}

TEST(Phrase, ChoosesTheFormForItsNumber) {
  const auto said = [](int count) { return phrase("%n {triangle has|triangles have} no area", count); };
  EXPECT_EQ(said(1), "1 triangle has no area");
  EXPECT_EQ(said(17), "17 triangles have no area");
  EXPECT_EQ(phrase("{%2 lies|%2 lie} outside", 1, "liver"), "liver lies outside");
  EXPECT_EQ(phrase("%n cap{|s}", 1), "1 cap");
}

TEST(Phrase, LeavesWhatIsNoPlaceAndWhatItsPartsSay) {
  EXPECT_EQ(phrase("50 % of {all}, %3", "a"), "50 % of {all}, %3");
  EXPECT_EQ(phrase("Open %1", "%1 {a|b}"), "Open %1 {a|b}");
}

TEST(NumberAtEnd, BeginsWithItsSpaceBehindAName) {
  EXPECT_EQ(numberAtEnd("Septum 12"), 6u);
  EXPECT_EQ(numberAtEnd("LV free wall 3"), 12u);
  for (const std::string_view none : {"", "Septum", "H-3", "Septum ", " 12", "12", "Septum 1a", "Septum 1.5"})
    EXPECT_EQ(numberAtEnd(none), none.size()) << none;
}

} // namespace viscera
