#pragma once

#include <QObject>
#include <QTemporaryDir>
#include <QUrl>

#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "viscera/document/document.h"
#include "window/main_window.h"

/// Drives the real window by seeded random actions, and checks invariants after each.
namespace viscera::tests {

/// One action of a user: its kind, and numbers in [0, 1) that choose among the present targets. So an action
/// is meaningful in every state, and a list of actions can be cut anywhere.
struct MonkeyAction {
  std::string kind; ///< "drag", "trigger", ...; see window_monkey.cpp.
  double a = 0, b = 0, c = 0, d = 0;
  bool hasty = false; ///< The next action does not wait until the work that this one began is done.
};

/// A line a list item: "drag 0.1 0.2 0.3 0.4 hasty".
std::string lineOf(const MonkeyAction& action);
MonkeyAction actionFrom(const std::string& line);
/// `count` actions from a seed: always the same.
std::vector<MonkeyAction> randomActions(unsigned seed, int count);

/// The invariants that are checked.
enum class Invariant {
  none,
  silence,
  memory,
  end,
  document,
  shown,
  timeline,
  volume,
  undo,
  redo,
  session,
  closing
};
/// In a word or two: "the volumes".
std::string nameOf(Invariant invariant);

struct Violation {
  Invariant invariant = Invariant::none; ///< The first of those that do not hold.
  std::string text;                      ///< Description of all violations; empty for none.

  explicit operator bool() const { return invariant != Invariant::none; }
  void add(Invariant which, const std::string& what);
  void add(const Violation& other);
};

/// Receives the URLs that the window would open in a file manager.
class RefusedUrls final : public QObject {
  Q_OBJECT

public Q_SLOTS:
  void take(const QUrl&) {}
};

/// A window of its own, in a folder of its own, with a clock that the actions turn.
class WindowMonkey {
public:
  WindowMonkey();
  ~WindowMonkey();

  /// Does one action and waits for the work that it starts, unless it is hasty.
  void act(const MonkeyAction& action);
  /// A description of the last action: "trigger edit.undo".
  const std::string& did() const { return did_; }
  /// The violation after the last action.
  Violation violation();
  /// Undoes everything, then redoes it, and checks that both restore the documents.
  Violation undoViolation();
  /// Saves the session, opens it and saves it again, and checks that this gives the same document and the
  /// same file.
  Violation sessionViolation();
  /// Closes the window while a sample organ is loading, and returns what that printed.
  Violation closeViolation();

private:
  void openSomething(double which);
  void triggerAction(double which);
  void useWidget(const MonkeyAction& action);
  void dragInView(const MonkeyAction& action);
  void clickInView(const MonkeyAction& action);
  void pressKey(const MonkeyAction& action);
  void saveAndOpen(const MonkeyAction& action);
  void changeWindow(const MonkeyAction& action);
  void play(const MonkeyAction& action);
  void dismissDialogs();
  static void pump();
  void settle();
  bool comesToPeace(int milliseconds, const std::function<void()>& meanwhile = {});
  /// Returns false if the session could not be saved.
  bool save(const QString& file, bool embed);
  QPoint placeInView(double x, double y);
  void makeFiles();
  std::string wrongVolumes();

  RefusedUrls refused_;
  QTemporaryDir folder_;
  QStringList files_;
  double now_ = 0; ///< The clock of the sequences, s.
  std::unique_ptr<app::Settings> settings_;
  std::unique_ptr<app::MainWindow> window_;
  document::DocumentState begin_; ///< Where undo leads to.
  Subscription changes_;
  std::string did_;
  int patience_ = 60000; ///< ms, for the work that an action begins.
  bool stuck_ = false;   ///< The work that was cancelled did not end in time.
};

} // namespace viscera::tests
