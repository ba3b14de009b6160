#include "viscera/anatomy/norms.h"

#include <algorithm>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::anatomy {
namespace {

/// 19 of 20 people lie within.
constexpr double kDeviations = 2;

Range around(const Measured& measured, Kind kind) {
  const double half = kind == Kind::spread ? kDeviations * measured.deviation : 0;
  return {measured.mean - half, measured.mean + half};
}

Measured timesSurface(const Measured& perM2, double bodySurfaceM2) {
  return {perM2.mean * bodySurfaceM2, perM2.deviation * bodySurfaceM2};
}

bool sized(const Norm& norm, const Person& person) {
  return norm.knowsSize() && person.bodySurfaceM2 > 0;
}

} // namespace

const Norm& norm(std::string_view id) {
  const auto& rows = norms();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Norm& row) { return row.id == id; });
  if (found == rows.end())
    throw UsageError(misuse("There is no such normal range"), std::string(id),
                     misuse("viscera reference names them all"));
  return *found;
}

Range rangeOf(const Norm& norm, const Person& person) {
  if (norm.limits)
    return *norm.limits;
  if (!norm.knowsSex())
    return around(*norm.bothSexes, norm.kind);
  const bool bySize = sized(norm, person);
  const Measured women = bySize ? timesSurface(*norm.womenPerM2, person.bodySurfaceM2) : *norm.women;
  const Measured men = bySize ? timesSurface(*norm.menPerM2, person.bodySurfaceM2) : *norm.men;
  const Range ofWomen = around(women, norm.kind), ofMen = around(men, norm.kind);
  if (person.sex != Sex::either)
    return person.sex == Sex::women ? ofWomen : ofMen;
  return {std::min(ofWomen.low, ofMen.low), std::max(ofWomen.high, ofMen.high)};
}

Text meaningOf(const Norm& norm, const Person& person) {
  const Text who = named(nameOf(norm.knowsSex() ? person.sex : Sex::either));
  if (norm.kind == Kind::limits)
    return who;
  const bool spread = norm.kind == Kind::spread;
  if (!sized(norm, person))
    return spread ? phrase("%1, mean +- 2 standard deviations", who) : phrase("%1, on average", who);
  const Text m2 = inFixed(person.bodySurfaceM2, 2);
  return spread ? phrase("%1, mean +- 2 standard deviations, for %2 m2 of body surface", who, m2)
                : phrase("%1, on average, for %2 m2 of body surface", who, m2);
}

std::string_view nameOf(Sex sex) {
  return sex == Sex::women ? "women" : sex == Sex::men ? "men" : "women and men";
}

std::string_view idOf(Sex sex) {
  return sex == Sex::either ? "either" : nameOf(sex);
}

Sex sexFromId(std::string_view id) {
  return id == "women" ? Sex::women : id == "men" ? Sex::men : Sex::either;
}

} // namespace viscera::anatomy
