#pragma once

#include <string>
#include <vector>

/// Refuses outputs that would destroy what a command reads, or what it has just written.
namespace viscera::app::cli {

/// Throws `UsageError` when two outputs are one file.
void requireDifferent(const std::vector<std::string>& outputs);

/// Throws `UsageError` for an output that is there and is one of the inputs: the same file by any name (a
/// hard or symbolic link, `./`), a surface or an image in a folder that is an input, or a file that an input
/// session names. `inputs` are arguments as the user gave them: "abdomen.nrrd/liver", "lv=curve.csv",
/// "sample:heart". Reads a session only when the output exists.
void requireNoInput(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

} // namespace viscera::app::cli
