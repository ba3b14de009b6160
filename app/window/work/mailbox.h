#pragma once

#include "viscera/core/job_queue.h"

namespace viscera::app {

/// Takes functions from any thread and calls them one after the other from the event loop of the thread that
/// made it. Those that still wait when its last copy is destroyed are not called.
///
///     JobQueue jobs(mailbox());
JobQueue::Post mailbox();

} // namespace viscera::app
