#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {
namespace {

std::string labelled(const std::string& name, const Presenter::Translate& translate = {}) {
  return labelOf(document::makeOrgan(name, tests::sphere(1, 10)), translate);
}

TEST(OrganNames, OfPartsOfTheBodyAreTheirTitles) {
  EXPECT_EQ(labelled("small_bowel"), "Small bowel");
  EXPECT_EQ(labelled("kidney_left"), "Left kidney");
  EXPECT_EQ(labelled("Kidney left"), "Left kidney");
  EXPECT_EQ(labelled("liver"), "Liver");
  EXPECT_EQ(labelled("LV"), "LV cavity") << "as it was";
}

/// As TotalSegmentator and others write them: the words of a title, in any order and with underscores.
TEST(OrganNames, OfEveryOrganOfTheTableReadAsItsTitleHoweverItIsWritten) {
  for (const anatomy::OrganFacts& facts : anatomy::organs()) {
    const std::string title(facts.title);
    std::string written = title;
    for (char& letter : written)
      letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    const std::string said = labelled(written);
    EXPECT_EQ(said.find('_'), std::string::npos) << written;
    EXPECT_FALSE(std::islower(static_cast<unsigned char>(said[0]))) << written << " is " << said;
  }
}

TEST(OrganNames, OfOtherThingsKeepAllTheirWords) {
  EXPECT_EQ(labelled("left_kidney_tumour_2"), "Left kidney tumour 2");
  EXPECT_EQ(labelled("Model_51_right_kidney"), "Model 51 right kidney");
  EXPECT_EQ(labelled("__"), "__") << "nothing else is left of it";
  EXPECT_EQ(labelled("A name of somebody"), "A name of somebody");
  EXPECT_EQ(labelled("\xc3\xa4sthetisch_x"), "\xc3\xa4sthetisch x") << "UTF-8 stays whole";
}

TEST(OrganNames, AreTranslatedAsTheyAreWrittenOrByTheirTitle) {
  const Presenter::Translate german = [](const char* text) -> std::string {
    const std::string said = text;
    return said == "Kidney left" ? "Linke Niere" : said == "Small bowel" ? "D\xc3\xbcnndarm" : said;
  };
  EXPECT_EQ(labelled("Kidney left", german), "Linke Niere");
  EXPECT_EQ(labelled("small_bowel", german), "D\xc3\xbcnndarm");
}

} // namespace
} // namespace viscera::presentation
