#include <gtest/gtest.h>

#include "viscera/anatomy/part.h"

namespace viscera::anatomy {
namespace {

TEST(ReadableName, OfAPartIsItsTitleInWhateverOrderItsWordsStand) {
  EXPECT_EQ(readableName("kidney_left"), "Left kidney");
  EXPECT_EQ(readableName("Kidney left"), "Left kidney");
  EXPECT_EQ(readableName("small_bowel"), "Small bowel");
}

/// As TotalSegmentator writes them.
TEST(ReadableName, OfBonesAndLobesIsAsPeopleWriteIt) {
  EXPECT_EQ(readableName("rib_left_7"), "Left rib 7");
  EXPECT_EQ(readableName("rib_right_12"), "Right rib 12");
  EXPECT_EQ(readableName("vertebrae_L1"), "Vertebra L1");
  EXPECT_EQ(readableName("vertebrae_T12"), "Vertebra T12");
  EXPECT_EQ(readableName("lung_upper_lobe_left"), "Upper lobe of the left lung");
  EXPECT_EQ(readableName("lung_middle_lobe_right"), "Middle lobe of the right lung");
  EXPECT_EQ(readableName("autochthon_left"), "Left deep back muscles");
}

TEST(ReadableName, SaysTheSideFirst) {
  EXPECT_EQ(readableName("iliac_artery_left"), "Left iliac artery");
  EXPECT_EQ(readableName("gluteus_maximus_right"), "Right gluteus maximus");
  EXPECT_EQ(readableName("kidney_left_2"), "Left kidney 2");
  EXPECT_EQ(readableName("Pump right"), "Pump right") << "no organ, so nobody's right side";
}

TEST(ReadableName, OfAChamberSaysWhichOne) {
  EXPECT_EQ(readableName("patient1_RV_ENDOCARDIAL"), "Right ventricle (patient1)");
  EXPECT_EQ(readableName("heart_ventricle_left"), "Left ventricle");
  EXPECT_EQ(readableName("LV_endo_ED"), "Left ventricle (ED)");
  EXPECT_EQ(readableName("LV cavity"), "LV cavity") << "as people write";
  EXPECT_EQ(readableName("LV wall"), "LV wall") << "its wall is no cavity";
}

TEST(ReadableName, KeepsWhatItDoesNotKnow) {
  EXPECT_EQ(readableName("small_vein_2"), "Small vein 2");
  EXPECT_EQ(readableName("Model_51_right_kidney"), "Model 51 right kidney");
  EXPECT_EQ(readableName("left_kidney_tumour_2"), "Left kidney tumour 2");
  EXPECT_EQ(readableName("2"), "2");
  EXPECT_EQ(readableName("__"), "__");
  EXPECT_EQ(readableName(""), "");
}

} // namespace
} // namespace viscera::anatomy
