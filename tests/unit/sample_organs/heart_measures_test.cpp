#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "held_value.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/heart/heart_frame.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/sample_organs/sample_organ.h"

/// The sample heart's tissue measured as an anatomist would, beside what is measured in healthy adults; the
/// rows of the table in docs/sample_organs.md. Ranges are mean +- 2 standard deviations of women and men.
namespace viscera::tests {
namespace {

using heart::HeartValve;
using heart::ValveRing;

/// The project's own definition, its surfaces kept beside the build.
const sample_organs::SampleLibrary& measuredLibrary() {
  static const sample_organs::SampleLibrary library{
      std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
      std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
  return library;
}

/// Inside or outside one surface of the heart.
class Inside {
public:
  explicit Inside(const std::string& surface) {
    Progress progress;
    const auto made = sample_organs::sampleSurface(measuredLibrary(), "heart", surface,
                                                   sample_organs::Resolution::medium, progress);
    winding_ = std::make_unique<geometry::WindingNumber>(*made.mesh);
  }
  bool operator()(const Vec3& point) const { return winding_->inside(point); }

private:
  std::unique_ptr<geometry::WindingNumber> winding_;
};

/// How far one can go from a point until `stops` holds, mm; `far` where it never does.
template <class Stops>
double wayUntil(const Vec3& from, const Vec3& direction, double far, Stops&& stops) {
  constexpr double kStride = 0.5;
  constexpr int kHalvings = 6;
  double way = 0;
  while (way < far && !stops(from + (way + kStride) * direction))
    way += kStride;
  if (way >= far)
    return far;
  double step = kStride;
  for (int i = 0; i < kHalvings; ++i) {
    step /= 2;
    if (!stops(from + (way + step) * direction))
      way += step;
  }
  return way;
}

/// A lumen in the plane across a direction: its mean, least and largest diameter, and how thick its wall is.
struct Lumen {
  double mean = 0, least = 0, largest = 0, wall = 0;
};

constexpr int kLumenRays = 32;
constexpr double kLumenFar = 40;

Lumen lumenAt(Vec3 middle, const Vec3& along, const Vec3& across, const Inside& tissue) {
  const Vec3 normal = along.normalized();
  const Vec3 first = (across - across.dot(normal) * normal).normalized(), second = normal.cross(first);
  std::array<double, kLumenRays> ways{};
  const auto ray = [&](int i) -> Vec3 {
    const double angle = 2 * std::numbers::pi * i / kLumenRays;
    return std::cos(angle) * first + std::sin(angle) * second;
  };
  for (int round = 0; round < 3; ++round) { // From the middle of what the last rays met.
    Vec3 shift = Vec3::Zero();
    for (int i = 0; i < kLumenRays; ++i) {
      ways[static_cast<std::size_t>(i)] = wayUntil(middle, ray(i), kLumenFar, tissue);
      shift += 2.0 / kLumenRays * ways[static_cast<std::size_t>(i)] * ray(i);
    }
    if (round < 2)
      middle += shift;
  }
  Lumen lumen{0, std::numeric_limits<double>::infinity(), 0, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < kLumenRays; ++i) {
    const double way = ways[static_cast<std::size_t>(i)];
    const double diameter = way + ways[static_cast<std::size_t>((i + kLumenRays / 2) % kLumenRays)];
    lumen.mean += diameter / kLumenRays;
    lumen.least = std::min(lumen.least, diameter);
    lumen.largest = std::max(lumen.largest, diameter);
    const Vec3 wall = middle + (way + 0.05) * ray(i);
    lumen.wall =
        std::min(lumen.wall, wayUntil(wall, ray(i), kLumenFar, [&](const Vec3& p) { return !tissue(p); }));
  }
  return lumen;
}

const Inside& heartTissue() {
  static const Inside tissue("tissue");
  return tissue;
}

const ValveRing& ringOf(HeartValve valve) {
  static const heart::ValveRings rings = heart::sampleHeartRings();
  return rings[static_cast<std::size_t>(valve)];
}

/// The opening in which a valve hangs, where it is narrowest near the valve's ring.
Lumen annulusOf(HeartValve valve) {
  const ValveRing& ring = ringOf(valve);
  Lumen narrowest;
  for (double shift = -4; shift <= 4; shift += 1) {
    const Lumen here =
        lumenAt(ring.center + shift * ring.downstream, ring.downstream, ring.first, heartTissue());
    if (narrowest.mean == 0 || here.mean < narrowest.mean)
      narrowest = here;
  }
  return narrowest;
}

TEST(HeartMeasures, AnnuliAreAsLargeAsInHealthyAdults) {
  HeldRange mitral("mitral annulus, lesser and greater diameter", 18, 37, "mm",
                   "Ricci 2021, doi 10.1186/s12968-020-00688-y (721 people, end of diastole)");
  HeldRange tricuspid("tricuspid annulus, lesser and greater diameter", 21, 42, "mm",
                      "Ricci 2021, doi 10.1186/s12968-020-00688-y");
  HeldRange aortic("aortic annulus, lesser and greater diameter", 18, 28.2, "mm",
                   "doi 10.1186/s43044-021-00216-y (516 people, computed tomography)");
  HeldRange pulmonary("pulmonary annulus, lesser and greater diameter", 17, 27.7, "mm",
                      "as the trunk: Burman 2016, doi 10.1186/s12968-016-0230-9 (120 people, diastole)");
  for (auto& [held, valve] : {std::pair<HeldRange&, HeartValve>{mitral, HeartValve::mitral},
                              {tricuspid, HeartValve::tricuspid},
                              {aortic, HeartValve::aortic},
                              {pulmonary, HeartValve::pulmonary}}) {
    const Lumen annulus = annulusOf(valve);
    held.add(annulus.least);
    held.add(annulus.largest);
  }
}

/// A vessel's axis, by some places of the definition; the lumen's own middle is found from them.
using Axis = std::vector<Vec3>;

constexpr int kPlaces = 5;

/// The lumen at five places evenly along the axis, its ends among them.
std::array<Lumen, kPlaces> lumenAlong(const Axis& axis) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < axis.size(); ++i)
    lengths.push_back(lengths.back() + (axis[i] - axis[i - 1]).norm());
  std::array<Lumen, kPlaces> found;
  for (int place = 0; place < kPlaces; ++place) {
    const double way = lengths.back() * place / (kPlaces - 1);
    std::size_t i = 1;
    while (i + 1 < axis.size() && lengths[i] < way)
      ++i;
    const double part = (way - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
    const Vec3 along = axis[i] - axis[i - 1];
    found[static_cast<std::size_t>(place)] =
        lumenAt(axis[i - 1] + part * along, along, along.unitOrthogonal(), heartTissue());
  }
  return found;
}

void addMeans(HeldRange& held, const Axis& axis) {
  for (const Lumen& lumen : lumenAlong(axis))
    held.add(lumen.mean);
}

TEST(HeartMeasures, ArteriesAreAsWideAsInHealthyAdultsAtFivePlaces) {
  HeldRange ascending("ascending aorta, lumen at five places", 22.7, 39.1, "mm",
                      "Hager 2002, doi 10.1067/mtc.2002.122310 (70 people)");
  addMeans(ascending, {{-20, 5, 54}, {-25, 4.5, 68}, {-26, 5, 75}, {-24.5, 9, 85}});
  HeldRange arch("aortic arch, lumen at five places", 17.9, 35.1, "mm",
                 "Hager 2002, doi 10.1067/mtc.2002.122310");
  addMeans(arch, {{-16, 20, 101}, {-10, 27, 105}, {5, 42, 103}, {11, 49, 95}});
  HeldRange descending("descending aorta, lumen at five places", 16.7, 32.7, "mm",
                       "Hager 2002, doi 10.1067/mtc.2002.122310 (isthmus)");
  addMeans(descending, {{14, 53, 88}, {15, 57, 72}, {15, 58, 65}});
  HeldRange trunk("pulmonary trunk, lumen at five places", 19.5, 30.7, "mm",
                  "Truong 2012, doi 10.1161/CIRCIMAGING.111.968610 (3,171 people, computed tomography)");
  addMeans(trunk, {{6, -20, 46}, {8, -16, 52}, {11, -9, 58}});
  HeldRange left("left pulmonary artery, lumen at five places", 11.9, 22.3, "mm",
                 "Burman 2016, doi 10.1186/s12968-016-0230-9");
  addMeans(left, {{28, 24, 73.5}, {34, 30, 73}, {42, 37, 70}});
  HeldRange right("right pulmonary artery, lumen at five places", 10.3, 22.2, "mm",
                  "Burman 2016, doi 10.1186/s12968-016-0230-9");
  addMeans(right, {{-4, 30, 69}, {-18, 36, 68}, {-44, 40, 64}, {-58, 40.7, 61.5}});
}

TEST(HeartMeasures, VeinsAreAsWideAsInHealthyAdultsAtFivePlaces) {
  HeldRange superior("superior vena cava, lumen at five places", 11.7, 23.7, "mm",
                     "5th to 95th percentile of the area, as a circle's diameter: Lin 2009, PubMed 19394871 "
                     "(103 people, computed tomography). 11.6 to 26.4 by ultrasound: Cowie 2015, doi "
                     "10.1177/0310057X1504300312 (91 people)");
  addMeans(superior, {{-48, 16.8, 88}, {-48, 16, 76}, {-48.6, 15.4, 64}});
  HeldRange inferior("inferior vena cava, lumen at five places", 14.8, 26, "mm",
                     "doi 10.1007/s00330-018-5820-5 (1,503 people)");
  addMeans(inferior, {{-47.5, 18, -22}, {-47, 19, -26}, {-46.2, 20.6, -40}});
  HeldRange leftSuperior("left superior pulmonary vein, lumen at five places", 8, 19.6, "mm",
                         "Klimek-Piotrowska 2016, doi 10.7717/peerj.1579 (130 hearts, ostia)");
  addMeans(leftSuperior, {{14, 60, 45}, {20, 62.5, 46.7}, {26, 64.6, 48}});
  HeldRange leftInferior("left inferior pulmonary vein, lumen at five places", 6.5, 20.1, "mm",
                         "Klimek-Piotrowska 2016, doi 10.7717/peerj.1579");
  addMeans(leftInferior, {{14, 64, 18}, {20, 66.8, 16.8}, {26, 69.3, 15.8}});
  HeldRange rightSuperior("right superior pulmonary vein, lumen at five places", 8.5, 20.1, "mm",
                          "Klimek-Piotrowska 2016, doi 10.7717/peerj.1579");
  addMeans(rightSuperior, {{-48, 59, 44}, {-54, 61.5, 45}, {-58, 62.8, 45.5}});
  HeldRange rightInferior("right inferior pulmonary vein, lumen at five places", 7.1, 20.3, "mm",
                          "Klimek-Piotrowska 2016, doi 10.7717/peerj.1579");
  addMeans(rightInferior, {{-48, 62, 16}, {-54, 65, 14.5}, {-58, 66.5, 13.8}});
}

TEST(HeartMeasures, WallsOfVesselsAreAsThickAsTheyAreDrawnInAtlases) {
  HeldRange arteries(
      "walls of aorta and pulmonary trunk, thinnest place", 0.97, 1.99, "mm",
      "the aorta's, 5th to 95th percentile of both sexes: Mensel 2014, doi 10.1007/s00330-014-3188-8 (753 "
      "people, magnetic resonance); the trunk's is thinner than the ascending aorta's");
  for (const Axis& axis : {Axis{{-25, 4.5, 68}, {-26, 5, 75}}, Axis{{14, 53, 88}, {15, 57, 72}},
                           Axis{{8, -16, 52}, {11, -9, 58}}})
    for (const Lumen& lumen : lumenAlong(axis))
      arteries.add(lumen.wall);
  HeldRange veins("walls of venae cavae and pulmonary veins, thinnest place", 0.6, 1.8, "mm", "customary");
  for (const Axis& axis : {Axis{{-48, 16.8, 88}, {-48, 16, 76}}, Axis{{-47, 19, -26}, {-46.2, 20.6, -38}},
                           Axis{{14, 60, 45}, {22, 63.2, 47}}})
    for (const Lumen& lumen : lumenAlong(axis))
      veins.add(lumen.wall);
}

/// The left ventricle's frame, as the definition has it.
const heart::HeartFrame& ventricleFrame() {
  static const heart::HeartFrame frame({-8, 22, 18}, {-0.62, -0.78, 0.05}, {0.64, -0.55, -0.54});
  return frame;
}

/// A place by its way towards the septum, the diaphragm and the apex, mm.
Vec3 ventriclePlace(double a, double b, double c) {
  return ventricleFrame().toWorld(Vec3(a, b, c));
}

/// Basal, middle and apical ring of 6, 6 and 4 segments; the muscle alone, without the fat of the grooves.
TEST(HeartMeasures, MuscleIsAsThickAsInHealthyAdultsInSixteenSegments) {
  struct Ring {
    double height;
    int segments;
  };
  const auto wall = sample_organs::implicitSurface(measuredLibrary(), "heart", "LV_wall");
  const auto cavity = sample_organs::implicitSurface(measuredLibrary(), "heart", "lv_cavity");
  HeldRange held("left ventricle's muscle, 16 segments", 6, 10, "mm",
                 "Lang 2015, doi 10.1016/j.echo.2014.10.003. Thinner, 4 to 9, by magnetic resonance: Kawel "
                 "2012, doi 10.1161/CIRCIMAGING.112.973560");
  const Vec3 origin = ventricleFrame().origin();
  for (const auto& [height, segments] : {Ring{18, 6}, Ring{42, 6}, Ring{66, 4}})
    for (int segment = 0; segment < segments; ++segment) {
      const double angle = 2 * std::numbers::pi * (segment + 0.5) / segments;
      const Vec3 out = ventriclePlace(std::cos(angle), std::sin(angle), 0) - origin;
      const Vec3 axis = ventriclePlace(0, 0, height);
      const double inner = wayUntil(axis, out, kLumenFar, [&](const Vec3& p) { return cavity(p) > 0; });
      const double outer = wayUntil(axis, out, kLumenFar, [&](const Vec3& p) { return wall(p) > 0; });
      // Across the wall, which narrows towards the apex: the way out is the longer side of that.
      const Vec3 inside = axis + inner * out;
      constexpr double kDelta = 0.01;
      const Vec3 gradient((cavity(inside + kDelta * Vec3::UnitX()) - cavity(inside)) / kDelta,
                          (cavity(inside + kDelta * Vec3::UnitY()) - cavity(inside)) / kDelta,
                          (cavity(inside + kDelta * Vec3::UnitZ()) - cavity(inside)) / kDelta);
      held.add((outer - inner) * gradient.normalized().dot(out.normalized()));
    }
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  return 180 / std::numbers::pi * std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0));
}

