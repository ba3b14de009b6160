#include "viscera/coordinates/parameters.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::coordinates {
namespace {

std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

Text adviceFor(const Parameter& parameter) {
  if (!parameter.choices.empty())
    return misuse("give one of: %1", joined(parameter.choices));
  const Text low = inDigits(parameter.minimum, 6);
  Text high = inDigits(parameter.maximum, 6);
  if (!parameter.unit.empty())
    high = phrase("%1 %2", high, named(parameter.unit));
  return parameter.integer ? misuse("give a whole number from %1 to %2", low, high)
                           : misuse("give a number from %1 to %2", low, high);
}

const Parameter& find(const std::vector<Parameter>& offered, const std::string& name) {
  const auto found =
      std::find_if(offered.begin(), offered.end(), [&](const Parameter& each) { return each.name == name; });
  if (found != offered.end())
    return *found;
  std::vector<std::string> names;
  for (const Parameter& each : offered)
    names.push_back(each.name);
  throw UsageError(misuse("there is no parameter %1", quoted(name)), {},
                   names.empty() ? Text(misuse("this system has no parameters"))
                                 : misuse("parameters: %1", joined(names)));
}

bool within(const Parameter& parameter, double value) {
  if (!parameter.choices.empty())
    return value >= 0 && value < static_cast<double>(parameter.choices.size()) && value == std::floor(value);
  if (!(value >= parameter.minimum && value <= parameter.maximum))
    return false;
  return !parameter.integer || value == std::floor(value);
}

double parsed(const Parameter& parameter, const std::string& text) {
  const auto choice = std::find(parameter.choices.begin(), parameter.choices.end(), text);
  if (choice != parameter.choices.end())
    return static_cast<double>(choice - parameter.choices.begin());
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0;
  if (parameter.choices.empty() && stream >> value && stream.peek() == std::istringstream::traits_type::eof())
    return value;
  throw UsageError(misuse("%1 is not a value for parameter %2", quoted(text), quoted(parameter.name)), {},
                   adviceFor(parameter));
}

void require(const Parameter& parameter, double value) {
  if (within(parameter, value))
    return;
  throw UsageError(misuse("%1 is out of range for parameter %2", inDigits(value, 6), quoted(parameter.name)),
                   {}, adviceFor(parameter));
}

} // namespace

void ParameterValues::setFromText(const std::vector<Parameter>& offered, const std::string& name,
                                  const std::string& text) {
  const Parameter& parameter = find(offered, name);
  const double value = parsed(parameter, text);
  require(parameter, value);
  set(name, value);
}

double ParameterValues::get(const Parameter& parameter) const {
  const auto found = values_.find(parameter.name);
  return found == values_.end() ? parameter.standard : found->second;
}

void ParameterValues::requireWithin(const std::vector<Parameter>& offered) const {
  for (const auto& [name, value] : values_)
    require(find(offered, name), value);
}

} // namespace viscera::coordinates
