#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "names_of_atlases.h"
#include "names_of_organs.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"

namespace viscera::anatomy {
namespace {

/// "kidney left lesion"; empty for none.
std::string inWords(const std::optional<Part>& part) {
  if (!part)
    return {};
  std::string text(part->organ);
  const auto add = [&](bool is, const char* word) { text += is ? std::string(" ") + word : std::string(); };
  add(part->side == Side::left, "left");
  add(part->side == Side::right, "right");
  add(part->chamber == Chamber::ventricle, "ventricle");
  add(part->chamber == Chamber::atrium, "atrium");
  add(part->extent == Extent::piece, "piece");
  add(part->extent == Extent::lesion, "lesion");
  return text;
}

template <std::size_t N>
int expectAll(const names::Named (&all)[N]) {
  for (const names::Named& one : all)
    EXPECT_EQ(inWords(partNamed(one.name)), one.part) << one.name;
  return static_cast<int>(N);
}

TEST(PartNamed, KnowsTheNamesOfElevenSources) {
  using namespace names;
  const int count = expectAll(kTotalSegmentator) + expectAll(kOtherTasks) + expectAll(kSlicer) +
                    expectAll(kAbdominalAtlas) + expectAll(kBrain) + expectAll(kLatin) + expectAll(kGerman) +
                    expectAll(kFrench) + expectAll(kSpanish) + expectAll(kCatalan) + expectAll(kFiles);
  EXPECT_GE(count, 300);
}

TEST(PartNamed, KnowsTheNamesOfTenFurtherAtlases) {
  using namespace names;
  const int count = expectAll(kAmos) + expectAll(kBtcv) + expectAll(kChaos) + expectAll(kFlare) +
                    expectAll(kWholeHeart) + expectAll(kAcdc) + expectAll(kSegThor) + expectAll(kKits) +
                    expectAll(kVerse) + expectAll(kBodyParts) + expectAll(kZAnatomy);
  EXPECT_GE(count, 100);
}

TEST(PartNamed, MakesNoOrganOfWhatIsNone) {
  for (const char* name : names::kNoOrgans)
    EXPECT_EQ(inWords(partNamed(name)), "") << name;
  EXPECT_GE(std::size(names::kNoOrgans), 60U);
}

TEST(PartNamed, DoesNotMindCaseSeparatorsAndEndingsOfFiles) {
  for (const char* name : {"kidney_left", "KIDNEY-LEFT", "Left Kidney", "left.kidney.nii.gz", "KidneyLeft",
                           "  kidney,left  ", "kidney (left) 2", "p17_left_kidney_v2.stl"})
    EXPECT_EQ(partNamed(name), (Part{"kidney", Side::left})) << name;
}

TEST(PartNamed, TakesACodeBeforeASidedOrganForThatOfAFile) {
  EXPECT_EQ(partNamed("pat_07-rein gauche.stl"), (Part{"kidney", Side::left}));
  EXPECT_EQ(partNamed("A08_Ren dexter"), (Part{"kidney", Side::right}));
  EXPECT_EQ(partNamed("pat_02-rate.stl"), (Part{"spleen"}));
  EXPECT_EQ(partNamed("T1_cor"), std::nullopt) << "a coronal image";
}

TEST(PartNamed, ReadsBytesThatAreNoTextWithoutFault) {
  EXPECT_EQ(partNamed("liver \xC3"), (Part{"liver"}));
  EXPECT_EQ(partNamed("\xFFliver"), std::nullopt) << "a letter of Latin-1 belongs to the word";
  EXPECT_EQ(partNamed("\xE8\x82\x9D"), std::nullopt);
}

TEST(PartNamed, FindsTheSameInTheTitlesThatItGives) {
  for (const OrganFacts& facts : organs()) {
    EXPECT_EQ(partNamed(titleOf({facts.id})), (Part{facts.id})) << facts.title;
    for (const Side side : {Side::left, Side::right}) {
      const bool sided = facts.place == Place::eitherSide || facts.place == Place::anywhere;
      EXPECT_EQ(partNamed(titleOf({facts.id, side})), (Part{facts.id, sided ? side : Side::none}))
          << facts.title;
    }
  }
  for (const Part& chamber : {kLeftVentricle, kRightVentricle, kLeftAtrium, kRightAtrium}) {
    EXPECT_EQ(partNamed(titleOf(chamber)), chamber);
    EXPECT_EQ(partNamed(abbreviationOf(chamber)), chamber);
  }
}

TEST(ChamberNamed, FindsCavitiesAndNeitherWallsNorMuscle) {
  for (const char* left :
       {"LV", "LV cavity", "heart_ventricle_left", "left ventricle of heart", "patient1_LV_ENDOCARDIAL"})
    EXPECT_EQ(chamberNamed(left), kLeftVentricle) << left;
  for (const char* right : {"rv", "patient1_RV_ENDOCARDIAL", "right ventricle"})
    EXPECT_EQ(chamberNamed(right), kRightVentricle) << right;
  EXPECT_EQ(chamberNamed("left_atrium"), kLeftAtrium);
  EXPECT_EQ(chamberKey("LV cavity"), "lv");
  EXPECT_EQ(chamberKey("Heart/la"), "la");
  EXPECT_EQ(chamberKey("patient1_RV_ENDOCARDIAL"), "rv");
  EXPECT_EQ(chamberKey("myocardium"), "");
  using Keys = std::vector<std::pair<std::string, std::size_t>>;
  EXPECT_EQ(chamberKeys({"Heart", "LV cavity", "Left ventricle", "RA"}), (Keys{{"lv", 1}, {"ra", 3}}));
  EXPECT_EQ(chamberKeys({"lv", "LV cavity"}), Keys()) << "there already";
  EXPECT_EQ(chamberNamed("RA"), kRightAtrium);
  for (const char* other :
       {"Heart", "lv_wall", "LV myocardium", "EPICARDIAL", "left kidney", "liver", "lavage", ""})
    EXPECT_EQ(chamberNamed(other), std::nullopt) << other;
}

TEST(ColorNamed, IsOneForAnOrganHoweverItIsWritten) {
  std::set<std::array<double, 3>> colors;
  for (const char* name : {"liver", "Liver.stl", "Leber", "foie", "h\u00edgado", "fetge", "Hepar",
                           "caudate lobe", "patient_7_liver", "liver_segment_2"}) {
    const std::optional<Vec3> color = colorNamed(name);
    ASSERT_TRUE(color) << name;
    colors.insert({color->x(), color->y(), color->z()});
  }
  EXPECT_EQ(colors.size(), 1U);
}

TEST(ColorNamed, TellsNeighboursInTheAbdomenApart) {
  constexpr double kTold = 0.15; // Red, green and blue from 0 to 1.
  const std::pair<const char*, const char*> neighbours[] = {
      {"liver", "stomach"},   {"liver", "gallbladder"}, {"liver", "kidney_right"},
      {"liver", "pancreas"},  {"stomach", "spleen"},    {"stomach", "pancreas"},
      {"spleen", "pancreas"}, {"spleen", "liver"},      {"small_bowel", "liver"}};
  for (const auto& [one, other] : neighbours)
    EXPECT_GT((*colorNamed(one) - *colorNamed(other)).norm(), kTold) << one << " beside " << other;
}

TEST(ColorNamed, TellsBloodAndLesionsFromTissue) {
  EXPECT_EQ(colorNamed("LV"), colorOf(kLeftVentricle));
  EXPECT_EQ(colorNamed("lv_wall"), colorOf(kHeart)) << "muscle";
  EXPECT_EQ(colorNamed("liver tumour"), colorNamed("tumour_b"));
  EXPECT_NE(colorNamed("liver tumour"), colorNamed("liver"));
  EXPECT_EQ(colorNamed("pulmonary_artery"), colorNamed("inferior_vena_cava")) << "venous blood";
  EXPECT_EQ(colorNamed("stomach and duodenum"), colorNamed("stomach")) << "of several, the first";
  for (const char* name : {"", "label 5", "background", "no liver", "Segment_1"})
    EXPECT_EQ(colorNamed(name), std::nullopt) << name;
}

TEST(VolumeNorm, IsOfTheWholeOrganOnTheRightSide) {
  const auto rowOf = [](const char* name) {
    const Norm* row = volumeNormOf(*partNamed(name));
    return row ? row->id : std::string();
  };
  EXPECT_EQ(rowOf("liver"), "liver.volume");
  EXPECT_EQ(rowOf("Kidney_left 2"), "kidney.left");
  EXPECT_EQ(rowOf("rechte Niere"), "kidney.right");
  EXPECT_EQ(rowOf("myocardium"), "heart.muscle");
  for (const char* other :
       {"liver tumour", "caudate lobe", "renal pelvis", "LV", "LV myocardium", "lung_left"})
    EXPECT_EQ(rowOf(other), "") << other;
}

TEST(BodySide, IsOfTheOrganOrOfItsName) {
  EXPECT_EQ(bodySideOf({"liver"}), Side::right);
  EXPECT_EQ(bodySideOf({"spleen"}), Side::left);
  EXPECT_EQ(bodySideOf({"kidney", Side::left}), Side::left);
  EXPECT_EQ(bodySideOf({"kidney"}), Side::none);
  EXPECT_EQ(bodySideOf(kLeftVentricle), Side::none) << "the left side of the heart is no side of the body";
  EXPECT_EQ(bodySideOf({"liver", Side::none, Chamber::none, Extent::lesion}), Side::none);
}

/// The digit at its end checks an identifier of SNOMED CT (Verhoeff).
bool isSnomedId(std::string_view id) {
  static constexpr int kTimes[10][10] = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 3, 4, 0, 6, 7, 8, 9, 5},
                                         {2, 3, 4, 0, 1, 7, 8, 9, 5, 6}, {3, 4, 0, 1, 2, 8, 9, 5, 6, 7},
                                         {4, 0, 1, 2, 3, 9, 5, 6, 7, 8}, {5, 9, 8, 7, 6, 0, 4, 3, 2, 1},
                                         {6, 5, 9, 8, 7, 1, 0, 4, 3, 2}, {7, 6, 5, 9, 8, 2, 1, 0, 4, 3},
                                         {8, 7, 6, 5, 9, 3, 2, 1, 0, 4}, {9, 8, 7, 6, 5, 4, 3, 2, 1, 0}};
  static constexpr int kTurn[10] = {1, 5, 7, 6, 2, 8, 3, 0, 9, 4};
  int sum = 0;
  for (std::size_t i = 0; i < id.size(); ++i) {
    int digit = id[id.size() - 1 - i] - '0';
    for (std::size_t turn = 0; turn < i % 8; ++turn)
      digit = kTurn[digit];
    sum = kTimes[sum][digit];
  }
  return sum == 0;
}

