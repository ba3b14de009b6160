#include "viscera/thesis/result.h"

#include <algorithm>

#include "viscera/core/text.h"

namespace viscera::thesis {
namespace {

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i == 0 ? "" : ",") + csvField(cells[i]);
  return line + "\n";
}

} // namespace

std::string nameOf(Judgement judgement) {
  switch (judgement) {
  case Judgement::holds:
    return "holds";
  case Judgement::differs:
    return "differs";
  case Judgement::doesNotHold:
    return "does not hold";
  case Judgement::notMeasured:
    return "not measured";
  }
  return {};
}

std::string Verdict::text() const {
  return nameOf(judgement) + (because.empty() ? "" : ", because " + because);
}

Verdict verdictOf(const std::vector<Finding>& findings) {
  Verdict verdict;
  if (findings.empty())
    return verdict;
  std::size_t met = 0;
  for (const Finding& finding : findings) {
    met += finding.met ? 1 : 0;
    if (!finding.met)
      verdict.because += (verdict.because.empty() ? "it takes \"" : "; and \"") + finding.criterion +
                         "\", and we measured " + finding.measured;
  }
  verdict.judgement = met == findings.size() ? Judgement::holds
                      : met > 0              ? Judgement::differs
                                             : Judgement::doesNotHold;
  return verdict;
}

std::string Table::csv() const {
  std::string text = csvLine(header);
  for (const auto& row : rows)
    text += csvLine(row);
  return text;
}

Verdict Result::verdict() const {
  if (!problem.empty())
    return {Judgement::notMeasured, problem};
  return verdictOf(findings);
}

std::string Result::fileName() const {
  std::string name = (table ? "table_" : "figure_") + id;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

} // namespace viscera::thesis
