#pragma once

#include "viscera/core/job_queue.h"

namespace viscera::app {

/// Where workers leave what is to be done on the thread that calls this, in their order; its event loop does
/// it. What is left there when the last copy goes is not done.
///
///     JobQueue jobs(mailbox());
JobQueue::Post mailbox();

} // namespace viscera::app
