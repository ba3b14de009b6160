#include "multipart.h"

#include <algorithm>
#include <utility>

namespace viscera::clinic {

MultipartReader::MultipartReader(const std::string& boundary, Parts parts)
    : delimiter_("\r\n--" + boundary), parts_(std::move(parts)), held_("\r\n") {}

void MultipartReader::add(std::string_view received) {
  held_ += received;
  while (step()) {
  }
}

/// Whether there may be more to do with what has come.
bool MultipartReader::step() {
  if (state_ == State::after) {
    held_.clear();
    return false;
  }
  if (state_ == State::body)
    return stepBody();
  const bool before = state_ == State::before;
  const std::size_t at = held_.find(before ? delimiter_ : "\r\n\r\n");
  if (at == std::string::npos)
    return false;
  if (before)
    return afterBoundary(at);
  held_.erase(0, at + 4);
  state_ = State::body;
  parts_.begin();
  return true;
}

bool MultipartReader::stepBody() {
  const std::size_t at = held_.find(delimiter_);
  if (at != std::string::npos && held_.size() < at + delimiter_.size() + 2)
    return false; // Whether it is the last one is not known yet.
  if (at != std::string::npos) {
    parts_.bytes(std::string_view(held_).substr(0, at));
    parts_.end();
    return afterBoundary(at);
  }
  // The end of what has come may be the beginning of a boundary.
  const std::size_t sure = held_.size() - std::min(held_.size(), delimiter_.size());
  parts_.bytes(std::string_view(held_).substr(0, sure));
  held_.erase(0, sure);
  return false;
}

bool MultipartReader::afterBoundary(std::size_t at) {
  const std::size_t end = at + delimiter_.size();
  if (held_.size() < end + 2)
    return false;
  state_ = held_.compare(end, 2, "--") == 0 ? State::after : State::headers;
  held_.erase(0, end); // The line break behind it begins the headers, which may be none.
  return true;
}

std::string boundaryOf(const std::string& contentType) {
  constexpr std::string_view key = "boundary=";
  std::size_t at = contentType.find(key);
  if (at == std::string::npos)
    return {};
  at += key.size();
  if (at < contentType.size() && contentType[at] == '"')
    return contentType.substr(at + 1, contentType.find('"', at + 1) - at - 1);
  return contentType.substr(at, contentType.find_first_of("; \r\n", at) - at);
}

} // namespace viscera::clinic
