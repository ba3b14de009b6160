#include "image_ring.h"

namespace viscera::medical_io {

ImageRing::Picture ImageRing::find(const Key& key) {
  const auto place = places_.find(key);
  if (place == places_.end())
    return nullptr;
  kept_.splice(kept_.begin(), kept_, place->second);
  return kept_.front().picture;
}

ImageRing::Picture ImageRing::get(const Key& key, const std::function<CineImage()>& decode) {
  {
    const std::lock_guard lock(mutex_);
    if (Picture picture = find(key))
      return picture;
  }
  return keep(key, decode());
}

ImageRing::Picture ImageRing::keep(const Key& key, CineImage&& image) {
  const auto made = std::make_shared<const CineImage>(std::move(image));
  const std::lock_guard lock(mutex_);
  if (Picture picture = find(key))
    return picture;
  kept_.push_front({key, made});
  places_[key] = kept_.begin();
  held_ += bytesOf(*made);
  while (held_ > most_ && kept_.size() > 1) {
    held_ -= bytesOf(*kept_.back().picture);
    places_.erase(kept_.back().key);
    kept_.pop_back();
  }
  return made;
}

} // namespace viscera::medical_io
