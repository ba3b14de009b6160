#include "viscera/document/document.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/study_item.h"

namespace viscera::document {
namespace {

template <class Array>
bool sameBits(const Array& a, const Array& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols())
    return false;
  const auto bytes = static_cast<std::size_t>(a.size()) * sizeof(typename Array::Scalar);
  return bytes == 0 || std::memcmp(a.data(), b.data(), bytes) == 0;
}

bool identical(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  return &a == &b ||
         (sameBits(a.points, b.points) && sameBits(a.triangles, b.triangles) && sameBits(a.colors, b.colors));
}

bool identical(const Organ& a, const Organ& b) {
  return &a == &b ||
         (a.id == b.id && a.name == b.name && a.look == b.look && a.parent == b.parent && a.file == b.file &&
          a.origin == b.origin && a.warnings == b.warnings && a.boundaryEdges == b.boundaryEdges &&
          a.restVolumeMm3 == b.restVolumeMm3 && a.volumeLocked == b.volumeLocked &&
          a.mobility == b.mobility && identical(*a.mesh, *b.mesh));
}

bool identical(const OrganList& a, const OrganList& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return identical(*x, *y); });
}

} // namespace

DocumentState::DocumentState()
    : organs(std::make_shared<const OrganList>()), rig(std::make_shared<const Rig>()),
      pose(std::make_shared<const Points>(0, 3)), system(std::make_shared<const SystemChoice>()),
      keySequence(std::make_shared<const KeySequence>()),
      measurements(std::make_shared<const MeasurementList>()),
      stressMarks(std::make_shared<const StressMarks>()),
      circulation(std::make_shared<const CirculationChoice>()) {}

std::shared_ptr<const Organ> DocumentState::organ(OrganId id) const {
  const auto found =
      std::find_if(organs->begin(), organs->end(), [id](const auto& item) { return item->id == id; });
  return found == organs->end() ? nullptr : *found;
}

bool identical(const DocumentState& a, const DocumentState& b) {
  if (a == b)
    return true;
  return identical(*a.organs, *b.organs) && *a.rig == *b.rig &&
         sameBits(a.rig->restPositions(), b.rig->restPositions()) && sameBits(*a.pose, *b.pose) &&
         a.system->id == b.system->id && a.system->parameters.all() == b.system->parameters.all() &&
         *a.keySequence == *b.keySequence && *a.measurements == *b.measurements &&
         *a.stressMarks == *b.stressMarks && *a.circulation == *b.circulation && identical(a.scan, b.scan) &&
         identical(a.study, b.study);
}

bool atRest(const DocumentState& state) {
  return *state.pose == state.rig->restPositions();
}

void Document::announce(std::function<void()> news) {
  if (changing_)
    news_.push_back(std::move(news));
  else
    news();
}

void Document::requireNoChangeUnderWay() const {
  if (changing_)
    throw std::logic_error("an observer changes the document that it is told about");
}

void Document::replace(DocumentState state, bool interactive, std::function<void()> news) {
  requireNoChangeUnderWay();
  const Change change{std::exchange(state_, state), std::move(state), interactive};
  FirstException exception;
  changing_ = true;
  exception.watch([&] { derived_.emit(change); });
  exception.watch([&] { changed_.emit(change); });
  for (announce(std::move(news)); !news_.empty();) {
    const auto telling = std::move(news_.front());
    news_.pop_front();
    exception.watch(telling);
  }
  changing_ = false;
  exception.rethrow();
}

} // namespace viscera::document
