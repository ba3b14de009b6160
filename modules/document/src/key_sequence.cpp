#include "viscera/document/key_sequence.h"

#include <algorithm>
#include <set>

namespace viscera::document {

const SequenceKey* KeySequence::key(KeyId id) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [id](const SequenceKey& one) { return one.id == id; });
  return found == keys.end() ? nullptr : &*found;
}

Points poseOf(const SequenceKey& key, const Rig& rig) {
  Points pose = rig.restPositions();
  for (std::size_t i = 0; i < rig.handles.size(); ++i)
    if (const auto moved = key.displacements.find(rig.handles[i].id); moved != key.displacements.end())
      pose.row(static_cast<Eigen::Index>(i)) += moved->second.transpose();
  return pose;
}

std::shared_ptr<const sequences::KeyframedSequence> sequenceOf(const KeySequence& keySequence,
                                                               const Rig& rig) {
  if (keySequence.keys.empty() || rig.handles.empty())
    return nullptr;
  sequences::KeyframedSequence::Track track;
  track.name = keySequence.name;
  track.restHandles = rig.restPositions();
  track.periodSeconds = keySequence.periodSeconds;
  track.loop = keySequence.loop;
  track.interpolation = keySequence.interpolation;
  for (const SequenceKey& key : keySequence.keys)
    track.keys.push_back({key.seconds, poseOf(key, rig), key.easing});
  std::set<int> grouped;
  for (const Group& group : rig.groups) {
    sequences::HandleGroup rows{group.name, group.color, {}};
    for (const HandleId id : group.handles)
      if (const int row = rig.indexOf(id); grouped.insert(row).second)
        rows.handles.push_back(row);
    if (!rows.handles.empty())
      track.groups.push_back(std::move(rows));
  }
  return std::make_shared<sequences::KeyframedSequence>(std::move(track));
}

} // namespace viscera::document
