#include "viscera/core/error.h"

#include <new>
#include <system_error>
#include <utility>

namespace viscera {
namespace {

/// `text` with a capital letter first, because messages for users are sentences.
std::string sentence(const std::string& text) {
  const bool small = !text.empty() && text[0] >= 'a' && text[0] <= 'z';
  return small ? static_cast<char>(text[0] - 'a' + 'A') + text.substr(1) : text;
}

std::string joined(const std::string& what, const std::string& where, const std::string& tryThis) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!tryThis.empty())
    text += " (" + tryThis + ")";
  return text;
}

} // namespace

Error::Error(int exitCode, std::string what, std::string where, std::string tryThis)
    : std::runtime_error(joined(sentence(what), where, tryThis)), problem_(sentence(what)),
      where_(std::move(where)), tryThis_(std::move(tryThis)), exitCode_(exitCode) {}

UsageError::UsageError(std::string what, std::string where, std::string tryThis)
    : Error(64, std::move(what), std::move(where), std::move(tryThis)) {}

DataError::DataError(std::string what, std::string where, std::string tryThis)
    : Error(65, std::move(what), std::move(where), std::move(tryThis)) {}

NoInputError::NoInputError(std::string what, std::string where, std::string tryThis)
    : Error(66, std::move(what), std::move(where), std::move(tryThis)) {}

CannotCreateError::CannotCreateError(std::string what, std::string where, std::string tryThis)
    : Error(73, std::move(what), std::move(where), std::move(tryThis)) {}

Cancelled::Cancelled() : Error(130, "cancelled") {}

Error notEnoughMemory(std::string where) {
  return Error(kInternalError, "There is not enough memory", std::move(where),
               "close other programs, or use fewer handles or smaller organs");
}

bool reportsShortMemory(const std::exception& exception) noexcept {
  if (dynamic_cast<const std::bad_alloc*>(&exception) || dynamic_cast<const std::length_error*>(&exception))
    return true;
  const auto* ofSystem = dynamic_cast<const std::system_error*>(&exception);
  return ofSystem && (ofSystem->code() == std::errc::not_enough_memory ||
                      ofSystem->code() == std::errc::resource_unavailable_try_again);
}

std::string explanationOf(const std::exception& exception) {
  return reportsShortMemory(exception) ? notEnoughMemory().what() : exception.what();
}

} // namespace viscera
