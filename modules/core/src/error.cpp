#include "viscera/core/error.h"

#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "viscera/core/phrase.h"

namespace viscera {
namespace {

Text joined(const Text& problem, const Text& where, const Text& tryThis) {
  const Text text = where.empty() ? problem : phrase("%1: %2", where, problem);
  return tryThis.empty() ? text : phrase("%1 (%2)", text, tryThis);
}

} // namespace

Error::Error(int exitCode, Text what, Text where, Text tryThis)
    : std::runtime_error(joined(what.capitalised(), where, tryThis).english()), problem_(what.capitalised()),
      where_(std::move(where)), tryThis_(std::move(tryThis)), exitCode_(exitCode) {}

Text Error::explanation() const {
  return joined(problem_, where_, tryThis_);
}

UsageError::UsageError(Text what, Text where, Text tryThis)
    : Error(64, std::move(what), std::move(where), std::move(tryThis)) {}

DataError::DataError(Text what, Text where, Text tryThis)
    : Error(65, std::move(what), std::move(where), std::move(tryThis)) {}

NoInputError::NoInputError(Text what, Text where, Text tryThis)
    : Error(66, std::move(what), std::move(where), std::move(tryThis)) {}

CannotCreateError::CannotCreateError(Text what, Text where, Text tryThis)
    : Error(73, std::move(what), std::move(where), std::move(tryThis)) {}

Cancelled::Cancelled() : Error(130, "cancelled") {}

Error notEnoughMemory(Text where) {
  return Error(kInternalError, "There is not enough memory", std::move(where),
               "close other programs, or use fewer handles or smaller organs");
}

bool reportsShortMemory(const std::exception& exception) noexcept {
  if (dynamic_cast<const std::bad_alloc*>(&exception) || dynamic_cast<const std::length_error*>(&exception))
    return true;
  // oneTBB, on which VTK runs, says in words that it cannot make a thread.
  if (std::string_view(exception.what()).starts_with("pthread_create"))
    return true;
  const auto* ofSystem = dynamic_cast<const std::system_error*>(&exception);
  return ofSystem && (ofSystem->code() == std::errc::not_enough_memory ||
                      ofSystem->code() == std::errc::resource_unavailable_try_again);
}

Text explanationOf(const std::exception& exception) {
  if (reportsShortMemory(exception))
    return notEnoughMemory().explanation();
  const auto* known = dynamic_cast<const Error*>(&exception);
  return known ? known->explanation() : Text(std::string(exception.what()));
}

} // namespace viscera
