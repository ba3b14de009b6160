#include <algorithm>
#include <limits>
#include <utility>

#include "viscera/anatomy/norms.h"

namespace viscera::anatomy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr auto kBiobank = "Petersen 2017 (UK Biobank), doi 10.1186/s12968-017-0327-9";
constexpr auto kBiobankPeople =
    "800 healthy people of 45 to 74 years, by magnetic resonance, papillary muscles "
    "counted as cavity";
constexpr auto kReferencePerson = "ICRP publication 89, doi 10.1016/S0146-6453(03)00002-2";
constexpr auto kShipKidney = "SHIP-TREND 2024, doi 10.3390/jcm13030769";
constexpr auto kShipKidneyPeople =
    "1815 people without kidney disease, by magnetic resonance; the deviation is "
    "that of the quartiles";
constexpr auto kSpect =
    "Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (spread), and \"Simplifying the measurement of "
    "gastric accommodation using SPECT\" (mean)";
constexpr auto kBreathingStudy =
    "customary; how much people at rest differ: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7";
constexpr auto kRiseOfPressure = "the limit of Doppler ultrasound, which no study of its own gives; measured "
                                 "by catheter since Gleason and "
                                 "Braunwald 1962, doi 10.1172/JCI104469";
/// No study of its own gives it: the mean of the bounds above, 73 and 98 mmHg, rounded.
constexpr auto kMeanPressure =
    "geometric mean (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) of the systolic and diastolic bounds, "
    "73 to 98 mmHg, rounded";
constexpr auto kRightHeart = "Humbert 2022, doi 10.1093/eurheartj/ehac237";
/// Ranges of healthy people: the wedge pressure (table of recommendations); 24 ventricles that worked
/// normally.
constexpr auto kWedgePressure = "Rosenkranz 2015, doi 10.1183/16000617.0062-2015";
constexpr auto kFillingPressure = "Bouchard 1971, doi 10.1161/01.CIR.44.6.1072";
constexpr auto kPressures =
    "Whelton 2018, doi 10.1161/HYP.0000000000000065: normal is below 120/80; the lower "
    "bound is customary";

/// A ventricle's number, absolute and a square metre.
Norm ofVentricle(const char* id, const char* subject, const char* quantity, const char* unit, Measured women,
                 Measured men, std::optional<Measured> womenPerM2 = {},
                 std::optional<Measured> menPerM2 = {}) {
  Norm norm{id, subject, quantity, unit, Kind::spread, kBiobankPeople, kBiobank};
  norm.women = women;
  norm.men = men;
  norm.womenPerM2 = womenPerM2;
  norm.menPerM2 = menPerM2;
  return norm;
}

Norm bySex(const char* id, const char* subject, const char* quantity, const char* unit, Kind kind,
           Measured women, Measured men, const char* people, const char* source) {
  Norm norm{id, subject, quantity, unit, kind, people, source};
  norm.women = women;
  norm.men = men;
  return norm;
}

Norm ofEverybody(const char* id, const char* subject, const char* quantity, const char* unit,
                 Measured bothSexes, const char* people, const char* source) {
  Norm norm{id, subject, quantity, unit, Kind::spread, people, source};
  norm.bothSexes = bothSexes;
  return norm;
}

Norm within(const char* id, const char* subject, const char* quantity, const char* unit, Range limits,
            const char* people, const char* source) {
  Norm norm{id, subject, quantity, unit, Kind::limits, people, source};
  norm.limits = limits;
  return norm;
}

void addVentricles(std::vector<Norm>& rows) {
  constexpr auto kLeft = "Left ventricle", kRight = "Right ventricle";
  constexpr auto kEdv = "end-diastolic volume", kEsv = "end-systolic volume";
  constexpr auto kSv = "stroke volume", kEf = "ejection fraction";
  rows.push_back(
      ofVentricle("lv.edv", kLeft, kEdv, "ml", {124, 21}, {166, 32}, Measured{74, 12}, Measured{85, 15}));
  rows.push_back(
      ofVentricle("lv.esv", kLeft, kEsv, "ml", {49, 11}, {69, 16}, Measured{29, 6}, Measured{36, 8}));
  rows.push_back(
      ofVentricle("lv.sv", kLeft, kSv, "ml", {75, 14}, {96, 20}, Measured{45, 8}, Measured{49, 10}));
  rows.push_back(ofVentricle("lv.ef", kLeft, kEf, "%", {61, 5}, {58, 5}));
  rows.push_back(ofVentricle("lv.mass", kLeft, "mass of the muscle", "g", {70, 13}, {103, 21},
                             Measured{42, 7}, Measured{53, 9}));
  rows.push_back(
      ofVentricle("rv.edv", kRight, kEdv, "ml", {130, 24}, {182, 36}, Measured{77, 13}, Measured{93, 17}));
  rows.push_back(
      ofVentricle("rv.esv", kRight, kEsv, "ml", {55, 15}, {85, 22}, Measured{33, 9}, Measured{43, 11}));
  rows.push_back(
      ofVentricle("rv.sv", kRight, kSv, "ml", {75, 14}, {97, 20}, Measured{45, 8}, Measured{50, 9}));
  rows.push_back(ofVentricle("rv.ef", kRight, kEf, "%", {58, 6}, {54, 6}));
}

