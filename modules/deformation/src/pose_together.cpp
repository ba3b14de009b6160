#include "viscera/deformation/pose_together.h"

#include "viscera/geometry/volume.h"

namespace viscera::deformation {

void poseTogether(const std::vector<NewPose>& poses, Threads threads) {
  for (const NewPose& wanted : poses)
    wanted.deformer->requirePose(*wanted.pose);
  std::vector<PiecesOfWork> works;
  for (const NewPose& wanted : poses)
    works.push_back(wanted.moved.empty() ? wanted.deformer->poseInPieces(wanted.pose)
                                         : wanted.deformer->moveInPieces(wanted.pose, wanted.moved));
  parallelPieces(works, threads);
}

std::vector<double> volumesTogether(const std::vector<Deformer*>& deformers, Threads threads) {
  std::vector<geometry::VolumeSum> sums;
  std::vector<Deformer*> measured;
  sums.reserve(deformers.size()); // They must stay where they are.
  std::vector<PiecesOfWork> works;
  for (Deformer* deformer : deformers)
    if (!deformer->volumeValid_) {
      measured.push_back(deformer);
      works.push_back(sums.emplace_back(deformer->points_, deformer->rest_->triangles).pieces());
    }
  parallelPieces(works, threads);
  for (std::size_t k = 0; k < measured.size(); ++k) {
    measured[k]->volume_ = sums[k].volume();
    measured[k]->volumeValid_ = true;
  }
  std::vector<double> volumes;
  for (Deformer* deformer : deformers)
    volumes.push_back(deformer->volume_);
  return volumes;
}

} // namespace viscera::deformation
