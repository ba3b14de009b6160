#include "viscera/anatomy/part.h"

#include <algorithm>
#include <iterator>

#include "viscera/anatomy/organ_facts.h"

namespace viscera::anatomy {
namespace {

/// A chamber's cavity: blood in the colours of textbooks, atria lighter, so that they stand out against the
/// ventricles that they reach to.
struct ChamberFacts {
  Part part;
  std::string_view abbreviation, title;
  std::array<double, 3> color;
};
constexpr std::array<ChamberFacts, 4> kChambers = {
    {{kLeftVentricle, "LV", "Left ventricle", {0.84, 0.16, 0.14}},
     {kRightVentricle, "RV", "Right ventricle", {0.20, 0.36, 0.80}},
     {kLeftAtrium, "LA", "Left atrium", {0.96, 0.52, 0.42}},
     {kRightAtrium, "RA", "Right atrium", {0.46, 0.68, 0.96}}}};

const Vec3 kLesionColor(0.79, 0.69, 0.24);

const ChamberFacts* chamberFacts(const Part& part) {
  for (const ChamberFacts& facts : kChambers)
    if (facts.part == part)
      return &facts;
  return nullptr;
}

std::string small(std::string_view title) {
  std::string text(title);
  text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

} // namespace

Vec3 colorOf(const Part& part) {
  if (part.extent == Extent::lesion)
    return kLesionColor;
  if (const ChamberFacts* facts = chamberFacts(part))
    return {facts->color[0], facts->color[1], facts->color[2]};
  constexpr double kWhite = 255;
  const auto& color = organ(part.organ).color;
  return Vec3(color[0], color[1], color[2]) / kWhite;
}

std::string titleOf(const Part& part) {
  if (const ChamberFacts* facts = chamberFacts(part))
    return std::string(facts->title);
  const OrganFacts& facts = organ(part.organ);
  const bool sided = part.side != Side::none && part.chamber == Chamber::none &&
                     (facts.place == Place::eitherSide || facts.place == Place::anywhere);
  return sided ? (part.side == Side::left ? "Left " : "Right ") + small(facts.title)
               : std::string(facts.title);
}

std::string_view abbreviationOf(const Part& part) {
  const ChamberFacts* facts = chamberFacts(part);
  return facts ? facts->abbreviation : std::string_view();
}

Side bodySideOf(const Part& part) {
  if (part.extent != Extent::whole || part.chamber != Chamber::none)
    return Side::none;
  switch (organ(part.organ).place) {
  case Place::right:
    return Side::right;
  case Place::left:
    return Side::left;
  case Place::eitherSide:
    return part.side;
  default:
    return Side::none;
  }
}

bool isSeldomWhole(const Part& part) {
  constexpr std::string_view kSystems[] = {"Arteries", "Veins", "Bones and joints", "Muscles",
                                           "Skin and fat"};
  constexpr std::string_view kOrgans[] = {"spinal_cord", "nerve",    "esophagus",
                                          "trachea",     "bronchus", "lymph_node"};
  const std::string_view system = organ(part.organ).system;
  return std::find(std::begin(kSystems), std::end(kSystems), system) != std::end(kSystems) ||
         std::find(std::begin(kOrgans), std::end(kOrgans), part.organ) != std::end(kOrgans);
}

const Norm* volumeNormOf(const Part& part) {
  if (part.extent != Extent::whole || part.chamber != Chamber::none)
    return nullptr;
  const OrganFacts& facts = organ(part.organ);
  const std::string_view row = part.side == Side::right ? facts.volumeOfRight : facts.volume;
  return row.empty() ? nullptr : &norm(row);
}

} // namespace viscera::anatomy