TEST(HeartMeasures, AxesStandToEachOtherAsInAtlases) {
  const Vec3 toApex = ventriclePlace(0, 0, 1) - ventricleFrame().origin();
  constexpr double kDegrees = 180 / std::numbers::pi;
  HeldRange front("the left ventricle's axis seen from the front, below the horizontal", 18, 58, "degrees",
                  "Engblom 2005, doi 10.1016/j.ahj.2004.10.041 (94 healthy people, magnetic resonance)");
  front.add(std::atan2(-toApex.z(), toApex.x()) * kDegrees);
  HeldRange above("the left ventricle's axis seen from above, before the line from right to left", 32, 60,
                  "degrees", "Engblom 2005, doi 10.1016/j.ahj.2004.10.041");
  above.add(std::atan2(-toApex.y(), toApex.x()) * kDegrees);
  const Vec3 aorta = Vec3(-22, 4, 58) - ringOf(HeartValve::aortic).center;
  const Vec3 trunk = Vec3(12, -6, 61) - ringOf(HeartValve::pulmonary).center;
  HeldRange root("the aorta's first 3 cm and the left ventricle's axis", 109, 145, "degrees",
                 "doi 10.1111/echo.15298 (100 people without heart disease, computed tomography)");
  root.add(degreesBetween(aorta, toApex));
  HeldRange tracts("the outflow tracts, which cross", 40, 100, "degrees", "customary");
  tracts.add(degreesBetween(aorta, trunk));
  HeldRange planes("the planes of mitral and aortic valve, which open towards the ventricle", 100, 160,
                   "degrees", "customary");
  planes.add(degreesBetween(ringOf(HeartValve::mitral).downstream, ringOf(HeartValve::aortic).downstream));
}

