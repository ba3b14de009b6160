#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>

#include "lent_display.h"
#include "window/application.h"
#include "window/run_window.h"

/// The tests need an application and a display; listing them needs neither.
int main(int argc, char** argv) {
  bool listing = false;
  for (int i = 1; i < argc; ++i)
    listing = listing || std::strcmp(argv[i], "--gtest_list_tests") == 0;
  testing::InitGoogleTest(&argc, argv);
  if (listing)
    return RUN_ALL_TESTS();
  viscera::tests::useLentDisplay();
  if (qEnvironmentVariableIsEmpty("DISPLAY")) {
    std::puts("The tests of the window need a display: ./test.sh starts a virtual one.");
    return 1;
  }
  qputenv("QT_QPA_PLATFORM", "xcb");
  viscera::app::prepareForApplication();
  viscera::app::Application application(argc, argv);
  viscera::app::setUpApplication(application);
  return RUN_ALL_TESTS();
}
