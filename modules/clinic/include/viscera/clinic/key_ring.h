#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "viscera/clinic/archive.h"
#include "viscera/core/progress.h"

/// Keeps the passwords of archives where the user's system keeps them, and nowhere else.
namespace viscera::clinic {

/// A place for passwords, one for each address and user. Functions may wait for the user to unlock it, so
/// they belong on a worker. Thread-safe.
class KeyRing {
public:
  virtual ~KeyRing() = default;
  /// Whether there is one. Without, `find` finds nothing and the others do nothing.
  virtual bool isThere() const = 0;
  /// None where it holds none, or is not opened. Throws `Cancelled`.
  virtual std::optional<std::string> find(const ArchiveConnection& connection, Progress& progress) = 0;
  /// Returns whether it is kept. Throws `Cancelled`.
  virtual bool keep(const ArchiveConnection& connection, const std::string& password, Progress& progress) = 0;
  virtual void forget(const ArchiveConnection& connection, Progress& progress) = 0;
};

/// The key ring of the desktop (Secret Service: GNOME, KDE, KeePassXC), spoken to by its own program
/// `secret-tool` of Debian's `libsecret-tools`; a password goes through pipes, never through arguments or
/// files. Without the program, or without a session of a desktop, it is not there.
std::shared_ptr<KeyRing> systemKeyRing();

/// A key ring that is never there: the password is asked for each time.
std::shared_ptr<KeyRing> noKeyRing();

/// Whether the archive asks for a password at all.
bool wantsPassword(const ArchiveConnection& connection);

} // namespace viscera::clinic
