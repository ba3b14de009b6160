#include "viscera/geometry/connected_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace viscera::geometry {
namespace {

TEST(ConnectedPieces, AreNumberedByTheirFirstVertexAndLeaveOutUnusedOnes) {
  TriangleMesh mesh;
  mesh.points = Points::Random(9, 3);
  mesh.triangles.resize(3, 3);
  mesh.triangles << 8, 1, 7, 2, 3, 4, 4, 3, 5;
  const ConnectedPieces pieces = connectedPieces(mesh);
  EXPECT_EQ(pieces.count, 2);
  EXPECT_THAT(pieces.ofVertex, testing::ElementsAre(-1, 0, 1, 1, 1, 1, -1, 0, 0));
}

TEST(ConnectedPieces, OfAnEmptyMeshAreNone) {
  EXPECT_EQ(connectedPieces({}).count, 0);
}

} // namespace
} // namespace viscera::geometry
