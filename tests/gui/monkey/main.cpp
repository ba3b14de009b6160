#include <QElapsedTimer>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../lent_display.h"
#include "coarse_samples.h"
#include "printed.h"
#include "window/application.h"
#include "window/run_window.h"
#include "window_monkey.h"

/// The monkey as a program:
///   window_monkey --seed N [--runs N] [--actions N]   so many runs from that seed on, each a process
///   window_monkey --replay FILE                       the actions of a file, told one by one
///   window_monkey --shrink FILE                       leaves out what does not matter, and writes FILE again
/// The sample organs are coarse, for more actions in the time; with --full before all else they are those of
/// the window. A file goes wrong alike only with the organs that it was found with. What a run that goes
/// wrong did is left in monkey-SEED.txt.
namespace {

using viscera::tests::Invariant;
using viscera::tests::MonkeyAction;
using viscera::tests::Violation;
using Actions = std::vector<MonkeyAction>;

constexpr int kViolation = 1;
// How a run in a process of its own ended: 0, or what kind of fault it had. Beside these, its own exit code
// (what a sanitiser gives).
constexpr int kErrorsPrinted = 2;
constexpr int kFirstInvariant = 64; ///< And the number of the invariant that does not hold.
constexpr int kFirstSignal = 128;
constexpr long kMostMegabytes = 2048;
/// s; longer, and it hangs. Where slow coordinates are chosen, many actions end only when they are cancelled.
constexpr unsigned kLongestRun = 3600;

/// The program's arguments, for Qt.
struct Arguments {
  int count = 0;
  char** values = nullptr;
};

long mostMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// Does the actions in this process; says on standard output what goes wrong. 0 or the kind of fault.
int perform(const Actions& actions, Arguments arguments, bool tell) {
  viscera::app::prepareForApplication();
  viscera::app::Application application(arguments.count, arguments.values);
  viscera::app::setUpApplication(application);
  viscera::tests::keepPrinted();
  viscera::tests::WindowMonkey monkey;
  Violation wrong;
  std::size_t number = 0;
  for (; number < actions.size() && !wrong; ++number) {
    QElapsedTimer timer;
    timer.start();
    monkey.act(actions[number]);
    wrong = monkey.violation();
    if (const long megabytes = mostMegabytes(); megabytes > kMostMegabytes)
      wrong.add(Invariant::memory, "it took " + std::to_string(megabytes) + " MB");
    if (tell)
      std::cout << number << ": " << monkey.did() << ", " << timer.elapsed() << " ms" << std::endl;
  }
  const std::string last = monkey.did();
  if (!wrong)
    wrong = monkey.undoViolation();
  if (!wrong)
    wrong = monkey.sessionViolation();
  if (!wrong)
    wrong = monkey.closeViolation();
  if (!wrong)
    return 0;
  std::cout << "after action " << number << " (" << last << "), " << nameOf(wrong.invariant) << ": "
            << wrong.text << std::endl;
  return kFirstInvariant + static_cast<int>(wrong.invariant);
}

/// What a run wrote to standard error, but for what Mesa says of a display without a graphics processor.
std::string errorsIn(std::FILE* file) {
  std::rewind(file);
  std::string errors;
  for (char line[4096]; std::fgets(line, sizeof line, file) != nullptr;)
    if (!std::string(line).starts_with("libEGL") && !std::string(line).starts_with("MESA"))
      errors += line;
  return errors;
}

/// The same in a process of its own; 0 when all holds and nothing stands on standard error, else the kind of
/// fault.
int performApart(const Actions& actions, const Arguments& arguments, bool tell = false) {
  std::cout.flush();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> errorFile(std::tmpfile(), std::fclose);
  const pid_t child = fork();
  if (child == 0) {
    alarm(kLongestRun);
    dup2(fileno(errorFile.get()), STDERR_FILENO);
    const int code = perform(actions, arguments, tell);
    std::cout.flush();
    std::_Exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    std::cout << "ended by signal " << WTERMSIG(status) << std::endl;
  const std::string errors = errorsIn(errorFile.get());
  if (!errors.empty())
    std::cout << "on standard error: " << errors << std::endl;
  if (WIFSIGNALED(status))
    return kFirstSignal + WTERMSIG(status);
  if (WEXITSTATUS(status) != 0)
    return WEXITSTATUS(status);
  return errors.empty() ? 0 : kErrorsPrinted;
}

Actions read(const std::string& file) {
  Actions actions;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty())
      actions.push_back(viscera::tests::actionFrom(line));
  return actions;
}

void write(const std::string& file, const Actions& actions) {
  std::ofstream stream(file);
  for (const MonkeyAction& action : actions)
    stream << viscera::tests::lineOf(action) << "\n";
}

/// Leaves out parts, halves first, as long as the same kind of fault comes as with all of them.
int shrink(const std::string& file, const Arguments& arguments) {
  Actions actions = read(file);
  const int fault = performApart(actions, arguments);
  if (fault == 0) {
    std::cout << "nothing goes wrong\n";
    return kViolation;
  }
  for (std::size_t part = actions.size() / 2; part > 0; part /= 2) {
    for (std::size_t first = 0; first < actions.size();) {
      Actions less = actions;
      less.erase(less.begin() + static_cast<std::ptrdiff_t>(first),
                 less.begin() + static_cast<std::ptrdiff_t>(std::min(first + part, less.size())));
      if (performApart(less, arguments) == fault) {
        actions = less;
        write(file, actions);
      } else {
        first += part;
      }
    }
  }
  std::cout << actions.size() << " actions are left\n";
  return 0;
}

int runSeeds(unsigned seed, int runs, int count, const Arguments& arguments) {
  int failed = 0;
  for (int run = 0; run < runs; ++run, ++seed) {
    const Actions actions = viscera::tests::randomActions(seed, count);
    if (performApart(actions, arguments) == 0)
      continue;
    ++failed;
    const std::string file = "monkey-" + std::to_string(seed) + ".txt";
    write(file, actions);
    std::cout << "seed " << seed << " went wrong; its actions are in " << file << std::endl;
  }
  std::cout << runs << " runs of " << count << " actions, " << failed << " went wrong" << std::endl;
  return failed == 0 ? 0 : kViolation;
}

} // namespace

int main(int argc, char** argv) {
  unsigned seed = 1;
  int runs = 1, count = 200;
  qputenv("QT_QPA_PLATFORM", "xcb");
  viscera::tests::useLentDisplay();
  const Arguments arguments{argc, argv};
  const bool full = argc > 1 && std::strcmp(argv[1], "--full") == 0;
  std::optional<viscera::tests::CoarseSamples> coarse;
  if (!full)
    coarse.emplace();
  for (int i = full ? 2 : 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--replay")
      return performApart(read(argv[i + 1]), arguments, true);
    if (option == "--shrink")
      return shrink(argv[i + 1], arguments);
    const int number = std::atoi(argv[i + 1]);
    if (option == "--seed")
      seed = static_cast<unsigned>(number);
    else if (option == "--runs")
      runs = number;
    else if (option == "--actions")
      count = number;
  }
  return runSeeds(seed, runs, count, arguments);
}
