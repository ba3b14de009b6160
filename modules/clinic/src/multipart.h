#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace viscera::clinic {

/// Takes a `multipart/related` answer apart while it arrives, so that no image is in memory twice. For one
/// thread; O(n) in all.
class MultipartReader {
public:
  /// `begin` is called before each part, `bytes` with pieces of it, `end` behind it.
  struct Parts {
    std::function<void()> begin;
    std::function<void(std::string_view)> bytes;
    std::function<void()> end;
  };

  MultipartReader(const std::string& boundary, Parts parts);

  void add(std::string_view received);
  /// Whether the last boundary has come: else the answer is cut off.
  bool complete() const { return state_ == State::after; }

private:
  enum class State { before, headers, body, after };

  bool step();
  bool stepBody();
  bool afterBoundary(std::size_t at);

  std::string delimiter_; ///< "\r\n--boundary"
  Parts parts_;
  std::string held_;
  State state_ = State::before;
};

/// The boundary that a Content-Type states; empty without.
std::string boundaryOf(const std::string& contentType);

} // namespace viscera::clinic
