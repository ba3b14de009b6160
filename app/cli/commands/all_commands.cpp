#include "cli/commands/all_commands.h"

#include "cli/commands/bind_command.h"
#include "cli/commands/convert_command.h"
#include "cli/commands/deform_command.h"
#include "cli/commands/handles_command.h"
#include "cli/commands/info_command.h"
#include "cli/commands/play_command.h"
#include "cli/commands/properties_command.h"
#include "cli/commands/render_command.h"
#include "cli/commands/reproduce_command.h"
#include "cli/commands/sample_command.h"
#include "cli/commands/segment_command.h"
#include "cli/commands/stress_command.h"
#include "cli/commands/systems_command.h"
#include "cli/commands/track_command.h"

namespace viscera::app::cli {

std::vector<std::unique_ptr<Command>> allCommands() {
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(std::make_unique<InfoCommand>());
  commands.push_back(std::make_unique<SystemsCommand>());
  commands.push_back(std::make_unique<SampleCommand>());
  commands.push_back(std::make_unique<ConvertCommand>());
  commands.push_back(std::make_unique<HandlesCommand>());
  commands.push_back(std::make_unique<BindCommand>());
  commands.push_back(std::make_unique<DeformCommand>());
  commands.push_back(std::make_unique<StressCommand>());
  commands.push_back(std::make_unique<PlayCommand>());
  commands.push_back(std::make_unique<TrackCommand>());
  commands.push_back(std::make_unique<SegmentCommand>());
  commands.push_back(std::make_unique<RenderCommand>());
  commands.push_back(std::make_unique<PropertiesCommand>());
  commands.push_back(std::make_unique<ReproduceCommand>());
  return commands;
}

} // namespace viscera::app::cli