/// Points of a valve's ring, evenly around it.
std::vector<Vec3> around(const ValveRing& ring) {
  constexpr int kPoints = 180;
  std::vector<Vec3> points;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    points.push_back(ring.center + std::cos(angle) * ring.first + std::sin(angle) * ring.second);
  }
  return points;
}

TEST(HeartMeasures, MitralAndAorticValveAreContinuous) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& a : around(ringOf(HeartValve::mitral)))
    for (const Vec3& b : around(ringOf(HeartValve::aortic)))
      nearest = std::min(nearest, (a - b).norm());
  HeldRange held("mitral and aortic ring, nearest places", 0.5, 18.5, "mm",
                 "the fibrous curtain's edges: Cavalcanti 2005, J Morphol Sci 22(1), 30 hearts; the journal "
                 "gave no DOI");
  held.add(nearest);
}

TEST(HeartMeasures, TricuspidValveHangsNearerToTheApexAtTheSeptum) {
  const Vec3 toApex = ventriclePlace(0, 0, 1) - ventriclePlace(0, 0, 0);
  const auto hinge = [](HeartValve valve, HeartValve other) {
    const std::vector<Vec3> ring = around(ringOf(valve));
    return *std::min_element(ring.begin(), ring.end(), [&](const Vec3& a, const Vec3& b) {
      return (a - ringOf(other).center).norm() < (b - ringOf(other).center).norm();
    });
  };
  HeldRange held("septal hinge of the tricuspid valve, nearer to the apex than the mitral one's", 2.2, 10,
                 "mm",
                 "less than 8 mm for each m2 of body surface: guideline 2020, doi "
                 "10.1093/eurheartj/ehaa554; at least what it is before birth, when it still grows: "
                 "Vettraino 2002, doi 10.7863/jum.2002.21.10.1099 (145 fetuses)");
  held.add(
      (hinge(HeartValve::tricuspid, HeartValve::mitral) - hinge(HeartValve::mitral, HeartValve::tricuspid))
          .dot(toApex));
}

