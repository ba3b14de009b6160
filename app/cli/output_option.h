#pragma once

#include <string>
#include <vector>

namespace viscera::app::cli {

/// An option, or an argument, that names what a command writes.
struct OutputOption {
  std::string name;                      ///< As on the command line: "--csv", "OUT".
  std::vector<std::string> endings = {}; ///< The formats, the usual one first; empty: its writer checks them.
  bool last = false;                     ///< Of its values only the last, and none where --output is given.
  bool stream = false;                   ///< Whether `-` is standard output: what is text.
};

/// A table as an output.
inline OutputOption tableOutput(const std::string& name) {
  return {.name = name, .endings = {".csv", ".txt"}, .stream = true};
}

/// A picture as an output.
inline OutputOption pictureOutput(const std::string& name) {
  return {name, {".png"}};
}

/// A handle file as an output.
inline OutputOption handleOutput(const std::string& name) {
  return {.name = name, .endings = {".mrk.json", ".json", ".fcsv"}, .stream = true};
}

} // namespace viscera::app::cli