void addTimes(std::vector<Norm>& rows) {
  constexpr auto kSubject = "Left ventricle", kPeople = "1969 healthy people at rest, by tissue Doppler";
  constexpr auto kCopenhagen = "Alhakak 2023 (Copenhagen), doi 10.1007/s00392-023-02269-2";
  rows.push_back(
      ofEverybody("lv.ivct", kSubject, "isovolumic contraction", "ms", {40, 10}, kPeople, kCopenhagen));
  rows.push_back(
      ofEverybody("lv.ejection", kSubject, "ejection time", "ms", {292, 23}, kPeople, kCopenhagen));
  rows.push_back(
      ofEverybody("lv.ivrt", kSubject, "isovolumic relaxation", "ms", {96, 19}, kPeople, kCopenhagen));
}

/// Adds rows with values on which several methods agree, each with an offset of its own.
void addWalls(std::vector<Norm>& rows) {
  constexpr auto kLeft = "Left ventricle", kPeople = "healthy adults, by magnetic resonance and ultrasound";
  rows.push_back(within("lv.mapse", kLeft, "excursion of the mitral annulus (MAPSE)", "mm", {12, 16}, kPeople,
                        "magnetic resonance: 16.4 mm (Carlsson and others 2007, doi "
                        "10.1152/ajpheart.01376.2006); ultrasound finds less, 12 to 15 mm"));
  rows.push_back(within(
      "rv.tapse", "Right ventricle", "excursion of the tricuspid annulus (TAPSE)", "mm", {18, 25}, kPeople,
      "magnetic resonance: 23.4 mm (Carlsson and others 2007, doi "
      "10.1152/ajpheart.01376.2006); below 17 mm is abnormal in ultrasound (Lang and others "
      "2015, doi 10.1016/j.echo.2014.10.003)"));
  rows.push_back(within("lv.twist", kLeft, "twist of the apex against the base", "degrees", {8, 15}, kPeople,
                        "magnetic resonance: apex about 10, base about 3 degrees the other way (Young and "
                        "Cowan 2012, doi 10.1186/1532-429X-14-49)"));
  rows.push_back(within("lv.thickening", kLeft, "thickening of the free wall", "%", {30, 60}, kPeople,
                        "magnetic resonance: 4.4 +- 1.4 mm in the middle slices (Ubachs and others 2009, doi "
                        "10.1186/1532-429X-11-S1-P61)"));
}

/// Vendors and numbers of slices differ: the method belongs to the range.
void addStrain(std::vector<Norm>& rows) {
  constexpr auto kLeft = "Left ventricle";
  constexpr auto kPeople = "67 healthy adults, by feature tracking in magnetic resonance over the whole "
                           "ventricle (CVI42); other programs differ by several points";
  constexpr auto kSource = "Lim 2021, doi 10.1007/s00330-020-07539-5";
  rows.push_back(
      ofEverybody("lv.gls", kLeft, "global longitudinal strain", "%", {-17.0, 1.8}, kPeople, kSource));
  rows.push_back(
      ofEverybody("lv.gcs", kLeft, "global circumferential strain", "%", {-17.6, 1.8}, kPeople, kSource));
  rows.push_back(ofEverybody("lv.grs", kLeft, "global radial strain", "%", {29.1, 4.8}, kPeople, kSource));
}

