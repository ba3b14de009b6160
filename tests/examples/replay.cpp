#include <iostream>

#include "viscera/workbench/workbench.h"

// Replays a drag, a beat and a session without a window, as a worked example of docs/developer_guide.md.
int main(int, char** arguments) {
  viscera::workbench::Workbench bench;
  bench.restore(arguments[1]);
  std::cout.precision(17);
  for (const auto& instant : bench.play(25))
    std::cout << instant.seconds << ' ' << instant.milliliters.front() << '\n';
  const std::string organ = bench.state().organs->front()->name;
  bench.lock(organ);
  bench.drag("H-9", viscera::Vec3(6, -4, 3)); // mm
  std::cout << organ << ' ' << bench.volume(organ).nowMl << '\n';
  bench.save(arguments[2]);
}
