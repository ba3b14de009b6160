#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// Code shared by the fuzzers and the replay of their findings. A target takes any bytes: it returns, or it
/// rejects them by throwing `viscera::Error`. Anything else is a finding.
namespace viscera::fuzz {

using Bytes = std::span<const std::uint8_t>;

struct Target {
  std::string name; ///< "surfaces"; also the folder of its findings.
  void (*run)(Bytes bytes);
  std::vector<std::string> (*seeds)(); ///< Inputs to start from, each accepted or nearly so.
};

/// Targets for all readers of files, and for surfaces.
std::vector<Target> readerTargets();
/// Targets for the program: its command line and plugins.
std::vector<Target> programTargets();

/// A promise that does not hold.
class Broken : public std::logic_error {
  using std::logic_error::logic_error;
};

inline void require(bool holds, const char* promise) {
  if (!holds)
    throw Broken(promise);
}

/// Input for one of several kinds of a thing: the first byte chooses.
struct Choice {
  std::size_t kind = 0;
  Bytes rest;
};
Choice choose(Bytes bytes, std::size_t kinds);
std::string chosen(std::size_t kind, const std::string& rest);

std::string textOf(Bytes bytes);

/// Writes a file that only this process uses, over the one before of that name, and gives its path.
std::filesystem::path scratchFile(const std::string& name, Bytes bytes);
/// The folder of those files.
const std::filesystem::path& scratchFolder();

// The parts of `readerTargets`.
std::vector<Target> imageTargets();
std::vector<Target> documentTargets();
std::vector<Target> motionTargets();
Target surfaceFileTarget();
Target handleFileTarget();
Target modelTarget();
Target surfaceSoupTarget();

} // namespace viscera::fuzz
