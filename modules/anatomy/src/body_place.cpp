#include "viscera/anatomy/body_place.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string>

#include "viscera/anatomy/organ_facts.h"

namespace viscera::anatomy {
namespace {

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

/// A row of the table: of an organ of which there are two, the left one's place.
struct Row {
  std::string_view organ;
  std::array<double, 3> center, spread; ///< mm, LPS.
};

constexpr Row kTrunk[] = {
    {"liver", {-50, -65, 35}, {25, 25, 40}},       {"gallbladder", {-45, -100, 0}, {25, 25, 40}},
    {"spleen", {90, -28, 45}, {20, 25, 40}},       {"pancreas", {15, -78, 10}, {22, 22, 35}},
    {"stomach", {45, -92, 40}, {30, 25, 45}},      {"duodenum", {-30, -85, -20}, {25, 25, 40}},
    {"bowel", {5, -85, -90}, {35, 30, 70}},        {"colon", {5, -85, -70}, {35, 30, 80}},
    {"rectum", {0, -10, -230}, {18, 30, 50}},      {"kidney", {62, -23, -10}, {15, 22, 40}},
    {"adrenal", {32, -39, 39}, {14, 18, 30}},      {"ureter", {32, -35, -110}, {15, 30, 70}},
    {"bladder", {0, -85, -250}, {18, 30, 50}},     {"prostate", {0, -65, -290}, {12, 28, 45}},
    {"uterus", {0, -65, -235}, {25, 30, 50}},      {"ovary", {40, -55, -215}, {18, 30, 45}},
    {"testis", {20, -90, -370}, {12, 40, 60}},     {"aorta", {10, -50, 70}, {14, 25, 120}},
    {"vena_cava", {-22, -60, 60}, {15, 20, 120}},  {"portal_vein", {-5, -76, 15}, {25, 22, 40}},
    {"esophagus", {5, -50, 150}, {12, 25, 80}},    {"trachea", {0, -50, 255}, {12, 25, 55}},
    {"diaphragm", {0, -70, 80}, {20, 30, 60}},     {"lung", {75, -55, 165}, {25, 40, 80}},
    {"heart", {22, -85, 150}, {18, 25, 50}},       {"myocardium", {25, -85, 145}, {20, 25, 50}},
    {"pericardium", {18, -85, 150}, {18, 25, 50}}, {"thymus", {0, -115, 225}, {15, 30, 50}},
    {"breast", {85, -150, 150}, {25, 40, 70}}};

constexpr Row kHead[] = {
    {"thyroid", {0, -75, 330}, {12, 45, 60}}, {"larynx", {0, -75, 350}, {12, 45, 60}},
    {"brain", {0, -40, 490}, {10, 45, 80}},   {"skull", {0, -50, 480}, {10, 45, 80}},
    {"eye", {32, -115, 470}, {8, 50, 80}},    {"salivary_gland", {55, -60, 410}, {15, 45, 70}},
    {"tongue", {0, -95, 400}, {12, 45, 70}},
};

constexpr Row kPlacesOfBones[] = {
    {"vertebra", {0, 0, 80}, {10, 35, 160}},           {"spinal_cord", {0, 8, 130}, {10, 25, 140}},
    {"sacrum", {0, 10, -185}, {10, 25, 50}},           {"sternum", {0, -140, 185}, {12, 35, 60}},
    {"clavicle", {75, -75, 275}, {25, 45, 60}},        {"scapula", {125, 0, 225}, {30, 40, 70}},
    {"humerus", {190, -30, 150}, {50, 70, 170}}, // Beside the body or above the head.
    {"hip_bone", {80, -40, -210}, {25, 35, 60}},       {"pelvis", {0, -35, -215}, {15, 40, 70}},
    {"femur", {100, -50, -350}, {30, 45, 140}},        {"rib", {105, -45, 120}, {35, 60, 100}},
    {"muscle", {55, 0, 0}, {30, kAnywhere, kAnywhere}}}; // By the side in its name.

/// Halves of the brain and of what belongs to it.
constexpr Row kHalfOfBrain = {"brain", {28, 0, 0}, {14, kAnywhere, kAnywhere}};

struct ChamberRow {
  Part part;
  std::array<double, 3> center;
};
constexpr std::array<double, 3> kChamberSpread = {18, 22, 40};
constexpr ChamberRow kPlacesOfChambers[] = {{kLeftVentricle, {35, -85, 145}},
                                            {kRightVentricle, {12, -108, 140}},
                                            {kLeftAtrium, {8, -60, 170}},
                                            {kRightAtrium, {-25, -85, 155}}};

Vec3 vectorOf(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

const Row* rowOf(std::string_view organ) {
  const auto in = [organ](const auto& rows) -> const Row* {
    for (const Row& row : rows)
      if (row.organ == organ)
        return &row;
    return nullptr;
  };
  const Row* row = in(kTrunk);
  row = row ? row : in(kHead);
  return row ? row : in(kPlacesOfBones);
}

char small(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The number at the end of the name's word that begins at `at`, or of the next one: 3 for "L3", "lumbar 3".
int numberFrom(std::string_view name, std::size_t at) {
  while (at < name.size() && !isLetter(name[at]) && !isDigit(name[at]))
    ++at;
  int number = 0;
  for (int digits = 0; at < name.size() && isDigit(name[at]) && digits < 3; ++at, ++digits)
    number = 10 * number + (name[at] - '0');
  return number;
}

/// The height of a vertebra above the first lumbar one, mm, by the name of its level; none for no level.
std::optional<double> heightOfLevel(std::string_view name) {
  constexpr int kThoracic = 12, kLumbar = 5, kCervical = 7;
  constexpr double kLumbarMm = 36, kThoracicMm = 25, kCervicalMm = 17;
  for (std::size_t at = 0; at < name.size();) {
    if (!isLetter(name[at])) {
      ++at;
      continue;
    }
    std::string word;
    for (; at < name.size() && isLetter(name[at]); ++at)
      word += small(name[at]);
    const int number = numberFrom(name, at);
    const auto says = [&](std::string_view letter, std::string_view other, std::string_view begin) {
      return number > 0 && (word == letter || word == other || word.rfind(begin, 0) == 0);
    };
    if (says("l", "lwk", "lumb") && number <= kLumbar)
      return -kLumbarMm * (number - 1);
    if ((says("t", "th", "thorac") || says("d", "bwk", "dors")) && number <= kThoracic)
      return kLumbarMm + kThoracicMm * (kThoracic - number);
    if (says("c", "hwk", "cerv") && number <= kCervical)
      return kLumbarMm + kThoracicMm * kThoracic + kCervicalMm * (kCervical - number);
  }
  return std::nullopt;
}

/// The height of a rib above the first lumbar vertebra, mm, by the number behind its word: "rib_left_7".
std::optional<double> heightOfRib(std::string_view name) {
  constexpr int kRibs = 12;
  constexpr double kLowestMm = 30, kApartMm = 20;
  std::string letters(name);
  std::transform(letters.begin(), letters.end(), letters.begin(), small);
  for (const std::string_view word : {"rib", "ripp", "cost", "cot"}) {
    std::size_t at = letters.find(word);
    if (at == std::string::npos)
      continue;
    while (at < name.size() && !isDigit(name[at]))
      ++at;
    if (const int number = numberFrom(name, at); number >= 1 && number <= kRibs)
      return kLowestMm + kApartMm * (kRibs - number);
  }
  return std::nullopt;
}

std::optional<BodyPlace> chamberPlace(const Part& part) {
  for (const ChamberRow& row : kPlacesOfChambers)
    if (row.part == part)
      return BodyPlace{part, vectorOf(row.center), vectorOf(kChamberSpread)};
  return std::nullopt;
}

/// Only the side of the body is known of pieces.
bool isOfOneSide(const Part& part) {
  const Place place = organ(part.organ).place;
  return part.side != Side::none && (place == Place::eitherSide || part.organ == "muscle");
}

} // namespace

std::optional<BodyPlace> bodyPlaceNamed(std::string_view name) {
  constexpr double kKnownHeightMm = 40; // The spread of what has a number, mm.
  const std::optional<Part> part = partNamed(name);
  if (!part || part->extent == Extent::lesion)
    return std::nullopt;
  if (part->chamber != Chamber::none)
    return chamberPlace(*part);
  const bool halfOfBrain = part->organ == kHalfOfBrain.organ && part->side != Side::none;
  const Row* row = halfOfBrain ? &kHalfOfBrain : rowOf(part->organ);
  const bool oneSide = halfOfBrain || isOfOneSide(*part);
  const bool ofTwo = organ(part->organ).place == Place::eitherSide || part->organ == "muscle";
  if (!row || (part->extent == Extent::piece && !oneSide) || (ofTwo && !oneSide))
    return std::nullopt;
  BodyPlace place{*part, vectorOf(row->center), vectorOf(row->spread)};
  if (oneSide && part->side == Side::right)
    place.center.x() = -place.center.x();
  if (part->extent == Extent::piece && !halfOfBrain && part->organ != "lung")
    place.spread.tail<2>().setConstant(kAnywhere);
  const bool isVertebra = part->organ == "vertebra", isRib = part->organ == "rib";
  if (const auto height = isVertebra ? heightOfLevel(name) : isRib ? heightOfRib(name) : std::nullopt) {
    place.center.z() = *height;
    place.spread.z() = kKnownHeightMm;
  }
  return place;
}

} // namespace viscera::anatomy
