#pragma once

#include <string>
#include <vector>

namespace viscera::app::cli {

/// The name that was meant by a misspelt `word`, by the fewest letters that differ, or as the only one that
/// begins so ("seg"); empty when none is near. Capitals do not matter.
std::string meantBy(const std::string& word, const std::vector<std::string>& names);

/// What is wrong with the first word of the command line when it is neither a command nor an option nor a
/// file, in a line of its own: "'defrom' is no command; did you mean 'deform'?". `meant` is empty where no
/// command is near.
struct UnknownCommand {
  std::string word;
  std::string meant;

  std::string problem() const;
  std::string advice() const;
  std::string line() const { return problem() + "; " + advice(); }
};

} // namespace viscera::app::cli
