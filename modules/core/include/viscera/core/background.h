#pragma once

#include <functional>

namespace viscera {

/// Does work on a new thread of low priority and waits for its end; rethrows what it throws. For a worker
/// whose result nobody waits for: while a picture is made it leaves the processors to that, else it has them
/// all. The threads that the work starts have its priority. Where the system knows no priority of single
/// threads, the work has the usual one. For any thread but one that a user waits for.
void inBackground(const std::function<void()>& work);

} // namespace viscera
