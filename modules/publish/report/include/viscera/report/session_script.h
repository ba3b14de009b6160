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
  /// The file in which the session is saved unchanged; empty: none, so surfaces that only the session holds
  /// cannot be named.
  std::filesystem::path session = {};
};

/// A session as a script of shell commands.
struct SessionScript {
  /// Text for `sh`: files that it writes first (handles, pose, landmarks, a key sequence), the commands, and
  /// in comments what no command can do.
  std::string text;
  std::vector<std::string> commands; ///< The lines that begin with `viscera`, in order.
};

/// The session as a script of `viscera` commands that makes the same shapes and numbers in the folder where
/// it runs: every organ in the displayed pose (to rounding), the displayed stress map and motion, and the
/// picture of the view. Organs are named by their files or samples if these are unchanged, else by the
/// session ("session.viscera/Liver"). Texts of the session are quoted, so that none is executed as a command.
/// Reads the organs' files. For any thread.
SessionScript sessionScript(const ScriptSource& source);

} // namespace viscera::report
