#include "viscera/medical_io/assess_patient.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "body_axes.h"
#include "viscera/anatomy/body_place.h"
#include "viscera/anatomy/norms.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/plausible_size.h"

namespace viscera::medical_io {
namespace {

using Directions = std::array<Direction, 3>;

/// Two organs have an order along an axis that is the same in all bodies when they are this many standard
/// deviations apart.
constexpr double kOrdered = 2;
/// Volumes of organs are compared by the cube root. Those of one patient agree to this factor ...
constexpr double kSameFactor = 1.4;
/// ... and together they are not life-sized beyond this one.
constexpr double kNotLifeSized = 1.35;
/// A unit explains a factor that is as near to it as this.
constexpr double kUnitFactor = 1.45;
constexpr std::size_t kFewestVolumes = 2, kFewestAround = 4;
constexpr std::size_t kOrgansNamed = 4;
/// The vague sentence, that the organs do not lie as in a body, needs so much more evidence.
constexpr double kVague = 2;

/// An organ of the patient whose place is known.
struct Recognised {
  std::size_t index = 0; ///< In the list that is judged.
  anatomy::BodyPlace place;
};

std::vector<Recognised> knownAmong(const std::vector<PlacedOrgan>& organs) {
  std::vector<Recognised> known;
  for (std::size_t i = 0; i < organs.size(); ++i)
    if (organs[i].bounds.center().allFinite())
      if (const auto place = anatomy::bodyPlaceNamed(organs[i].name))
        known.push_back({i, *place});
  return known;
}

/// Twelve ribs of one side say little more than one: each counts less.
std::vector<KnownOrgan> weighed(const std::vector<PlacedOrgan>& organs,
                                const std::vector<Recognised>& known) {
  std::map<std::pair<std::string_view, anatomy::Side>, int> alike;
  for (const Recognised& one : known)
    if (one.place.part.chamber == anatomy::Chamber::none)
      ++alike[{one.place.part.organ, one.place.part.side}];
  std::vector<KnownOrgan> result;
  for (const Recognised& one : known) {
    const bool chamber = one.place.part.chamber != anatomy::Chamber::none;
    const int count = chamber ? 1 : alike[{one.place.part.organ, one.place.part.side}];
    result.push_back({organs[one.index].bounds.center(), one.place.center, one.place.spread,
                      1 / std::sqrt(static_cast<double>(count))});
  }
  return result;
}

/// The ways that are nearly as good as the best.
std::vector<BodyWay> plausible(std::vector<BodyWay> ways) {
  const double most = ways.front().cost + kClearMargin;
  std::erase_if(ways, [most](const BodyWay& way) { return way.cost > most; });
  return ways;
}

/// What all ways agree on.
Directions directionsOf(const std::vector<BodyWay>& ways) {
  Directions directions = {};
  for (std::size_t a = 0; a < directions.size(); ++a) {
    const auto all = [&](int sign) {
      return std::all_of(ways.begin(), ways.end(), [&](const BodyWay& way) {
        return way.axis[a] == static_cast<int>(a) && way.sign[a] == sign;
      });
    };
    directions[a] = all(1) ? Direction::kept : all(-1) ? Direction::exchanged : Direction::unknown;
  }
  return directions;
}

bool fitsLps(const std::vector<BodyWay>& ways) {
  return std::any_of(ways.begin(), ways.end(), [](const BodyWay& way) { return way.isLps(); });
}

/// Whether right and left are those of LPS, by the organs whose names say a side, or by the others.
Direction sideBy(const std::vector<PlacedOrgan>& organs, const std::vector<Recognised>& known, bool sided) {
  std::vector<Recognised> some;
  for (const Recognised& one : known)
    if (one.place.sided() == sided)
      some.push_back(one);
  if (some.size() < 2)
    return Direction::unknown;
  return directionsOf(plausible(bodyWays(weighed(organs, some))))[0];
}

std::array<OrderVotes, 3> votesOf(const std::vector<KnownOrgan>& organs) {
  std::array<OrderVotes, 3> votes = {};
  for (std::size_t a = 0; a < organs.size(); ++a)
    for (std::size_t b = a + 1; b < organs.size(); ++b)
      for (int axis = 0; axis < 3; ++axis) {
        const double usual = organs[b].expected[axis] - organs[a].expected[axis];
        const double spread = std::hypot(organs[a].spread[axis], organs[b].spread[axis]);
        const double found = organs[b].at[axis] - organs[a].at[axis];
        if (!(std::abs(usual) >= kOrdered * spread) || found == 0)
          continue;
        OrderVotes& vote = votes[static_cast<std::size_t>(axis)];
        ++(usual * found > 0 ? vote.kept : vote.exchanged);
      }
  return votes;
}

/// A finding about all organs.
Finding doubt(Text text, std::vector<std::string> repairs, FindingSubject subject) {
  return {FindingSeverity::doubt, std::move(text), std::move(repairs), subject};
}

Finding arranged(Text text, std::vector<std::string> repairs) {
  return doubt(std::move(text), std::move(repairs), FindingSubject::arrangement);
}

/// What is said where right and left are exchanged.
Finding exchangedSides(const Directions& found, bool sided) {
  const bool feet = found[2] == Direction::exchanged;
  if (found[1] == Direction::exchanged)
    return feet ? arranged("right and left, front and back, head and feet are exchanged: mirrored",
                           {"flip-xyz"})
                : arranged("right and left are exchanged, and so are front and back: the files seem to be in "
                           "RAS",
                           {"ras-to-lps"});
  if (feet)
    return arranged("head and feet are exchanged, and so are right and left: the patient is upside down",
                    {"flip-xz"});
  if (found[1] == Direction::unknown)
    return arranged("right and left are exchanged: the files may be in RAS, or mirrored",
                    {"ras-to-lps", "mirror"});
  if (found[2] == Direction::unknown)
    return arranged(
        "right and left are exchanged, front and back are not: mirrored, unless head and feet are "
        "exchanged too",
        {"mirror"});
  return sided ? arranged("right and left are exchanged, front and back are not: mirrored", {"mirror"})
               : arranged("right and left are exchanged, front and back are not: mirrored, or situs inversus",
                          {"mirror"});
}

/// What is said where they are not, or where that is not known.
std::optional<Finding> exchangedOthers(const Directions& found) {
  const bool back = found[1] == Direction::exchanged, feet = found[2] == Direction::exchanged;
  if (back && feet)
    return arranged("head and feet are exchanged, and so are front and back: the patient is upside down",
                    {"flip-yz"});
  if (feet && (found[0] == Direction::unknown || found[1] == Direction::unknown))
    return arranged("head and feet are exchanged: the patient is upside down, or mirrored",
                    {"flip-z", found[1] == Direction::unknown ? "flip-yz" : "flip-xz"});
  if (feet)
    return arranged("head and feet are exchanged, front and back are not: the slices seem to be in the "
                    "opposite order, which mirrors the patient",
                    {"flip-z"});
  if (back && found[0] == Direction::unknown)
    return arranged("front and back are exchanged: the files may be in RAS, mirrored, or upside down",
                    {"ras-to-lps", "flip-y"});
  if (back && found[2] == Direction::unknown)
    return arranged(
        "front and back are exchanged, right and left are not: mirrored, unless head and feet are "
        "exchanged too",
        {"flip-y", "flip-yz"});
  if (back)
    return arranged("front and back are exchanged, right and left are not: mirrored", {"flip-y"});
  return std::nullopt;
}

/// Whether the body's axes surely lie along other ones of the file.
bool isTurned(const std::vector<BodyWay>& ways) {
  return std::none_of(ways.begin(), ways.end(), [](const BodyWay& way) { return way.alongAxes(); });
}

/// What is said where the body's axes lie along other ones of the file.
Finding otherAxes(const std::vector<BodyWay>& ways) {
  const BodyWay& best = ways.front();
  const bool up = best.axis == std::array{0, 2, 1} && best.sign[2] > 0 && best.sign[0] != best.sign[1];
  if (isTurned(ways) && up)
    return arranged("the head lies along the y axis: the files seem to come from a program in which y is up",
                    {best.sign[0] > 0 ? "y-up" : "y-up-ras"});
  return arranged("the organs do not lie as in a body whose axes are LPS: other axes, or not of one patient",
                  {"ras-to-lps", "mirror", "y-up"});
}

/// What is said where organs with a side in their names and organs without contradict each other.
std::optional<Finding> contradiction(Direction bySides, Direction byOthers) {
  if (bySides == Direction::kept && byOthers == Direction::exchanged)
    return arranged("organs whose names say left or right lie on that side, but the others lie on the side "
                    "opposite to the usual one: situs inversus, or wrong names",
                    {});
  if (bySides == Direction::exchanged && byOthers == Direction::kept)
    return arranged("organs whose names say left or right lie on the opposite side, but the others lie as "
                    "usual: left and right seem to be exchanged in the names",
                    {});
  return std::nullopt;
}

/// Organs on the wrong side, where the others are right.
std::vector<std::size_t> misplacedAmong(const std::vector<Recognised>& known,
                                        const std::vector<KnownOrgan>& organs, const BodyWay& lps) {
  constexpr double kFar = 3, kNear = 2;
  std::vector<std::size_t> misplaced;
  if (known.size() < kFewestAround)
    return misplaced;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    const double usual = organs[i].expected.x(), spread = organs[i].spread.x();
    if (std::abs(usual) < kOrdered * spread)
      continue;
    const double away = awayFrom(organs, lps, i, 0);
    if (std::abs(away) > kFar * spread && std::abs(away + 2 * usual) < kNear * spread)
      misplaced.push_back(known[i].index);
  }
  if (3 * misplaced.size() > known.size())
    misplaced.clear();
  return misplaced;
}

Finding onWrongSide(const std::vector<PlacedOrgan>& organs, const std::vector<std::size_t>& misplaced) {
  std::vector<Text> names;
  for (std::size_t i = 0; i < std::min(misplaced.size(), kOrgansNamed); ++i)
    names.push_back(named(organs[misplaced[i]].name));
  return arranged(
      phrase("by the other organs, %n {organ lies|organs lie} on the opposite side of the patient: "
             "%2",
             misplaced.size(), listOf(std::move(names))),
      {});
}

/// The factors by which organs are larger than life; of those whose normal volume does not depend on what
/// they hold.
std::vector<double> sizeFactors(const std::vector<PlacedOrgan>& organs) {
  std::vector<double> factors;
  for (const PlacedOrgan& organ : organs) {
    const auto part = organ.volumeMl > 0 ? anatomy::partNamed(organ.name) : std::nullopt;
    const anatomy::Norm* norm = part ? anatomy::volumeNormOf(*part) : nullptr;
    if (!norm || anatomy::organ(part->organ).fills)
      continue;
    const anatomy::Range range = anatomy::rangeOf(*norm);
    factors.push_back(std::cbrt(organ.volumeMl / std::sqrt(range.low * range.high)));
  }
  return factors;
}

/// The factor of most of them; 0 where they do not agree.
double commonFactor(std::vector<double> factors) {
  if (factors.size() < kFewestVolumes)
    return 0;
  std::sort(factors.begin(), factors.end());
  const double middle = std::sqrt(factors[(factors.size() - 1) / 2] * factors[factors.size() / 2]);
  const auto near = std::count_if(factors.begin(), factors.end(), [middle](double factor) {
    return factor < kSameFactor * middle && factor * kSameFactor > middle;
  });
  return 3 * static_cast<std::size_t>(near) >= 2 * factors.size() ? middle : 0;
}

std::optional<Finding> doubtAboutFactor(double factor) {
  if (factor == 0 || (factor < kNotLifeSized && factor * kNotLifeSized > 1))
    return std::nullopt;
  for (const LengthUnit& unit : lengthUnits())
    if (const double left = factor * unit.mm; unit.mm != 1 && left < kUnitFactor && left * kUnitFactor > 1)
      return doubt(
          phrase("by their volumes all organs are %1 times as large as life: the coordinates seem to "
                 "be in %2",
                 inDigits(factor, 2), named(unit.name)),
          {"unit-" + std::string(unit.id)}, FindingSubject::size);
  return doubt(
      phrase("by their volumes all organs are %1 times as large as life: a child, an atlas that is not "
             "life-sized, or another unit",
             inDigits(factor, 2)),
      {}, FindingSubject::size);
}

const BodyWay& lpsAmong(const std::vector<BodyWay>& ways) {
  return *std::find_if(ways.begin(), ways.end(), [](const BodyWay& way) { return way.isLps(); });
}

/// How much worse LPS is than the best way, or the best other way than LPS.
double marginOf(const std::vector<BodyWay>& ways, bool fits) {
  const double lps = lpsAmong(ways).cost;
  if (!fits)
    return lps - ways.front().cost;
  return std::find_if(ways.begin(), ways.end(), [](const BodyWay& way) { return !way.isLps(); })->cost - lps;
}

void judgeAxes(PatientAssessment& patient, const std::vector<PlacedOrgan>& organs,
               const std::vector<Recognised>& known) {
  const std::vector<KnownOrgan> weighedOrgans = weighed(organs, known);
  const std::vector<BodyWay> all = bodyWays(weighedOrgans), ways = plausible(all);
  patient.votes = votesOf(weighedOrgans);
  patient.directions = directionsOf(ways);
  patient.fitsLps = fitsLps(ways);
  patient.margin = marginOf(all, patient.fitsLps);
  const BodyWay& lps = lpsAmong(all);
  const Direction bySides = sideBy(organs, known, true), byOthers = sideBy(organs, known, false);
  if (auto finding = contradiction(bySides, byOthers)) {
    patient.directions[0] = Direction::unknown;
    patient.findings.push_back(std::move(*finding));
    return;
  }
  if (patient.fitsLps) {
    if (patient.sidesChecked())
      patient.misplaced = misplacedAmong(known, weighedOrgans, lps);
    if (!patient.misplaced.empty())
      patient.findings.push_back(onWrongSide(organs, patient.misplaced));
    return;
  }
  if (isTurned(ways))
    patient.findings.push_back(otherAxes(ways));
  else if (patient.directions[0] == Direction::exchanged)
    patient.findings.push_back(exchangedSides(patient.directions, bySides == Direction::exchanged));
  else if (auto finding = exchangedOthers(patient.directions))
    patient.findings.push_back(std::move(*finding));
  else if (patient.margin > kVague * kClearMargin)
    patient.findings.push_back(otherAxes(ways));
  else
    patient.fitsLps = true;
}

} // namespace

