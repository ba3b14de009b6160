#include "quiet_vtk.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkObject.h>

#include "text_scanner.h"

namespace viscera::medical_io {
namespace {

/// VTK's messages run "ERROR: In file, line n\nvtkClass (0x...): what".
std::string withoutPlace(const char* message) {
  std::string text = message != nullptr ? message : "an error without a message";
  const std::size_t end = text.find("): ");
  if (end != text.npos)
    text.erase(0, end + 3);
  return std::string(trimmed(text));
}

} // namespace

QuietVtk::QuietVtk(vtkObject* watched) : watched_(watched) {
  command_->SetClientData(&error_);
  command_->SetCallback([](vtkObject*, unsigned long event, void* client, void* message) {
    auto& error = *static_cast<std::string*>(client);
    if (event == vtkCommand::ErrorEvent && error.empty())
      error = withoutPlace(static_cast<const char*>(message));
  });
  errorTag_ = watched_->AddObserver(vtkCommand::ErrorEvent, command_);
  warningTag_ = watched_->AddObserver(vtkCommand::WarningEvent, command_);
}

QuietVtk::~QuietVtk() {
  watched_->RemoveObserver(errorTag_);
  watched_->RemoveObserver(warningTag_);
}

} // namespace viscera::medical_io
