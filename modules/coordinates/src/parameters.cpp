#include "viscera/coordinates/parameters.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "viscera/core/error.h"

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

std::string allowed(const Parameter& parameter) {
  if (!parameter.choices.empty())
    return "one of: " + joined(parameter.choices);
  std::ostringstream text;
  text << (parameter.integer ? "a whole number" : "a number") << " from " << parameter.minimum << " to "
       << parameter.maximum;
  if (!parameter.unit.empty())
    text << " " << parameter.unit;
  return text.str();
}

const Parameter& find(const std::vector<Parameter>& offered, const std::string& name) {
  const auto found =
      std::find_if(offered.begin(), offered.end(), [&](const Parameter& each) { return each.name == name; });
  if (found != offered.end())
    return *found;
  std::vector<std::string> names;
  for (const Parameter& each : offered)
    names.push_back(each.name);
  throw UsageError("there is no parameter " + quoted(name), {},
                   names.empty() ? "this system has no parameters" : "parameters: " + joined(names));
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
  throw UsageError(quoted(text) + " is not a value for parameter " + quoted(parameter.name), {},
                   "give " + allowed(parameter));
}

void require(const Parameter& parameter, double value) {
  if (within(parameter, value))
    return;
  std::ostringstream text;
  text << value << " is out of range for parameter " << quoted(parameter.name);
  throw UsageError(text.str(), {}, "give " + allowed(parameter));
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
