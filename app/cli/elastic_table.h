#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/elasticity/drag_table.h"

namespace viscera::app::cli {

/// The table of coordinate systems beside elasticity, of `viscera properties --elasticity`.
class ElasticTable {
public:
  /// Defines `--elasticity`, `--organs`, `--drags`, `--tetrahedra`, `--poisson` and `--figure`.
  void addTo(CLI::App& options);

  bool asked() const { return asked_; }

  /// Solves the drags once, compares all variants with them, and writes `csv` (where not empty) and the
  /// figure. Throws `UsageError` for an unknown organ, `Cancelled`.
  Outcome run(const std::vector<coordinates::SystemVariant>& variants, const std::string& csv,
              CommandContext& context) const;

private:
  bool asked_ = false;
  std::vector<std::string> organs_ = {"liver", "stomach", "heart", "kidney_left", "digestive_system/spleen"};
  elasticity::DragOptions drags_;
  std::string figure_;
};

} // namespace viscera::app::cli
