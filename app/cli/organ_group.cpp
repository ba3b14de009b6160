#include "cli/organ_group.h"

#include <filesystem>
#include <utility>

#include "cli/inputs.h"
#include "viscera/document/document.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"

namespace viscera::app::cli {
namespace {

void addBatch(OrganGroup& group, std::vector<document::NewOrgan> batch) {
  const auto before = static_cast<int>(group.organs.size());
  for (document::NewOrgan& item : batch) {
    group.cavityOf.push_back(item.parentInBatch < 0 ? -1 : before + item.parentInBatch);
    group.organs.push_back(std::move(item.organ));
  }
}

void addSession(OrganGroup& group, const document::OrganList& organs) {
  const auto before = group.organs.size();
  for (const auto& organ : organs) {
    int parent = -1;
    for (std::size_t i = before; i < group.organs.size(); ++i)
      if (group.organs[i].id == organ->parent)
        parent = static_cast<int>(i);
    group.cavityOf.push_back(parent);
    group.organs.push_back(*organ);
  }
}

void addInput(OrganGroup& group, const std::string& input, const sample_organs::SampleLibrary& samples,
              Progress& progress) {
  if (isSample(input) && sampleReference(input).surface.empty()) {
    const SampleReference reference = sampleReference(input);
    addBatch(group, document::organsFrom(sample_organs::sampleOrgan(samples, reference.organ,
                                                                    reference.resolution, progress)));
  } else if (std::error_code unreachable; !std::filesystem::exists(input, unreachable)) {
    for (document::Organ& organ : organInputs(input, samples, progress)) {
      group.warnings.insert(group.warnings.end(), organ.warnings.begin(), organ.warnings.end());
      group.organs.push_back(std::move(organ));
      group.cavityOf.push_back(-1);
    }
  } else if (document::isSessionFile(input)) {
    addSession(group, *document::readSession(input, samples, progress).contents.state.organs);
  } else {
    document::OpenedFiles opened = document::openFiles({input}, progress);
    group.warnings.insert(group.warnings.end(), opened.warnings.begin(), opened.warnings.end());
    addBatch(group, std::move(opened.organs));
  }
}

} // namespace

OrganGroup organGroup(const std::vector<std::string>& inputs, const sample_organs::SampleLibrary& samples,
                      Progress& progress) {
  OrganGroup group;
  for (const std::string& input : inputs)
    addInput(group, input, samples, progress);
  return group;
}

} // namespace viscera::app::cli
