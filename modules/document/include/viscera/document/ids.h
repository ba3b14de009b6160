#pragma once

#include <compare>
#include <cstdint>

namespace viscera::document {

/// An identifier of an organ, handle, group or other item of a document; never given twice while the program
/// runs, not even after an undo. 0 names nothing.
template <class Tag>
struct Id {
  std::int64_t value = 0;
  explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const Id&, const Id&) = default;
};

using OrganId = Id<struct OrganTag>;
using HandleId = Id<struct HandleTag>;
using GroupId = Id<struct GroupTag>;
using KeyId = Id<struct KeyTag>;
using MeasurementId = Id<struct MeasurementTag>;
using StressProbeId = Id<struct StressProbeTag>;
using StressLineId = Id<struct StressLineTag>;

/// Generates the ids of one document, in ascending order.
class IdSource {
public:
  template <class AnyId>
  AnyId next() {
    return AnyId{++last_};
  }

  /// Never hands out `id` any more: it came with a document that was loaded.
  template <class AnyId>
  void reserve(AnyId id) {
    if (id.value > last_)
      last_ = id.value;
  }

private:
  std::int64_t last_ = 0;
};

} // namespace viscera::document
