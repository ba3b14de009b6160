#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/played_sequence.h"
#include "viscera/lesson/lesson_plan.h"

namespace viscera::app::cli {

/// `viscera lesson SEQUENCE|SESSION|ORGAN -o FILE`: organs in motion as a web page, or as animated glTF.
class LessonCommand final : public Command {
public:
  std::string name() const override { return "lesson"; }
  std::string summary() const override {
    return "Make a lesson of organs in motion that opens in any browser, or animated glTF";
  }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  /// What a lesson is made of, bound.
  struct Material {
    std::unique_ptr<BoundDocument> document;
    lesson::LessonSource source;
    std::vector<std::string> warnings;
  };

  Material material(Surroundings& surroundings) const;
  Material ofSession(Surroundings& surroundings) const;
  Material ofSequence(Surroundings& surroundings) const;
  Material ofStillOrgans(Surroundings& surroundings) const;
  lesson::LessonSpec spec() const;
  Outcome write(const std::filesystem::path& file, Surroundings& surroundings) const;
  Outcome writeReady(Surroundings& surroundings);

  PlayRequest request_; ///< `sequence` is the file, sequence or organ that was named.
  std::string output_;
  std::string spec_;
  std::string title_;
  std::vector<std::string> names_;
  double rate_ = 0;
  int handles_ = -1; ///< As the spec has it, or as it comes.
  bool ready_ = false;
};

} // namespace viscera::app::cli
