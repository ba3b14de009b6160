#pragma once

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera handles`: places handles around an organ, or takes a cage's vertices, in groups where they are
/// asked for.
class HandlesCommand final : public Command {
public:
  std::string name() const override { return "handles"; }
  std::string summary() const override { return "Place handles around an organ"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  bool grouped() const { return groups_ > 0 || !groupBy_.empty(); }

  std::string organ_;
  std::string output_;
  int count_ = 30;
  bool enclosing_ = false;
  int groups_ = 0; ///< 0: none asked for.
  std::string groupBy_;
  std::string cage_; ///< A surface file whose vertices become the handles; empty: they are placed.
};

} // namespace viscera::app::cli
