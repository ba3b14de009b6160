#include <dlfcn.h>

/// Takes the place of the system's function in programs with windows under a sanitiser: a library that was
/// unloaded, such as Mesa's driver, has no name any more by which its leaks could be suppressed (leaks.supp).
extern "C" int dlclose(void* /*library*/) {
  return 0;
}