void addCirculation(std::vector<Norm>& rows) {
  constexpr auto kAdults = "healthy adults at rest";
  const auto add = [&](const char* id, const char* subject, const char* quantity, const char* unit,
                       Range limits, const char* source) {
    rows.push_back(within(id, subject, quantity, unit, limits, kAdults, source));
  };
  add("heart.output", "Heart", "cardiac output", "l/min", {4, 8}, kRightHeart);
  add("aorta.systolic", "Aorta", "systolic pressure", "mmHg", {90, 120}, kPressures);
  add("aorta.diastolic", "Aorta", "diastolic pressure", "mmHg", {60, 80}, kPressures);
  add("aorta.mean", "Aorta", "mean pressure", "mmHg", {70, 100}, kMeanPressure);
  add("pulmonary.systolic", "Pulmonary artery", "systolic pressure", "mmHg", {15, 30}, kRightHeart);
  add("pulmonary.mean", "Pulmonary artery", "mean pressure", "mmHg", {7.4, 20.6},
      "Kovacs 2009, doi 10.1183/09031936.00145608: mean +- 2 standard deviations");
  add("la.mean", "Left atrium", "mean pressure", "mmHg", {4, 12}, kWedgePressure);
  add("ra.mean", "Right atrium", "mean pressure", "mmHg", {2, 6}, kRightHeart);
  add("lv.edp", "Left ventricle", "end-diastolic pressure", "mmHg", {5, 12}, kFillingPressure);
  add("lv.dpdt", "Left ventricle", "fastest rise of pressure", "mmHg/s", {1200, kInfinity}, kRiseOfPressure);
  add("lv.coupling", "Left ventricle", "coupling Ea/Ees", "", {0.5, 1},
      "between the most efficient (0.5) and the most powerful coupling (1): Burkhoff and Sagawa 1986, "
      "doi 10.1152/ajpregu.1986.250.6.R1021");
  add("aortic.gradient", "Aortic valve", "mean gradient", "mmHg", {-kInfinity, 5},
      "customary at the bedside, for the 1 to 1.7 m/s of a healthy valve; no stenosis up to 2.5 m/s: "
      "Baumgartner 2017, doi 10.1016/j.echo.2017.02.009");
  add("mitral.regurgitation", "Mitral valve", "regurgitant fraction", "%", {-kInfinity, 5},
      "none or a trace, which normal valves often have: doi 10.1378/chest.103.1.226");
}

/// Limits in hard exercise: what is not healthy at rest may be so here.
void addExercise(std::vector<Norm>& rows) {
  constexpr auto kWedge = "62 healthy people, wedge pressure; some of the oldest exceed it";
  constexpr auto kWolsk = "Wolsk 2017, doi 10.1016/j.jchf.2016.10.012";
  rows.push_back(within("exercise.systolic", "Aorta, in exercise", "systolic pressure", "mmHg", {160, 200},
                        "healthy adults at peak exercise",
                        "textbooks; percentiles of 2917 people: Sabbahi 2018, doi "
                        "10.1161/HYPERTENSIONAHA.117.10116"));
  rows.push_back(within("exercise.la", "Left atrium, in exercise", "mean pressure", "mmHg", {-kInfinity, 25},
                        kWedge, kWolsk));
  rows.push_back(within("exercise.a", "Left atrium, in exercise", "highest pressure (a wave)", "mmHg",
                        {-kInfinity, 25}, kWedge, kWolsk));
  rows.push_back(within("exercise.gradient", "Aortic valve, in exercise", "mean gradient", "mmHg",
                        {-kInfinity, 5}, "healthy adults: the limit at rest is kept",
                        "as at rest; no stenosis up to 2.5 m/s: Baumgartner 2017, doi "
                        "10.1016/j.echo.2017.02.009"));
}

/// Bounds of diseases, which are not ranges of healthy people.
void addDiseases(std::vector<Norm>& rows) {
  const auto add = [&](const char* id, std::vector<DiseaseLimit> limits) {
    std::find_if(rows.begin(), rows.end(), [id](const Norm& row) { return row.id == id; })->disease =
        std::move(limits);
  };
  constexpr auto kStenosis = "Baumgartner 2017, doi 10.1016/j.echo.2017.02.009";
  constexpr auto kRegurgitation = "Zoghbi 2017, doi 10.1016/j.echo.2017.01.007";
  constexpr auto kPressure = "Whelton 2018, doi 10.1161/HYP.0000000000000065";
  constexpr auto kFailure = "Bozkurt 2021, doi 10.1002/ejhf.2115";
  add("aortic.gradient",
      {{"moderate stenosis", 20, true, kStenosis}, {"severe stenosis", 40, true, kStenosis}});
  add("mitral.regurgitation", {{"moderate regurgitation", 30, true, kRegurgitation},
                               {"severe regurgitation", 50, true, kRegurgitation}});
  add("aorta.systolic", {{"hypertension", 130, true, kPressure}});
  add("aorta.diastolic", {{"hypertension", 80, true, kPressure}});
  add("pulmonary.mean", {{"pulmonary hypertension", 20, true, kRightHeart}});
  add("la.mean", {{"post-capillary pulmonary hypertension", 15, true, kRightHeart}});
  add("lv.ef", {{"heart failure with reduced ejection fraction", 40, false, kFailure}});
}

