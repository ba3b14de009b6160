#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "../lent_display.h"
#include "../monkey/printed.h"
#include "window/application.h"
#include "window/run_window.h"
#include "window_soak.h"

/// The soak as a program, which ends with 1 when something was wrong:
///   window_soak --seconds 3600 --csv soak.csv   an hour; every second of it is a row of the table
/// Memory alone, in the hour after half an hour of warm-up:
///   window_soak --seconds 5400 --warm-up 1800 --late-frames allowed
int main(int argc, char** argv) {
  double seconds = 60, warmUp = -1;
  std::string csv = "soak.csv";
  viscera::tests::SoakRules rules;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--seconds")
      seconds = std::atof(argv[i + 1]);
    else if (option == "--csv")
      csv = argv[i + 1];
    else if (option == "--warm-up")
      warmUp = std::atof(argv[i + 1]);
    else if (option == "--late-frames")
      rules.lateFramesAllowed = argv[i + 1] == std::string("allowed");
  }
  if (warmUp >= 0)
    rules.warmUp = warmUp / seconds;
  qputenv("QT_QPA_PLATFORM", "xcb");
  viscera::tests::useLentDisplay();
  viscera::app::prepareForApplication();
  viscera::app::Application application(argc, argv);
  viscera::app::setUpApplication(application);
  viscera::tests::keepPrinted();

  std::ofstream table(csv);
  table << "seconds,resident_mb,own_mb,allocated_mb,descriptors,threads,frames,longest_ms,paused_ms,"
           "work_us,process_ms,kernel_ms,page_faults,occupation\n";
  std::vector<viscera::tests::SoakSample> samples(static_cast<std::size_t>(std::max(seconds, 0.0)) + 10);
  samples.clear(); // What grows later is not this table.
  viscera::tests::WindowSoak().run(seconds, [&](const viscera::tests::SoakSample& sample) {
    samples.push_back(sample);
    table << sample.seconds << ',' << sample.use.residentMb << ',' << sample.use.ownMb << ','
          << sample.use.allocatedMb << ',' << sample.use.descriptors << ',' << sample.use.threads << ','
          << sample.frames << ',' << sample.longestMs << ',' << sample.machine.pausedMs << ','
          << sample.machine.workUs << ',' << sample.machine.processMs << ',' << sample.machine.kernelMs << ','
          << sample.machine.pageFaults << ',' << sample.occupation << std::endl;
  });
  std::vector<std::string> faults = viscera::tests::soakFaults(samples, rules);
  if (const std::string printed = viscera::tests::takePrinted(); !printed.empty())
    faults.push_back(printed);
  for (const std::string& fault : faults)
    std::cout << fault << "\n";
  std::cout << samples.size() << " seconds, " << faults.size() << " faults" << std::endl;
  return faults.empty() ? 0 : 1;
}
