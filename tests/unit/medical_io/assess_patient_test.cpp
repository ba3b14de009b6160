#include "viscera/medical_io/assess_patient.h"

#include <algorithm>
#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace viscera::medical_io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The middles of the organs of one adult, mm, LPS, with the origin between the hip joints.
struct Placed {
  const char* name;
  double x, y, z, ml;
};
constexpr Placed kAdult[] = {{"liver", -62, -22, 292, 1480},
                             {"spleen", 96, 18, 305, 190},
                             {"stomach", 48, -38, 288, 260},
                             {"gallbladder", -52, -58, 262, 25},
                             {"pancreas", 14, -30, 262, 75},
                             {"duodenum", -34, -28, 236, 60},
                             {"kidney_left", 66, 24, 240, 160},
                             {"kidney_right", -62, 20, 226, 155},
                             {"adrenal_gland_left", 34, 10, 284, 5},
                             {"adrenal_gland_right", -30, 12, 288, 4},
                             {"aorta", 12, 0, 320, 160},
                             {"inferior_vena_cava", -24, -8, 270, 70},
                             {"colon", 6, -42, 190, 420},
                             {"small_bowel", 4, -40, 150, 700},
                             {"urinary_bladder", 2, -32, 12, 180},
                             {"prostate", 0, -14, -26, 24},
                             {"heart", 26, -38, 408, 620},
                             {"lung_upper_lobe_left", 78, -22, 455, 1100},
                             {"lung_lower_lobe_left", 82, 20, 390, 1000},
                             {"lung_upper_lobe_right", -74, -18, 468, 1000},
                             {"lung_middle_lobe_right", -70, -48, 400, 450},
                             {"lung_lower_lobe_right", -80, 22, 385, 1200},
                             {"esophagus", 6, -4, 410, 30},
                             {"trachea", -4, -8, 515, 45},
                             {"spinal_cord", 0, 60, 400, 70},
                             {"sacrum", 0, 62, 66, 240},
                             {"vertebrae_L5", 0, 36, 116, 70},
                             {"vertebrae_L3", 0, 36, 186, 72},
                             {"vertebrae_L1", 0, 42, 256, 65},
                             {"vertebrae_T8", 1, 66, 400, 40},
                             {"vertebrae_T4", 0, 60, 492, 30},
                             {"hip_left", 84, 8, 44, 380},
                             {"hip_right", -84, 8, 44, 380},
                             {"femur_left", 104, -6, -90, 500},
                             {"femur_right", -104, -6, -92, 500},
                             {"scapula_left", 118, 44, 480, 120},
                             {"scapula_right", -118, 44, 482, 120},
                             {"clavicula_left", 76, -40, 534, 40},
                             {"clavicula_right", -76, -40, 534, 40},
                             {"sternum", 0, -96, 440, 60},
                             {"gluteus_maximus_left", 74, 68, 30, 900},
                             {"gluteus_maximus_right", -74, 68, 30, 900},
                             {"thyroid_gland", 0, -28, 578, 18},
                             {"brain", 2, -10, 740, 1300}};
constexpr std::size_t kPatientsOrgans = std::size(kAdult);

