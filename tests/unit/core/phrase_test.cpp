#include "viscera/core/phrase.h"

#include <cstdint>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace viscera {
namespace {

/// A language of few words, in which a pattern says which form of it is used.
Wording german() {
  static const std::map<std::string, std::string> words = {
      {"Open %1", "%1 öffnen"},
      {"Open heart", "Herz öffnen"},
      {"heart", "Herz"},
      {"Septum", "Scheidewand"},
      {"%2 of %1", "von %1 das %2"},
      {"%1 of %n {voxel|voxels}", "%1 von %n Voxeln"},
      {"over %1 ml", "über %1 ml"},
      {"it is empty", "ärmlich leer"},
      {"The file cannot be read: %1", "Die Datei kann nicht gelesen werden: %1"},
      {"Internal error: %1", "Interner Fehler: %1"},
  };
  const auto translate = [](const std::string& pattern, std::optional<int> number) -> std::string {
    if (pattern == "Lock %n {handle|handles}")
      return number == 1 ? "Griff sperren" : "%n Griffe sperren";
    if (pattern == "Hide %n {handle|handles}") // Qt puts the number into its place itself.
      return number == 1 ? "Griff verbergen" : std::to_string(number.value_or(0)) + " Griffe verbergen";
    const auto found = words.find(pattern);
    return found == words.end() ? std::string() : found->second;
  };
  return {translate, ","};
}

std::string inGerman(const Text& text) {
  return inWords(text, german());
}

} // namespace

TEST(Phrase, PutsItsPartsInTheirPlaces) {
  EXPECT_EQ(phrase("%2 of %1", "heart", 4).english(), "4 of heart");
  EXPECT_EQ(phrase("No places").english(), "No places");
  EXPECT_EQ(phrase("%1", std::uint64_t{1} << 40).english(), "1099511627776");
  EXPECT_EQ(phrase("%1", std::numeric_limits<std::int64_t>::min()).english(), "-9223372036854775808");
}

TEST(Phrase, ChoosesTheFormForItsNumber) {
  const auto said = [](auto count) {
    return phrase("%n {triangle has|triangles have} no area", count).english();
  };
  EXPECT_EQ(said(1), "1 triangle has no area");
  EXPECT_EQ(said(17), "17 triangles have no area");
  EXPECT_EQ(said(std::uint64_t{1} << 40), "1099511627776 triangles have no area");
  EXPECT_EQ(phrase("{%2 lies|%2 lie} outside", 1, "liver").english(), "liver lies outside");
  EXPECT_EQ(phrase("%n cap{|s}", 1).english(), "1 cap");
}

TEST(Phrase, LeavesWhatIsNoPlaceAndWhatItsPartsSay) {
  EXPECT_EQ(phrase("50 % of {all}, %3", "a").english(), "50 % of {all}, %3");
  EXPECT_EQ(phrase("Open %1", std::string("%1 {a|b}")).english(), "Open %1 {a|b}");
  EXPECT_EQ(phrase("Open %1", named("%1 {a|b}")).english(), "Open %1 {a|b}");
  EXPECT_EQ(inGerman(phrase("Open %1", named("Open %1"))), "Open %1 öffnen") << "a name has no places";
}

TEST(Text, IsEmptyOnlyWithoutAnything) {
  EXPECT_TRUE(Text().empty());
  EXPECT_TRUE(Text("").empty());
  EXPECT_TRUE(Text(std::string()).empty());
  EXPECT_TRUE(named("").empty());
  EXPECT_TRUE(listOf({}).empty());
  EXPECT_TRUE(Text().capitalised().empty());
  EXPECT_EQ(Text().english(), "");
  EXPECT_FALSE(Text("heart").empty());
  EXPECT_FALSE(Text(0).empty());
}

TEST(Text, TranslatesPatternsAndPartsOfParts) {
  const Text inside = phrase("%2 of %1", "heart", 4);
  EXPECT_EQ(phrase("Open %1", inside).english(), "Open 4 of heart");
  EXPECT_EQ(inGerman(phrase("Open %1", inside)), "von Herz das 4 öffnen");
  EXPECT_EQ(inGerman(phrase("Nobody translated %1", "heart")), "Nobody translated Herz");
}

TEST(Text, LeavesWhatIsVerbatimAsItIs) {
  const std::string name = "heart";
  EXPECT_EQ(inGerman(Text("heart")), "Herz");
  EXPECT_EQ(inGerman(Text(name)), "heart");
  EXPECT_EQ(inGerman(phrase("Open %1", name)), "heart öffnen");
  EXPECT_EQ(inGerman(phrase("Open %1", std::string("Open heart"))), "Open heart öffnen");
}

TEST(Text, TranslatesANameExactlyOrBeforeItsNumber) {
  EXPECT_EQ(inGerman(named("heart")), "Herz");
  EXPECT_EQ(inGerman(named("Septum 12")), "Scheidewand 12");
  EXPECT_EQ(inGerman(named("Septum (patient1)")), "Scheidewand (patient1)");
  EXPECT_EQ(inGerman(named("Unknown (Septum)")), "Unknown (Septum)");
  EXPECT_EQ(inGerman(named("heart of mine")), "heart of mine");
  EXPECT_EQ(named("Septum 12").english(), "Septum 12");
}

TEST(Text, WritesNumbersWithTheMarkOfTheLanguage) {
  EXPECT_EQ(inFixed(83.44, 1).english(), "83.4");
  EXPECT_EQ(inDigits(0.25).english(), "0.25");
  EXPECT_EQ(inGerman(phrase("over %1 ml", inFixed(83.44, 1))), "über 83,4 ml");
  EXPECT_EQ(inGerman(inDigits(2.5)), "2,5");
  EXPECT_EQ(inGerman(Text(std::string("v1.2.stl"))), "v1.2.stl") << "no number, but a name";
}

