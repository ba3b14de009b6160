#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/document/document.h"
#include "viscera/presentation/view_state.h"

namespace viscera::report {

/// The document, view and file names that a script is made from.
struct ScriptSource {
  document::DocumentState state;
  presentation::ViewState view;
  /// Where the session is saved as it is; empty: nowhere, so that surfaces that only it holds cannot be
  /// named.
  std::filesystem::path session = {};
};

/// A session as a script of shell commands.
struct SessionScript {
  /// For `sh`: files that it writes first (handles, pose, landmarks, a key sequence), the commands, and in
  /// comments what no command can do.
  std::string text;
  std::vector<std::string> commands; ///< The lines that begin with `viscera`, in order.
};

/// The session as a script of `viscera` commands that makes the same shapes and numbers in the folder where
/// it runs: every organ in the pose that is shown (to rounding), the stress map and the motion that the
/// session looks at, its picture. Organs are named by their files or samples where these are still what was
/// read, else by the session ("session.viscera/Liver"). No text of the session is ever taken for a command.
/// Reads the organs' files. For any thread.
SessionScript sessionScript(const ScriptSource& source);

} // namespace viscera::report
