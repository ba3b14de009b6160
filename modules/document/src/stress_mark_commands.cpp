#include "viscera/document/stress_mark_commands.h"

#include <algorithm>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

constexpr const char* kProbe = "stress probe";
constexpr const char* kLine = "stress profile";

int freeNumber(const std::vector<StressProbe>& probes) {
  const auto taken = [&probes](int number) {
    return std::any_of(probes.begin(), probes.end(),
                       [number](const StressProbe& probe) { return probe.number == number; });
  };
  int number = 1;
  while (taken(number))
    ++number;
  return number;
}

bool joins(const StressLine& line, StressProbeId a, StressProbeId b) {
  return (line.from == a && line.to == b) || (line.from == b && line.to == a);
}

} // namespace

const StressProbe* StressMarks::probe(StressProbeId id) const {
  const auto found =
      std::find_if(probes.begin(), probes.end(), [id](const StressProbe& item) { return item.id == id; });
  return found == probes.end() ? nullptr : &*found;
}

std::string StressMarks::nameOf(const StressLine& line) const {
  const StressProbe *start = probe(line.from), *end = probe(line.to);
  return start && end ? std::to_string(start->number) + "-" + std::to_string(end->number) : std::string();
}

Command addStressProbe(OrganId organ, const Vec3& rest) {
  return edit::onPart(
      "Pin stress probe", &DocumentState::stressMarks,
      [organ, rest](StressMarks& marks, const DocumentState& state, IdSource& ids) {
        edit::requireOrgan(state, organ);
        marks.probes.push_back({ids.next<StressProbeId>(), freeNumber(marks.probes), organ, rest});
      });
}

Command addStressLine(StressProbeId from, StressProbeId to) {
  return edit::onPart("Draw stress profile", &DocumentState::stressMarks,
                      [from, to](StressMarks& marks, const DocumentState&, IdSource& ids) {
                        const StressProbe a = edit::require(marks.probes, from, kProbe);
                        const StressProbe b = edit::require(marks.probes, to, kProbe);
                        if (from == to || a.organ != b.organ)
                          throw UsageError("A profile needs two probes of one organ");
                        if (std::any_of(marks.lines.begin(), marks.lines.end(),
                                        [&](const StressLine& line) { return joins(line, from, to); }))
                          throw UsageError("These two probes have a profile already");
                        marks.lines.push_back({ids.next<StressLineId>(), from, to});
                      });
}

Command removeStressProbes(std::vector<StressProbeId> probes) {
  const Text name = phrase("Remove {stress probe|%n stress probes}", probes.size());
  return edit::onPart(name, &DocumentState::stressMarks, [probes = std::move(probes)](StressMarks& marks) {
    edit::remove(marks.probes, probes, kProbe);
    std::erase_if(marks.lines, [&marks](const StressLine& line) {
      return !marks.probe(line.from) || !marks.probe(line.to);
    });
  });
}

Command removeStressLines(std::vector<StressLineId> lines) {
  return edit::onPart(
      "Remove stress profile", &DocumentState::stressMarks,
      [lines = std::move(lines)](StressMarks& marks) { edit::remove(marks.lines, lines, kLine); });
}

Command removeAllStressMarks() {
  return edit::onPart("Remove all stress probes", &DocumentState::stressMarks,
                      [](StressMarks& marks) { marks = {}; });
}

} // namespace viscera::document
