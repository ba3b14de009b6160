#pragma once

#include <QObject>
#include <QTemporaryDir>
#include <QUrl>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "viscera/document/document.h"
#include "window/main_window.h"

/// Drives the real window by seeded random actions, and looks after each whether what must always hold does.
namespace viscera::tests {

/// One thing that a user does: its kind and numbers in [0, 1) that choose among what there is at that moment.
/// So an action means something in every state, and a list of them can be cut anywhere.
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

/// What must hold, and did not.
enum class Invariant { none, silence, memory, end, document, shown, timeline, volume, undo, redo, closing };
/// In a word or two: "the volumes".
std::string nameOf(Invariant invariant);

struct Violation {
  Invariant invariant = Invariant::none; ///< The first of those that do not hold.
  std::string text;                      ///< All that is wrong; empty when nothing is.

  explicit operator bool() const { return invariant != Invariant::none; }
  void add(Invariant which, const std::string& what);
  void add(const Violation& other);
};

/// Takes what the window would hand to a file manager.
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

  /// Does one action and waits for what it began, unless it is hasty.
  void act(const MonkeyAction& action);
  /// What the last action did, in words: "trigger edit.undo".
  const std::string& did() const { return did_; }
  /// What does not hold after the last action.
  Violation violation();
  /// Undoes everything, then redoes it: what of it does not bring back the documents.
  Violation undoViolation();
  /// Closes the window while a sample organ is on its way, and says what that printed.
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
  bool stuck_ = false; ///< What was begun did not end in time.
};

} // namespace viscera::tests