std::string PatientAssessment::axes() const {
  const auto all = [this](Direction a, Direction b, Direction c) {
    return directions == std::array{a, b, c};
  };
  constexpr Direction kKept = Direction::kept, kOther = Direction::exchanged, kOpen = Direction::unknown;
  if (fitsLps)
    return all(kKept, kKept, kKept) ? "LPS" : "undecided";
  if (directions[2] == kOther)
    return "head and feet exchanged";
  if (directions[0] == kOther)
    return directions[1] == kOther ? "RAS" : directions[1] == kKept ? "mirrored" : "RAS or mirrored";
  if (directions[1] == kOther)
    return directions[0] == kOpen ? "RAS or mirrored" : "mirrored";
  return "other";
}

PatientAssessment assessPatient(const std::vector<PlacedOrgan>& organs) {
  PatientAssessment patient;
  const std::vector<Recognised> known = knownAmong(organs);
  patient.organs = static_cast<int>(known.size());
  if (known.size() >= 2)
    judgeAxes(patient, organs, known);
  patient.sizeFactor = commonFactor(sizeFactors(organs));
  if (auto size = doubtAboutFactor(patient.sizeFactor))
    patient.findings.push_back(std::move(*size));
  return patient;
}

std::vector<PlacedOrgan> placedOrgans(const LabelMap& map) {
  constexpr double kHalf = 0.5;
  std::vector<PlacedOrgan> organs;
  for (const Segment& segment : map.segments) {
    Vec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = segment.low[static_cast<std::size_t>(axis)] - kHalf;
      high[axis] = segment.high[static_cast<std::size_t>(axis)] + kHalf;
    }
    const Vec3 middle = map.indexToLps * (0.5 * (low + high));
    const Vec3 half = map.indexToLps.linear().cwiseAbs() * (0.5 * (high - low));
    organs.push_back({segment.name, {middle - half, middle + half}, map.volumeMl(segment)});
  }
  return organs;
}

std::optional<Finding> assessArrangement(const std::vector<PlacedOrgan>& organs) {
  for (Finding& finding : assessPatient(organs).findings)
    if (finding.subject == FindingSubject::arrangement)
      return std::move(finding);
  return std::nullopt;
}

} // namespace viscera::medical_io