TEST(Text, HasTheFormOfTheLanguageForItsNumber) {
  EXPECT_EQ(inGerman(phrase("Lock %n {handle|handles}", 1)), "Griff sperren");
  EXPECT_EQ(inGerman(phrase("Lock %n {handle|handles}", 3)), "3 Griffe sperren");
  EXPECT_EQ(inGerman(phrase("Hide %n {handle|handles}", 3)), "3 Griffe verbergen");
  EXPECT_EQ(inGerman(phrase("Hide %n {handle|handles}", std::uint64_t{1} << 40)),
            "1099511627776 Griffe verbergen")
      << "although no form of Qt counts so far";
}

TEST(Text, JoinsAListAndTranslatesItsTexts) {
  const Text list = listOf({"heart", std::string("heart"), inFixed(1.5, 1), 7});
  EXPECT_EQ(list.english(), "heart, heart, 1.5, 7");
  EXPECT_EQ(inGerman(list), "Herz, heart, 1,5, 7");
  EXPECT_EQ(inGerman(phrase("Open %1", listOf({"heart"}))), "Herz öffnen");
}

TEST(Text, KeepsADiagnosticInEnglishBehindOneSentence) {
  const Text broken = diagnostic("the %1 of %n {voxel is|voxels are} %2", 1, "heart");
  EXPECT_EQ(broken.english(), "the 1 of 1 voxel is heart");
  EXPECT_EQ(inGerman(broken), "Die Datei kann nicht gelesen werden: the 1 of 1 voxel is heart");
  EXPECT_EQ(inGerman(diagnostic("%1 mm", inFixed(2.5, 1))), "Die Datei kann nicht gelesen werden: 2.5 mm")
      << "English to its last part";
  const std::string_view piece = "heart";
  EXPECT_EQ(diagnostic("\"%1\" is no number", piece).english(), "\"heart\" is no number");
  EXPECT_EQ(inWords(broken, {}), broken.english()) << "without a translation, the sentence is left out";
}

TEST(Text, KeepsAMisuseInEnglishBehindAnotherSentence) {
  const Text misused = misuse("there is no view %1", "heart");
  EXPECT_EQ(misused.english(), "there is no view heart");
  EXPECT_EQ(inGerman(misused), "Interner Fehler: there is no view heart");
  EXPECT_FALSE(misused == diagnostic("there is no view %1", "heart"));
}

TEST(Text, SaysTheSentenceBeforeEnglishOnceAndNotWithinAnother) {
  const Text broken = diagnostic("it is cut off");
  EXPECT_EQ(inGerman(phrase("%1: %2", std::string("a.stl"), broken)),
            "a.stl: Die Datei kann nicht gelesen werden: it is cut off");
  EXPECT_EQ(inGerman(phrase("%1 (%2)", broken, diagnostic("at byte %1", 7))),
            "Die Datei kann nicht gelesen werden: it is cut off (at byte 7)");
  EXPECT_EQ(inGerman(phrase("Open %1", broken)), "it is cut off \u00f6ffnen");
  EXPECT_EQ(inGerman(diagnostic("line %1: %2", 3, broken)),
            "Die Datei kann nicht gelesen werden: line 3: it is cut off");
}

TEST(Text, BeginsWithACapitalInEachLanguage) {
  const Text empty = Text("it is empty").capitalised();
  EXPECT_EQ(empty.english(), "It is empty");
  EXPECT_EQ(inGerman(empty), "Ärmlich leer");
  EXPECT_EQ(inGerman(diagnostic("it is empty").capitalised()),
            "Die Datei kann nicht gelesen werden: it is empty");
  EXPECT_EQ(diagnostic("it is empty").capitalised().english(), "It is empty");
  EXPECT_EQ(empty.capitalised(), empty);
}

TEST(Text, IsEqualToOneMadeInTheSameWay) {
  EXPECT_EQ(phrase("Open %1", std::string("heart")), phrase("Open %1", std::string("heart")));
  EXPECT_EQ(Text(), Text(""));
  const Text text = phrase("Open %1", named("heart"));
  const Text copy = text;
  EXPECT_EQ(copy, text);
  const std::vector<Text> alike = {phrase("Open %1", "heart"),        phrase("Open %1", std::string("heart")),
                                   phrase("Open %1", named("heart")), Text("Open heart"),
                                   Text(std::string("Open heart")),   diagnostic("Open %1", "heart"),
                                   misuse("Open %1", "heart")};
  for (std::size_t i = 0; i < alike.size(); ++i)
    for (std::size_t j = 0; j < alike.size(); ++j)
      EXPECT_EQ(alike[i] == alike[j], i == j) << i << " " << j << ": equal only in English";
  EXPECT_FALSE(Text("heart") == Text());
}

TEST(Text, IsEnglishInStreamsAndLists) {
  std::ostringstream out;
  out << phrase("over %1 ml", inFixed(2, 1));
  EXPECT_EQ(out.str(), "over 2.0 ml");
  EXPECT_EQ(inEnglish({"heart", Text(), 3}), (std::vector<std::string>{"heart", "", "3"}));
}

TEST(NumberAtEnd, BeginsWithItsSpaceBehindAName) {
  EXPECT_EQ(numberAtEnd("Septum 12"), 6u);
  EXPECT_EQ(numberAtEnd("Vertebra L1"), 8u) << "with the letter of its part of the spine";
  EXPECT_EQ(numberAtEnd("LV free wall 3"), 12u);
  for (const std::string_view none : {"", "Septum", "H-3", "Septum ", " 12", "12", "Septum 1a", "Septum 1.5"})
    EXPECT_EQ(numberAtEnd(none), none.size()) << none;
}

} // namespace viscera
