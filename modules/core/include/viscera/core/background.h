#pragma once

#include <functional>

namespace viscera {

/// Runs work on a new thread with low priority and waits for its end; rethrows what it throws. For background
/// results: while a picture is rendered, rendering gets the processors first, else the work gets them all.
/// Threads that the work starts have its priority. On systems without priorities of single threads, the work
/// runs with the usual one. Call it from a worker thread, not from one that the user waits for.
void inBackground(const std::function<void()>& work);

} // namespace viscera