TEST(TableOfOrgans, HasWholeRows) {
  std::set<std::string_view> ids, codes;
  for (const OrganFacts& facts : organs()) {
    EXPECT_TRUE(ids.insert(facts.id).second) << facts.id << " is there twice";
    EXPECT_FALSE(facts.title.empty() || facts.words.empty()) << facts.id;
    EXPECT_NE(std::find(organSystems().begin(), organSystems().end(), facts.system), organSystems().end());
    EXPECT_GT(facts.color[0] + facts.color[1] + facts.color[2], 0) << facts.id;
    EXPECT_TRUE(facts.snomed.empty() || (isSnomedId(facts.snomed) && codes.insert(facts.snomed).second))
        << facts.id;
    for (const std::string_view row : {facts.volume, facts.volumeOfRight})
      EXPECT_TRUE(row.empty() || norm(row).unit == "ml") << facts.id;
    std::stringstream words{std::string(facts.words)};
    for (std::string phrase; std::getline(words, phrase, '|');)
      EXPECT_FALSE(phrase.empty() ||
                   phrase.find_first_not_of("abcdefghijklmnopqrstuvwxyz #*~!") != phrase.npos)
          << facts.id << ": " << phrase;
  }
  EXPECT_THROW(organ("kidneys"), UsageError);
}

} // namespace
} // namespace viscera::anatomy