/// The same organs as others name them; an empty name: they do not have it.
const std::map<std::string, std::vector<std::string>>& schemes() {
  static const std::map<std::string, std::vector<std::string>> kSchemes = {
      {"slicer",
       {"Model_3_liver", "Model_7_spleen", "Model_11_stomach", "Model_10_gallbladder", "Model_6_pancreas",
        "Model_12_duodenum", "Model_52_left_kidney", "Model_51_right_kidney", "Model_112_left_adrenal_gland",
        "Model_111_right_adrenal_gland", "Model_5_aorta", "Model_8_inferior_vena_cava"}},
      {"german",
       {"Leber", "Milz", "Magen", "Gallenblase", "Bauchspeicheldruese", "Zwoelffingerdarm", "Niere links",
        "Niere rechts", "Nebenniere links", "Nebenniere rechts", "Aorta", "untere Hohlvene"}},
      {"french",
       {"pat_01-foie.stl", "pat_02-rate.stl", "pat_03-estomac.stl", "pat_04-vésicule biliaire.stl",
        "pat_05-pancréas.stl", "pat_06-duodénum.stl", "pat_07-rein gauche.stl", "pat_08-rein droit.stl",
        "pat_09-surrénale gauche.stl", "pat_10-surrénale droite.stl", "pat_11-aorte.stl",
        "pat_12-veine cave inférieure.stl"}},
      {"spanish",
       {"hígado", "bazo", "estómago", "vesícula biliar", "páncreas", "duodeno", "riñón izquierdo",
        "riñón derecho", "glándula suprarrenal izquierda", "glándula suprarrenal derecha", "aorta",
        "vena cava inferior"}},
      {"latin",
       {"A05_Hepar", "A13_Splen", "A05_Gaster", "A05_Vesica biliaris", "A05_Pancreas", "A05_Duodenum",
        "A08_Ren sinister", "A08_Ren dexter", "A11_Glandula suprarenalis sinistra",
        "A11_Glandula suprarenalis dextra", "A12_Aorta", "A12_Vena cava inferior"}}};
  return kSchemes;
}

using Patient = std::vector<PlacedOrgan>;

PlacedOrgan at(const std::string& name, const Vec3& middle, double ml) {
  const Vec3 half = Vec3::Constant(0.5 * std::cbrt(1000 * ml));
  return {name, {middle - half, middle + half}, ml};
}

Patient adult() {
  Patient patient;
  for (const Placed& organ : kAdult)
    patient.push_back(at(organ.name, {organ.x, organ.y, organ.z}, organ.ml));
  return patient;
}