using Path = std::vector<Vec3>;

/// How often the way between two points goes through a ring, with the flow positive.
int passes(const ValveRing& ring, const Vec3& from, const Vec3& to) {
  const double before = (from - ring.center).dot(ring.downstream),
               after = (to - ring.center).dot(ring.downstream);
  if ((before < 0) == (after < 0))
    return 0;
  const Vec3 at = from + before / (before - after) * (to - from) - ring.center;
  const double u = at.dot(ring.first) / ring.first.squaredNorm(),
               v = at.dot(ring.second) / ring.second.squaredNorm();
  return std::hypot(u, v) < 1 ? (after > before ? 1 : -1) : 0;
}

/// What lies outside the blood on a path, and how often it goes through a valve.
struct Passage {
  int outside = 0;
  int through = 0;
};

Passage along(const Path& path, const Inside& blood, HeartValve inlet, HeartValve outlet) {
  constexpr double kStep = 0.5;
  Passage found;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec3 way = path[i + 1] - path[i];
    const int steps = static_cast<int>(std::ceil(way.norm() / kStep));
    for (int step = 0; step < steps; ++step) {
      const Vec3 at = path[i] + static_cast<double>(step) / steps * way;
      found.outside += blood(at) && !heartTissue()(at) ? 0 : 1;
    }
    found.through += passes(ringOf(inlet), path[i], path[i + 1]);
    found.through += 10 * passes(ringOf(outlet), path[i], path[i + 1]);
  }
  return found;
}

