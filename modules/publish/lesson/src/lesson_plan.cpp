#include "viscera/lesson/lesson_plan.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "page_strings.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/heart/clinical_numbers.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/presentation/resection.h"

namespace viscera::lesson {
namespace {

using document::Organ;

std::string capital(std::string text) {
  if (!text.empty())
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// The kind of an organ whose name is only its file's: a patient's file may be called by his name. "Organ"
/// for a part or a lesion of one, and for a kind that has no word in the language of the lesson.
std::string kindOf(const std::optional<anatomy::Part>& part, const PageWords& words) {
  if (!part || part->extent != anatomy::Extent::whole)
    return words.said("Organ");
  const std::string title = anatomy::titleOf(*part), said = words.said(title.c_str());
  const bool english = words.said(kLanguageCode) == kLanguageCode;
  return said != title || english ? said : words.said("Organ");
}

std::string titleOf(const Organ& organ, const PageWords& words) {
  const std::optional<anatomy::Part> part = anatomy::partNamed(organ.name);
  if (part && organ.name.size() == anatomy::abbreviationOf(*part).size()) // "LV" or "lv".
    return words.said(anatomy::titleOf(*part).c_str());
  if (!organ.file.empty() && organ.name == organ.file.stem().string())
    return kindOf(part, words);
  const std::string afterFile = organ.name.substr(organ.name.find('/') + 1); // "abdomen/liver"
  return words.said(capital(afterFile).c_str());
}

/// Whether `name` in a specification refers to this organ.
bool isCalled(const Organ& organ, const std::string& name) {
  return organ.name == name || (!organ.origin.surface.empty() && organ.origin.surface == name);
}

const std::string* instead(const LessonSpec& spec, const std::string& name) {
  const auto found = spec.names.find(name);
  return found == spec.names.end() ? nullptr : &found->second;
}

PlannedSurface plannedSurface(const Organ& organ, const document::DocumentState& state,
                              const LessonSpec& spec, const PageWords& words) {
  PlannedSurface surface;
  surface.organ = organ.id;
  surface.title = titleOf(organ, words);
  for (const std::string& name : {organ.name, organ.origin.surface, surface.title})
    if (const std::string* other = instead(spec, name)) {
      surface.title = *other;
      break;
    }
  surface.vertexColors = organ.look.vertexColors && organ.mesh->colors.rows() > 0;
  surface.color = surface.vertexColors
                      ? Vec3(organ.mesh->colors.cast<double>().colwise().mean().transpose() / 255.0)
                      : organ.look.color;
  surface.opacity = organ.look.opacity;
  surface.wall = organ.look.opacity < 1 ||
                 std::any_of(state.organs->begin(), state.organs->end(), [&](const auto& other) {
                   return other->look.visible && other->parent == organ.id;
                 });
  surface.charted = organ.closed() && organ.look.tracked;
  for (const SpecLabel& label : spec.labels)
    if (isCalled(organ, label.surface))
      surface.labels.push_back({label.text, label.at});
  // Parts of a sample organ have names in its definition; a lesson that names some itself means those.
  if (surface.labels.empty())
    for (const geometry::NamedPlace& place : organ.places)
      surface.labels.push_back({words.said(place.name.c_str()), place.at, place.ringMm});
  return surface;
}

/// "End-diastolic volume: women and men, mean +- 2 standard deviations", and where that comes from.
std::string sourceOf(const heart::NormalRange& range, const PageWords& words) {
  return capital(words.said(range.name.c_str())) + ": " + words.inWords(range.meaning) + "; " +
         words.named(range.people) + "; " + words.named(range.source) + ".";
}

std::vector<heart::NormalRange> rangesOf(const Organ& organ, const std::string& title,
                                         const anatomy::Person& person) {
  for (const std::string& name : {organ.name, title})
    if (std::vector<heart::NormalRange> ranges = heart::normalRanges(name, person); !ranges.empty())
      return ranges;
  return {};
}

/// The bands of one organ; a ventricle ejects.
void addRanges(LessonPlan& plan, const Organ& organ, const anatomy::Person& person, const PageWords& words,
               std::set<std::string>& sources) {
  PlannedSurface& surface = plan.surfaces.back();
  if (!surface.charted)
    return;
  for (const heart::NormalRange& range : rangesOf(organ, surface.title, person)) {
    using Quantity = heart::NormalRange::Quantity;
    const bool percent = range.quantity == Quantity::ejectionPercent;
    surface.ejects = surface.ejects || range.quantity == Quantity::endDiastolicMl;
    surface.output = surface.output || range.norm == "lv.ef";
    plan.ranges.push_back({plan.surfaces.size() - 1, percent ? "percent" : "ml", range.low, range.high,
                           surface.title + ", " + words.said(range.name.c_str())});
    const std::string from = sourceOf(range, words);
    if (sources.insert(from).second)
      plan.notes += (plan.notes.empty() ? "" : "\n") + from;
  }
}

/// Beside what is in them, walls would press the curves of ventricles flat.
void chartVentriclesOnly(LessonPlan& plan) {
  const bool any = std::any_of(plan.surfaces.begin(), plan.surfaces.end(),
                               [](const PlannedSurface& surface) { return surface.ejects; });
  for (PlannedSurface& surface : plan.surfaces)
    surface.charted = surface.charted && (surface.ejects || !(any && surface.wall));
}

/// Lessons have words of their own for the phases of the samples; others are called as in the window.
std::string titleOf(const sequences::Phase& phase, const PageWords& words) {
  const std::string english = capital(phase.name.english()), own = words.said(english.c_str());
  return own != english ? own : words.inWords(phase.name.capitalised());
}

void addMotion(LessonPlan& plan, const LessonSource& source, const LessonSpec& spec, const PageWords& words) {
  if (!source.sequence)
    return;
  const sequences::Sequence& sequence = *source.sequence;
  plan.strain = spec.strain;
  plan.rates = spec.rates.empty() ? offeredRates(sequence) : spec.rates;
  std::sort(plan.rates.begin(), plan.rates.end());
  plan.rates.erase(std::unique(plan.rates.begin(), plan.rates.end()), plan.rates.end());
  plan.rate = source.ratePerMinute > 0 ? source.ratePerMinute : sequence.standardRatePerMinute();
  if (std::find(plan.rates.begin(), plan.rates.end(), plan.rate) == plan.rates.end())
    plan.rates.insert(std::upper_bound(plan.rates.begin(), plan.rates.end(), plan.rate), plan.rate);
  const double low = sequence.lowestRatePerMinute(), high = sequence.highestRatePerMinute();
  if (plan.rates.front() < low || plan.rates.back() > high)
    throw UsageError(misuse("It is not a rate at which the sequence can be played"),
                     misuse("rates of the lesson"),
                     misuse("from %1 to %2 a minute", inDigits(low, 4), inDigits(high, 4)));
  for (const double rate : plan.rates)
    for (const sequences::Phase& phase : sequence.phases(rate)) {
      const std::string name = phase.name.english();
      const bool known = std::any_of(plan.phases.begin(), plan.phases.end(),
                                     [&](const PlannedPhase& other) { return other.name == name; });
      const std::string* other = instead(spec, name);
      if (!known)
        plan.phases.push_back({name, other ? *other : titleOf(phase, words)});
    }
}

void addHandles(LessonPlan& plan, const document::Rig& rig, const LessonSpec& spec, const PageWords& words) {
  plan.ownHandles = !spec.handles && !rig.handles.empty() && rig.handles.size() <= kMostOwnHandles;
  if (spec.handles)
    plan.placedHandles = *spec.handles;
  if (plan.ownHandles)
    for (const document::Handle& handle : rig.handles)
      plan.handles.push_back(words.named(handle.label));
}

/// The distance from which one sees as much at 30 degrees.
Eye eyeOf(const presentation::Camera& camera) {
  constexpr double kHalfAngle = std::numbers::pi / 12;
  const Vec3 back = camera.position - camera.focus;
  const double half = camera.angleDegrees * std::numbers::pi / 360;
  const double seen = camera.parallel ? camera.parallelScaleMm : back.norm() * std::tan(half);
  return {camera.focus + back.normalized() * seen / std::tan(kHalfAngle), camera.focus};
}

PlannedCut plannedCut(const presentation::OrganCut& cut, const document::DocumentState& state) {
  const scene::CutPlane plane = presentation::planeOf(cut, state);
  return {plane.origin, plane.normal, cut.on, cut.blood};
}

/// The plane through the left ventricle's long axis and the middle of the right one, without what lies before
/// it; none where the heart's frame is not known.
std::optional<PlannedCut> fourChambers(const LessonSource& source) {
  const heart::BeatingHeart* beating = source.sequence ? source.sequence->heart() : nullptr;
  const std::optional<heart::HeartFrame> frame = beating ? beating->frame() : std::nullopt;
  if (!frame)
    return std::nullopt;
  return PlannedCut{frame->origin(), frame->towardsApex().cross(frame->towardsRight()).normalized()};
}

/// The heart's cut and its conduction system, where the lesson has that heart.
void addHeart(LessonPlan& plan, const LessonSource& source) {
  const auto shown = [&](document::OrganId id) {
    return std::any_of(plan.surfaces.begin(), plan.surfaces.end(),
                       [id](const PlannedSurface& surface) { return surface.organ == id; });
  };
  const auto heart = live::sampleHeartIn(source.state);
  if (source.tissue && heart && shown(heart->outer->id) && source.tissue->isOf(*heart)) {
    plan.cut = plannedCut(source.cut, source.state);
    if (const auto four = fourChambers(source); four && !source.cut.on)
      plan.cut = four;
  }
  const bool ways = std::any_of(source.state.organs->begin(), source.state.organs->end(),
                                [&](const auto& organ) { return !organ->ways.empty() && shown(organ->id); });
  if (source.conduction && ways && source.sequence && source.sequence->heart())
    plan.conduction = PlannedConduction{source.conductionShown};
}

/// The views that the session keeps: they show what is shown, and a motion goes on where they name no
/// instant.
void addKeptSlides(LessonPlan& plan, const LessonSource& source) {
  for (const presentation::Slide& kept : source.slides) {
    PlannedSlide slide;
    slide.title = kept.caption;
    slide.eye = eyeOf(kept.camera);
    if (source.sequence)
      slide.fraction = kept.fraction;
    if (plan.cut && kept.look)
      slide.cut = plannedCut(kept.look->cut, source.state);
    plan.slides.push_back(std::move(slide));
  }
}

/// Takes the slides, with the organs that they hide by their places.
void addSlides(LessonPlan& plan, const document::DocumentState& state, const LessonSpec& spec) {
  for (PlannedSlide slide : spec.slides) {
    const bool known = slide.phase.empty() ||
                       std::any_of(plan.phases.begin(), plan.phases.end(),
                                   [&](const PlannedPhase& phase) { return phase.name == slide.phase; });
    if (!known)
      throw UsageError(misuse("There is no such phase"), slide.phase,
                       misuse("viscera play names the phases of a sequence"));
    for (const std::string& name : slide.hidden) {
      const auto found = std::find_if(plan.surfaces.begin(), plan.surfaces.end(), [&](const auto& surface) {
        return surface.title == name || isCalled(*state.organ(surface.organ), name);
      });
      if (found == plan.surfaces.end())
        throw UsageError(misuse("There is no such organ to hide"), name, misuse("name one that is shown"));
      slide.hiddenSurfaces.push_back(static_cast<std::size_t>(found - plan.surfaces.begin()));
    }
    plan.slides.push_back(std::move(slide));
  }
}

/// A number with one digit that does not vanish, or 1.5, 2.5, 7.5 of them.
double roundRate(double rate) {
  const double ten = std::pow(10, std::floor(std::log10(rate)));
  const double step = rate / ten < 5 ? 0.1 : 0.5;
  return std::round(rate / ten / step) * step * ten;
}

void requireKnown(const std::string& language) {
  std::string codes;
  for (const PageLanguage& known : pageLanguages()) {
    if (language.empty() || known.code == language)
      return;
    codes += (codes.empty() ? "" : ", ") + known.code;
  }
  throw UsageError(misuse("It is not a language of the page"), language, misuse("choose one of %1", codes));
}

} // namespace

std::vector<double> offeredRates(const sequences::Sequence& sequence) {
  const double own = sequence.standardRatePerMinute();
  const double low = std::max(sequence.lowestRatePerMinute(), own / 4);
  const double high = std::min(sequence.highestRatePerMinute(), own * 4);
  std::set<double> rates = {own};
  constexpr int kSteps = static_cast<int>(kMostRates) - 2;
  for (int i = 0; i <= kSteps; ++i) {
    const double rate = roundRate(low * std::pow(high / low, static_cast<double>(i) / kSteps));
    const bool crowded = std::any_of(rates.begin(), rates.end(),
                                     [&](double other) { return std::abs(other - rate) < 0.05 * rate; });
    if (rate >= low && rate <= high && !crowded)
      rates.insert(rate);
  }
  return {rates.begin(), rates.end()};
}

LessonPlan planLesson(const LessonSource& source, const LessonSpec& spec) {
  const document::DocumentState& state = source.state;
  requireKnown(spec.language);
  const PageWords words(spec.language);
  LessonPlan plan;
  plan.language = spec.language;
  plan.notes = spec.notes.empty() ? words.said("For teaching. It is not a medical device.") : spec.notes;
  std::set<std::string> sources;
  for (const auto& organ : *state.organs)
    if (organ->look.visible) {
      plan.surfaces.push_back(plannedSurface(*organ, state, spec, words));
      addRanges(plan, *organ, source.person, words, sources);
    }
  if (plan.surfaces.empty())
    throw UsageError("No organ is shown", "the lesson", "show those that the lesson is about");
  chartVentriclesOnly(plan);
  plan.title = !spec.title.empty() ? spec.title : plan.surfaces.front().title;
  if (spec.title.empty() && source.sequence)
    plan.title += ": " + words.said(source.sequence->name().english().c_str());
  for (const document::Measurement& measurement : *state.measurements) {
    const bool shown =
        std::all_of(measurement.points.begin(), measurement.points.end(), [&](const auto& point) {
          return std::any_of(plan.surfaces.begin(), plan.surfaces.end(), [&](const PlannedSurface& surface) {
            return surface.organ == point.organ || point.organ == document::OrganId{};
          });
        });
    if (shown && !document::isRegion(measurement.kind)) // A lesson has no scan.
      plan.measurements.push_back({measurement, measurement.name});
  }
  if (source.camera && source.camera->position != source.camera->focus)
    plan.eye = eyeOf(*source.camera);
  addMotion(plan, source, spec, words);
  addHandles(plan, *state.rig, spec, words);
  addHeart(plan, source);
  addKeptSlides(plan, source);
  addSlides(plan, state, spec);
  return plan;
}

LessonSpec readySpecFor(const LessonSource& source) {
  const auto isShown = [&](const live::SampleSequence& sample) {
    return std::any_of(source.state.organs->begin(), source.state.organs->end(), [&](const auto& organ) {
      return organ->look.visible && organ->origin.sample.rfind(sample.organ + '@', 0) == 0;
    });
  };
  const auto& samples = live::sampleSequences();
  const auto found = std::find_if(samples.begin(), samples.end(), isShown);
  if (found == samples.end())
    return {};
  LessonSpec spec = readySpec(found->id);
  const bool itsMotion = source.sequence && source.sequence->id() == found->id &&
                         source.sequence->name().english() == found->name;
  if (!itsMotion) { // The texts speak of that motion.
    spec.title = spec.notes = {};
    spec.rates = {};
  }
  if (!itsMotion || !source.slides.empty())
    spec.slides = {};
  return spec;
}

std::vector<LessonText> textsOf(LessonPlan& plan) {
  std::vector<LessonText> texts = {{said("Title"), &plan.title}, {said("Notes"), &plan.notes}};
  for (PlannedSurface& surface : plan.surfaces) {
    texts.push_back({said("Organ"), &surface.title});
    for (PlannedLabel& label : surface.labels)
      texts.push_back({said("Label in the view"), &label.text});
  }
  for (PlannedRange& range : plan.ranges)
    texts.push_back({said("Normal range"), &range.text});
  for (PlannedMeasurement& measurement : plan.measurements)
    texts.push_back({said("Measurement"), &measurement.title});
  for (PlannedPhase& phase : plan.phases)
    texts.push_back({said("Phase"), &phase.title});
  for (PlannedSlide& slide : plan.slides) {
    texts.push_back({said("Slide"), &slide.title});
    texts.push_back({said("Text of the slide"), &slide.text});
  }
  for (std::string& handle : plan.handles)
    texts.push_back({said("Handle"), &handle});
  return texts;
}

} // namespace viscera::lesson
