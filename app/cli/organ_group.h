#pragma once

#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/organ.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::app::cli {

/// Organs of several arguments, each cavity behind its organ.
struct OrganGroup {
  std::vector<document::Organ> organs;
  std::vector<int> cavityOf; ///< For each the place of the organ whose cavity it is; -1: none.
  std::vector<Text> warnings;
};

/// Reads all organs of the arguments, with their cavities: of a sample organ ("sample:heart"), a session, a
/// label map, a file of several surfaces; or the one that is named behind a slash. Throws what `organInputs`
/// throws.
OrganGroup organGroup(const std::vector<std::string>& inputs, const sample_organs::SampleLibrary& samples,
                      Progress& progress);

} // namespace viscera::app::cli
