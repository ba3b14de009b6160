#include "cli/failure.h"

#include <algorithm>
#include <ostream>
#include <utility>

#include <nlohmann/json.hpp>

#include "viscera/core/text.h"

namespace viscera::app::cli {
namespace {

Failure plainFailure(const std::exception& exception) {
  if (const auto* known = dynamic_cast<const Error*>(&exception))
    return {known->problem().english(), known->where().english(), known->tryThis().english(), known->what(),
            known->exitCode()};
  if (reportsShortMemory(exception))
    return plainFailure(notEnoughMemory());
  const std::string problem = std::string("internal error: ") + exception.what();
  return {problem, {}, "report it with what led to it", problem, kInternalError};
}

} // namespace

Failure failureOf(const std::exception& exception, const std::function<std::string(std::string)>& told) {
  Failure failure = plainFailure(exception);
  if (told)
    for (std::string* text : {&failure.what, &failure.where, &failure.tryThis, &failure.line})
      *text = told(*text);
  return failure;
}

int printFailure(const Failure& failure, bool json, std::ostream& out, std::ostream& err) {
  if (json) {
    const nlohmann::ordered_json object = {
        {"error", {{"what", failure.what}, {"where", failure.where}, {"try", failure.tryThis}}},
        {"exitCode", failure.exitCode}};
    out << object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  }
  err << "viscera: " << oneLine(failure.line) << std::endl;
  return failure.exitCode;
}

std::string oneLine(std::string text) {
  text = withoutControls(std::move(text));
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::erase(text, '\r');
  while (!text.empty() && text.back() == ' ')
    text.pop_back();
  return text;
}

} // namespace viscera::app::cli
