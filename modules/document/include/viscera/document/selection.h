#pragma once

#include <vector>

#include "viscera/document/document.h"

namespace viscera::document {

/// The selected organ and handles of a document. It is not a part of the document: selecting is not an undo
/// step and is not saved. Items that are removed from the document are removed from the selection before
/// observers of the document are called. The selected organ is selected again when undo brings it back,
/// unless another one is selected then. For the document's thread.
class Selection {
public:
  explicit Selection(Document& document);

  /// Selected handles in the order in which they were selected; the last one is the current one.
  const std::vector<HandleId>& handles() const { return handles_; }
  bool contains(HandleId handle) const;
  /// The last handle that was selected, or none.
  HandleId currentHandle() const { return handles_.empty() ? HandleId{} : handles_.back(); }
  /// The selected organ, or none.
  OrganId organ() const { return organ_; }
  /// The selected group, or none: handles that are added go into it.
  GroupId group() const { return group_; }

  /// Each replaces what was selected of its kind; ids that the document does not have are left out.
  void setHandles(const std::vector<HandleId>& handles);
  void toggle(HandleId handle);
  void setOrgan(OrganId organ);
  void setGroup(GroupId group);
  void clear();

  /// Calls `observer` after every change.
  [[nodiscard]] Subscription onChange(std::function<void()> observer) {
    return changed_.connect(std::move(observer));
  }

private:
  void drop();
  bool followOrgan();

  Document& document_;
  std::vector<HandleId> handles_;
  OrganId organ_;
  std::vector<OrganId> removed_; ///< Selected organs that left the document, the latest last.
  GroupId group_;
  Signal<> changed_;
  Subscription subscription_;
};

} // namespace viscera::document
