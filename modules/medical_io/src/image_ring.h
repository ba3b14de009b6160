#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "viscera/medical_io/cine_study.h"

namespace viscera::medical_io {

/// Keeps the pictures that were used last, within a number of bytes. For any thread.
class ImageRing {
public:
  using Picture = std::shared_ptr<const CineImage>;
  using Key = std::pair<std::size_t, std::size_t>; ///< Slice and phase.

  explicit ImageRing(std::size_t bytes) : most_(bytes) {}

  /// The picture, kept or decoded now; two threads may decode the same one at a time.
  Picture get(const Key& key, const std::function<CineImage()>& decode);
  /// Keeps a picture that was decoded along with another one; of several of one key the first stays.
  Picture keep(const Key& key, CineImage&& image);

private:
  struct Kept {
    Key key;
    Picture picture;
  };
  static std::size_t bytesOf(const CineImage& image) {
    return static_cast<std::size_t>(image.size()) * sizeof(float);
  }
  Picture find(const Key& key);

  std::mutex mutex_;
  std::list<Kept> kept_; ///< The last used first.
  std::map<Key, std::list<Kept>::iterator> places_;
  std::size_t most_ = 0, held_ = 0;
};

} // namespace viscera::medical_io
