#include "viscera/live/unsuited_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viscera/live/sequence_setup.h"

namespace viscera::live {

using testing::HasSubstr;

TEST(UnsuitedMotion, OfAShippedSequenceIsSaidWithBothOrgans) {
  const std::string liver = unsuitedTo("heartbeat", "liver").english();
  EXPECT_THAT(liver, HasSubstr("Heartbeat is made for another organ (Heart) than this one (Liver)"));
  EXPECT_THAT(unsuitedTo("breathing", "adrenal_gland_left").english(), HasSubstr("adrenal"));
  EXPECT_THAT(unsuitedTo("peristalsis", "Model_3_left_kidney").english(), HasSubstr("(Left kidney)"));
  EXPECT_FALSE(unsuitedTo("breathing", "LV cavity").empty());
}

TEST(UnsuitedMotion, IsNoneWhereTheOrganSuitsOrItsNameSaysNone) {
  for (const char* heart :
       {"heart", "Herz", "sample:heart", "heart_myocardium", "LV cavity", "mesh 1", "patient", ""})
    EXPECT_TRUE(unsuitedTo("heartbeat", heart).empty()) << heart;
  EXPECT_TRUE(unsuitedTo("breathing", "liver tumour").empty());
  EXPECT_TRUE(unsuitedTo("breathing", "Leber.stl").empty());
  EXPECT_TRUE(unsuitedTo("no such sequence", "liver").empty());
}

TEST(UnsuitedMotion, OfARecordedSequenceGoesByTheOrgansThatItWasRecordedOf) {
  const std::vector<std::string> heart{"EPI", "LV cavity", "RV cavity"};
  EXPECT_THAT(unsuitedTo(heart, "liver").english(), HasSubstr("recorded of another organ"));
  EXPECT_TRUE(unsuitedTo(heart, "heart").empty());
  EXPECT_TRUE(unsuitedTo(heart, "patient").empty());
  EXPECT_TRUE(unsuitedTo(std::vector<std::string>{"outer"}, "liver").empty());
  EXPECT_TRUE(unsuitedTo(std::vector<std::string>{}, "liver").empty());
}

} // namespace viscera::live