void addOrgans(std::vector<Norm>& rows) {
  constexpr auto kPerson = "reference woman and man; no spread is given";
  // 620 and 840 g with blood, 250 and 330 g of tissue, at 1.05 g/ml.
  rows.push_back(bySex("heart.volume", "Heart", "volume with its blood", "ml", Kind::averages, {590, 0},
                       {800, 0}, kPerson, kReferencePerson));
  rows.push_back(bySex("heart.muscle", "Heart", "volume of the muscle", "ml", Kind::averages, {238, 0},
                       {314, 0}, kPerson, kReferencePerson));
  rows.push_back(ofEverybody("liver.volume", "Liver", "volume", "ml", {1360, 273},
                             "1248 people without liver disease, by magnetic resonance",
                             "SHIP 2018, doi 10.1016/j.ejrad.2018.07.005"));
  rows.push_back(bySex("kidney.left", "Left kidney", "volume", "ml", Kind::spread, {144, 29.7}, {180, 31.9},
                       kShipKidneyPeople, kShipKidney));
  rows.push_back(bySex("kidney.right", "Right kidney", "volume", "ml", Kind::spread, {138, 25.9}, {174, 31.9},
                       kShipKidneyPeople, kShipKidney));
  rows.push_back(ofEverybody("spleen.volume", "Spleen", "volume", "ml", {198, 88}, "212 adults, by CT",
                             "Caglar 2014, doi 10.5603/FM.2014.0038"));
  rows.push_back(ofEverybody("pancreas.volume", "Pancreas", "volume", "ml", {72.4, 25.8},
                             "adults of 20 to 60 years, by CT", "Saisho 2007, doi 10.1002/ca.20543"));
}

void addStomach(std::vector<Norm>& rows) {
  constexpr double kContents = 757, kVariation = 0.16;
  // 140 g in women, 150 g in men, at 1.05 g/ml.
  constexpr double kWall = 138;
  constexpr auto kSubject = "Stomach";
  rows.push_back(ofEverybody("stomach.contents", kSubject, "contents after a meal", "ml",
                             {kContents, kVariation * kContents},
                             "443 people after a meal, by single-photon tomography", kSpect));
  rows.push_back(ofEverybody("stomach.volume", kSubject, "volume after a meal", "ml",
                             {kContents + kWall, kVariation * kContents},
                             "contents of 443 people after a meal, by single-photon tomography, and 138 ml "
                             "of wall (ICRP publication 89)",
                             kSpect));
  rows.push_back(within("stomach.rate", kSubject, "waves", "1/min", {2, 4}, "adults, by electrogastrography",
                        "Yin and Chen 2013, doi 10.5056/jnm.2013.19.1.5"));
  rows.push_back(ofEverybody("stomach.speed", kSubject, "speed of the waves", "mm/s", {2.7, 0.3},
                             "9 healthy people, by magnetic resonance; 28 people of doi "
                             "10.1046/j.1365-2982.2001.00285.x have 1.6 +- 0.2",
                             "Kwiatek 2006, doi 10.1002/jmri.20738"));
  rows.push_back(ofEverybody("stomach.occlusion", kSubject, "occlusion of the antrum by a wave", "%",
                             {58, 14}, "28 healthy people, by magnetic resonance",
                             "doi 10.1046/j.1365-2982.2001.00285.x"));
}

void addBreathing(std::vector<Norm>& rows) {
  constexpr auto kSubject = "Breathing";
  rows.push_back(
      within("breathing.rate", kSubject, "breaths", "1/min", {12, 20}, "adults at rest", kBreathingStudy));
  rows.push_back(within("breathing.duty", kSubject, "part that is inspiration", "%", {33, 50},
                        "adults at rest, from 1 : 2 to 1 : 1", kBreathingStudy));
  rows.push_back(within("breathing.down", "Liver", "way down in quiet breathing", "mm", {10, 25},
                        "what several studies measured", "Keall 2006, doi 10.1118/1.2349696"));
}

std::vector<Norm> makeTable() {
  std::vector<Norm> rows;
  addVentricles(rows);
  addTimes(rows);
  addWalls(rows);
  addStrain(rows);
  addCirculation(rows);
  addExercise(rows);
  addDiseases(rows);
  addOrgans(rows);
  addStomach(rows);
  addBreathing(rows);
  return rows;
}

} // namespace

const std::vector<Norm>& norms() {
  static const std::vector<Norm> rows = makeTable();
  return rows;
}

} // namespace viscera::anatomy