Path joined(std::initializer_list<Path> parts) {
  Path path;
  for (const Path& part : parts)
    path.insert(path.end(), part.begin(), part.end());
  return path;
}

/// Once through the inlet's ring and once through the outlet's, with the flow.
constexpr int kThroughBoth = 11;

void expectBlood(const std::string& side, const std::vector<Path>& veins, const Path& middle,
                 const std::vector<Path>& arteries, HeartValve inlet, HeartValve outlet, HeldValue& held) {
  const Inside blood(side);
  for (std::size_t vein = 0; vein < veins.size(); ++vein)
    for (std::size_t artery = 0; artery < arteries.size(); ++artery) {
      const Passage found = along(joined({veins[vein], middle, arteries[artery]}), blood, inlet, outlet);
      EXPECT_EQ(found.through, kThroughBoth) << side << ": from vein " << vein << " to artery " << artery;
      held.add(found.outside);
    }
}

TEST(HeartMeasures, BloodGoesFromEachPulmonaryVeinToEachArteryThroughTheRingsOfItsValves) {
  HeldValue held("places outside the blood on the 16 ways from a pulmonary vein to an artery of the body", 0);
  const Path arch = {{-22, 4, 58}, {-26, 5, 75}, {-22, 13, 93}};
  const auto upTo = [&](const Path& end) { return joined({arch, end}); };
  expectBlood("blood_left",
              {{{22, 63, 47}, {14, 60, 45}, {-2, 52, 40}},
               {{22, 67.5, 16.5}, {14, 64, 18}, {-2, 54, 22}},
               {{-54, 61.5, 45}, {-48, 59, 44}, {-34, 52, 40}},
               {{-54, 65, 14.5}, {-48, 62, 16}, {-34, 54, 20}}},
              {{-14, 47, 28},
               ventriclePlace(-8, 6, -6),
               ventriclePlace(-5.2, 7, 1),
               ventriclePlace(0, 0, 22),
               ventriclePlace(9, -12, 6),
               ventriclePlace(7.5, -10, -4),
               {-15, 8, 43}},
              {upTo({{-20, 16, 100}, {-25, 14, 114}, {-28, 12.5, 122}}),
               upTo({{-10, 27, 105}, {-9, 27, 109}, {-8, 25, 120}, {-7.4, 23, 126}}),
               upTo({{-10, 27, 105}, {5, 42, 103}, {3, 38, 108}, {7, 38, 119}, {10, 37, 124}}),
               upTo({{-10, 27, 105}, {5, 42, 103}, {14, 53, 88}, {15, 57, 72}, {15, 58, 66}})},
              HeartValve::mitral, HeartValve::aortic, held);
}

TEST(HeartMeasures, BloodGoesFromEachVenaCavaToEachPulmonaryArteryThroughTheRingsOfItsValves) {
  HeldValue held("places outside the blood on the 4 ways from a vena cava to a pulmonary artery", 0);
  expectBlood(
      "blood_right",
      {{{-48, 16.8, 85}, {-48, 16, 76}, {-49, 15, 56}}, {{-46.2, 20.6, -36}, {-47, 19, -26}, {-49, 15, -8}}},
      {{-50, 12, 16},
       ventriclePlace(38, 17, -9),
       ventriclePlace(40.6, 14.2, 0),
       ventriclePlace(44, 8, 16),
       ventriclePlace(40, -14, 26),
       ventriclePlace(33, -26, 24),
       ventriclePlace(28, -37, 18),
       {7, -19, 48},
       {12, -6, 61},
       {15, 5, 67}},
      {{{24, 19, 73}, {34, 30, 73}, {39, 34.5, 71}},
       {{4, 26, 69}, {-18, 36, 68}, {-44, 40, 64}, {-55, 40.5, 62}}},
      HeartValve::tricuspid, HeartValve::pulmonary, held);
}

} // namespace
} // namespace viscera::tests
