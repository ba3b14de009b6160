#include "viscera/core/error.h"

#include <utility>

namespace viscera {
namespace {

std::string joined(const std::string& what, const std::string& where, const std::string& tryThis) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!tryThis.empty())
    text += " (" + tryThis + ")";
  return text;
}

} // namespace

Error::Error(int exitCode, std::string what, std::string where, std::string tryThis)
    : std::runtime_error(joined(what, where, tryThis)), problem_(std::move(what)), where_(std::move(where)),
      tryThis_(std::move(tryThis)), exitCode_(exitCode) {}

UsageError::UsageError(std::string what, std::string where, std::string tryThis)
    : Error(64, std::move(what), std::move(where), std::move(tryThis)) {}

DataError::DataError(std::string what, std::string where, std::string tryThis)
    : Error(65, std::move(what), std::move(where), std::move(tryThis)) {}

NoInputError::NoInputError(std::string what, std::string where, std::string tryThis)
    : Error(66, std::move(what), std::move(where), std::move(tryThis)) {}

CannotCreateError::CannotCreateError(std::string what, std::string where, std::string tryThis)
    : Error(73, std::move(what), std::move(where), std::move(tryThis)) {}

Cancelled::Cancelled() : Error(130, "cancelled") {}

} // namespace viscera