Patient renamed(const std::vector<std::string>& names) {
  Patient patient = adult();
  patient.resize(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    patient[i].name = names[i];
  return patient;
}

/// Every coordinate as the matrix says, from another origin.
Patient laid(Patient patient, const Eigen::Matrix3d& matrix, double factor = 1) {
  const Vec3 origin(35, -210, -900);
  for (PlacedOrgan& organ : patient)
    organ = at(organ.name, factor * (matrix * organ.bounds.center() + origin),
               organ.volumeMl * factor * factor * factor);
  return patient;
}

Eigen::Matrix3d signs(double x, double y, double z) {
  return Vec3(x, y, z).asDiagonal();
}

Patient some(const std::vector<std::string>& names) {
  Patient patient;
  for (const PlacedOrgan& organ : adult())
    if (std::find(names.begin(), names.end(), organ.name) != names.end())
      patient.push_back(organ);
  EXPECT_EQ(patient.size(), names.size());
  return patient;
}

std::vector<std::string> repairsOf(const PatientAssessment& patient) {
  for (const Finding& finding : patient.findings)
    if (finding.subject == FindingSubject::arrangement)
      return finding.repairs;
  return {};
}

std::string saidOf(const PatientAssessment& patient) {
  std::string all;
  for (const Finding& finding : patient.findings)
    all += finding.text.english() + "\n";
  return all;
}

/// The patient in LPS, in RAS, mirrored, upside down and scaled.
void expectTold(const Patient& patient, const std::string& about) {
  SCOPED_TRACE(about);
  const PatientAssessment right = assessPatient(laid(patient, signs(1, 1, 1)));
  EXPECT_THAT(right.findings, IsEmpty()) << saidOf(right);
  EXPECT_TRUE(right.sidesChecked());
  EXPECT_EQ(right.votes[0].exchanged, 0);
  const PatientAssessment ras = assessPatient(laid(patient, signs(-1, -1, 1)));
  EXPECT_EQ(ras.axes(), "RAS");
  EXPECT_THAT(repairsOf(ras), ElementsAre("ras-to-lps"));
  EXPECT_THAT(saidOf(ras), HasSubstr("RAS"));
  const PatientAssessment mirrored = assessPatient(laid(patient, signs(-1, 1, 1)));
  EXPECT_EQ(mirrored.axes(), "mirrored");
  EXPECT_THAT(repairsOf(mirrored), ElementsAre("mirror"));
  const PatientAssessment turned = assessPatient(laid(patient, signs(1, -1, -1)));
  EXPECT_FALSE(turned.fitsLps);
  EXPECT_THAT(saidOf(turned), HasSubstr("front and back"));
  const PatientAssessment metres = assessPatient(laid(patient, signs(1, 1, 1), 0.001));
  EXPECT_THAT(repairsOf(metres), IsEmpty());
  EXPECT_THAT(saidOf(metres), HasSubstr("metres"));
}

TEST(AssessPatient, FortyOneOrgansAreToldFromEveryOtherWayToLayThem) {
  ASSERT_GE(kPatientsOrgans, 41u);
  const Patient patient = adult();
  expectTold(patient, "TotalSegmentator");
  EXPECT_EQ(assessPatient(patient).axes(), "LPS");
  EXPECT_THAT(repairsOf(assessPatient(laid(patient, signs(1, -1, -1)))), ElementsAre("flip-yz"));
  EXPECT_THAT(repairsOf(assessPatient(laid(patient, signs(-1, 1, -1)))), ElementsAre("flip-xz"));
  EXPECT_THAT(repairsOf(assessPatient(laid(patient, signs(1, 1, -1)))), ElementsAre("flip-z"));
  EXPECT_THAT(repairsOf(assessPatient(laid(patient, signs(1, -1, 1)))), ElementsAre("flip-y"));
  Eigen::Matrix3d yUp;
  yUp << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  EXPECT_THAT(repairsOf(assessPatient(laid(patient, yUp))), ElementsAre("y-up"));
  EXPECT_THAT(repairsOf(assessPatient(laid(patient, yUp * signs(-1, -1, 1)))), ElementsAre("y-up-ras"));
}

TEST(AssessPatient, NamesOfOtherAtlasesAndLanguagesAreToldAsWell) {
  for (const auto& [scheme, names] : schemes()) {
    const PatientAssessment whole = assessPatient(renamed(names));
    EXPECT_EQ(whole.organs, static_cast<int>(names.size())) << scheme;
    expectTold(renamed(names), scheme);
  }
}

TEST(AssessPatient, TheFourOrgansOfAnAtlasInRasDoNotPass) {
  Patient atlas = some({"liver", "spleen", "kidney_left", "kidney_right"});
  for (PlacedOrgan& organ : atlas)
    organ.name = organ.name == "kidney_left"    ? "Model_52_left_kidney"
                 : organ.name == "kidney_right" ? "Model_51_right_kidney"
                                                : "Model_3_" + organ.name;
  EXPECT_THAT(assessPatient(laid(atlas, signs(1, 1, 1))).findings, IsEmpty());
  const PatientAssessment ras = assessPatient(laid(atlas, signs(-1, -1, 1)));
  EXPECT_THAT(saidOf(ras), HasSubstr("right and left are exchanged"));
  EXPECT_THAT(saidOf(ras), HasSubstr("RAS"));
  EXPECT_THAT(saidOf(assessPatient(laid(atlas, signs(-1, 1, 1)))), HasSubstr("mirrored"));
}

TEST(AssessPatient, APairOfNamedSidesTellsRightFromLeftOnly) {
  for (const auto& [left, right] : {std::pair("kidney_left", "kidney_right"),
                                    {"femur_left", "femur_right"},
                                    {"hip_left", "hip_right"},
                                    {"scapula_left", "scapula_right"},
                                    {"lung_lower_lobe_left", "lung_lower_lobe_right"}}) {
    const Patient pair = some({left, right});
    EXPECT_THAT(assessPatient(pair).findings, IsEmpty()) << left;
    const PatientAssessment exchanged = assessPatient(laid(pair, signs(-1, 1, 1)));
    EXPECT_EQ(exchanged.axes(), "RAS or mirrored") << left;
    EXPECT_THAT(repairsOf(exchanged), ElementsAre("ras-to-lps", "mirror"));
    EXPECT_THAT(assessPatient(laid(pair, signs(1, -1, -1))).findings, IsEmpty()) << "not known by these";
  }
}

TEST(AssessPatient, OneOrganAndOrgansWithoutAPlaceSayNothing) {
  for (const Eigen::Matrix3d& matrix : {signs(1, 1, 1), signs(-1, -1, 1), signs(-1, 1, 1)}) {
    const PatientAssessment one = assessPatient(laid(some({"liver"}), matrix));
    EXPECT_THAT(one.findings, IsEmpty());
    EXPECT_EQ(one.axes(), "undecided");
  }
  EXPECT_EQ(assessPatient({}).axes(), "undecided");
  const PatientAssessment unknown = assessPatient({at("a", {0, 0, 0}, 1), at("tumour", {0, 90, 0}, 1)});
  EXPECT_EQ(unknown.organs, 0);
  EXPECT_TRUE(unknown.fitsLps);
}

TEST(AssessPatient, AMirrorImageIsToldFromSitusInversusByTheNamesThatSayASide) {
  const Patient unpaired = some(
      {"liver", "spleen", "stomach", "pancreas", "vertebrae_L1", "urinary_bladder", "heart", "gallbladder"});
  EXPECT_THAT(saidOf(assessPatient(laid(unpaired, signs(-1, 1, 1)))), HasSubstr("or situs inversus"));
  EXPECT_THAT(saidOf(assessPatient(laid(adult(), signs(-1, 1, 1)))), testing::Not(HasSubstr("situs")));
  // All organs that have no partner on the other side, the others in their places.
  Patient inverse = adult();
  for (PlacedOrgan& organ : inverse)
    if (organ.name.find("left") == std::string::npos && organ.name.find("right") == std::string::npos)
      organ = at(organ.name, signs(-1, 1, 1) * organ.bounds.center(), organ.volumeMl);
  EXPECT_THAT(saidOf(assessPatient(inverse)), HasSubstr("situs inversus, or wrong names"));
  for (PlacedOrgan& organ : inverse)
    organ = at(organ.name, signs(-1, 1, 1) * organ.bounds.center(), organ.volumeMl);
  EXPECT_THAT(saidOf(assessPatient(inverse)), HasSubstr("exchanged in the names"));
}

TEST(AssessPatient, AnOrganOnTheWrongSideOfAGoodPatientIsNamed) {
  Patient patient = adult();
  PlacedOrgan& kidney = patient[6];
  ASSERT_EQ(kidney.name, "kidney_left");
  kidney = at(kidney.name, signs(-1, 1, 1) * kidney.bounds.center(), kidney.volumeMl);
  const PatientAssessment found = assessPatient(patient);
  EXPECT_THAT(found.misplaced, ElementsAre(6));
  EXPECT_THAT(saidOf(found), HasSubstr("1 organ lies on the opposite side of the patient: kidney_left"));
}

TEST(AssessPatient, AllOrgansHaveOneFactorOfSize) {
  const Patient patient = some({"liver", "spleen", "kidney_left", "kidney_right", "pancreas"});
  const auto said = [&](double factor) {
    return saidOf(assessPatient(laid(patient, signs(1, 1, 1), factor)));
  };
  EXPECT_EQ(said(1), "");
  EXPECT_EQ(said(1.1), "");
  EXPECT_EQ(said(0.9), "");
  EXPECT_THAT(said(0.1), HasSubstr("the coordinates seem to be in centimetres"));
  EXPECT_THAT(said(1 / 25.4), HasSubstr("the coordinates seem to be in inches"));
  EXPECT_THAT(said(0.001), HasSubstr("the coordinates seem to be in metres"));
  EXPECT_THAT(said(0.55), HasSubstr("an atlas that is not life-sized"));
  EXPECT_NEAR(assessPatient(laid(patient, signs(1, 1, 1), 0.5)).sizeFactor, 0.5, 0.08);
  Patient odd = some({"liver", "spleen"});
  odd[1].volumeMl = 4000;
  EXPECT_EQ(saidOf(assessPatient(odd)), "") << "organs that do not agree have no common factor";
}

/// Every statement about a part of a patient is one that the whole bears out.
TEST(AssessPatient, NoPartOfAPatientGivesAWrongStatement) {
  std::mt19937 random(59);
  std::normal_distribution<double> anywhere(0, 8);
  const Patient whole = adult();
  for (const std::size_t size : {2u, 3u, 5u, 9u, 20u})
    for (int trial = 0; trial < 120; ++trial) {
      Patient part = whole;
      std::shuffle(part.begin(), part.end(), random);
      part.resize(size);
      for (PlacedOrgan& organ : part)
        organ =
            at(organ.name, organ.bounds.center() + Vec3(anywhere(random), anywhere(random), anywhere(random)),
               organ.volumeMl);
      std::string names;
      for (const PlacedOrgan& organ : part)
        names += organ.name + " ";
      const PatientAssessment right = assessPatient(laid(part, signs(1, 1, 1)));
      EXPECT_THAT(right.findings, IsEmpty()) << names << saidOf(right);
      const PatientAssessment ras = assessPatient(laid(part, signs(-1, -1, 1)));
      EXPECT_NE(ras.directions[0], Direction::kept) << names;
      EXPECT_NE(ras.directions[1], Direction::kept) << names;
      EXPECT_NE(ras.directions[2], Direction::exchanged) << names << saidOf(ras);
      EXPECT_NE(ras.axes(), "mirrored") << names;
      const PatientAssessment mirrored = assessPatient(laid(part, signs(-1, 1, 1)));
      EXPECT_NE(mirrored.directions[0], Direction::kept) << names;
      EXPECT_NE(mirrored.directions[1], Direction::exchanged) << names << saidOf(mirrored);
      EXPECT_NE(mirrored.axes(), "RAS") << names;
      const PatientAssessment down = assessPatient(laid(part, signs(1, -1, -1)));
      EXPECT_NE(down.directions[0], Direction::exchanged) << names << saidOf(down);
      EXPECT_NE(down.directions[2], Direction::kept) << names;
    }
}

TEST(AssessPatient, SegmentsOfALabelMapAreJudgedByTheirBoxes) {
  LabelMap map;
  map.size = {100, 100, 100};
  map.indexToLps.linear() = Vec3(-3, -3, 3).asDiagonal(); // Written from left to right, as in RAS.
  map.indexToLps.translation() = Vec3(150, 150, 0);
  Segment liver, spleen;
  liver.name = "liver";
  liver.low = {60, 40, 40};
  liver.high = {90, 70, 70};
  liver.voxels = 50000;
  spleen.name = "spleen";
  spleen.low = {10, 30, 50};
  spleen.high = {25, 45, 65};
  map.segments = {liver, spleen};
  const Patient placed = placedOrgans(map);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_NEAR(placed[0].bounds.center().x(), 150 - 3 * 75, 1e-9);
  EXPECT_NEAR(placed[0].bounds.high.x() - placed[0].bounds.low.x(), 3 * 31, 1e-9);
  EXPECT_NEAR(placed[0].volumeMl, 1350, 1);
  EXPECT_LT(placed[0].bounds.center().x(), placed[1].bounds.center().x());
  EXPECT_EQ(assessArrangement(placed), std::nullopt);
}

} // namespace
} // namespace viscera::medical_io
