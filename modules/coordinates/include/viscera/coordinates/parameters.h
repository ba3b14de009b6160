#pragma once

#include <map>
#include <string>
#include <vector>

namespace viscera::coordinates {

/// A number that a user may set on a coordinate system. The window creates controls and the command line
/// options from these.
struct Parameter {
  std::string name; ///< As in `--param name=value`.
  double minimum = 0;
  double maximum = 1;
  double standard = 0;   ///< The value when none is given.
  std::string unit = {}; ///< "mm" or empty.
  std::string help = {}; ///< One line.
  bool integer = false;
  std::vector<std::string> choices = {}; ///< Not empty: the value is the index of one of these names.
  /// Accepted so that existing commands and sessions work, although no value changes a coordinate: the window
  /// has no control for it.
  bool withoutEffect = false;
};

/// The values of parameters for one binding, which can be checked against the parameters of the system.
class ParameterValues {
public:
  ParameterValues() = default;
  /// Sets one value; checked only when a system reads it.
  void set(const std::string& name, double value) { values_[name] = value; }
  /// Sets a value from text such as `2.5` or a choice's name. Throws `UsageError` naming what is allowed when
  /// `offered` has no such parameter, the text is no number, or it is out of range.
  void setFromText(const std::vector<Parameter>& offered, const std::string& name, const std::string& text);
  /// The value of `parameter`, or its standard one.
  double get(const Parameter& parameter) const;
  /// Throws `UsageError` for a value that is not in `offered` or is out of range.
  void requireWithin(const std::vector<Parameter>& offered) const;
  const std::map<std::string, double>& all() const { return values_; }

private:
  std::map<std::string, double> values_;
};

} // namespace viscera::coordinates
