// A program of its own, so that TetGen's crashes, loops and licence (AGPL-3.0) stay in it. It reads one
// surface, meshes it, writes the tetrahedra and ends; see tetgen_exchange.h.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <sys/prctl.h>
#include <unistd.h>

#include <tetgen.h>

#include "tetgen_exchange.h"

namespace {

using namespace viscera::deformation::tetgen_exchange;

/// More than any surface that fits into the machine; a request beyond is not a request.
constexpr std::uint64_t kMostItems = std::uint64_t{1} << 30;

/// Calls `move` (`read` or `write`) until all bytes have gone through the file.
template <class Move, class Byte>
bool moveAll(const Move& move, int file, Byte* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t moved = move(file, bytes, size);
    if (moved < 0 && errno == EINTR)
      continue;
    if (moved <= 0)
      return false;
    bytes += moved;
    size -= static_cast<std::size_t>(moved);
  }
  return true;
}

bool readAll(void* data, std::size_t size) {
  return moveAll(read, STDIN_FILENO, static_cast<char*>(data), size);
}

bool writeAll(int file, const void* data, std::size_t size) {
  return moveAll(write, file, static_cast<const char*>(data), size);
}

/// Hands the surface over in TetGen's own structures, which free what they hold.
void fill(tetgenio& in, const std::vector<double>& points, const std::vector<std::int32_t>& triangles) {
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(points.size() / 3);
  in.pointlist = new REAL[points.size()];
  std::memcpy(in.pointlist, points.data(), points.size() * sizeof(double));
  in.numberoffacets = static_cast<int>(triangles.size() / 3);
  in.facetlist = new tetgenio::facet[static_cast<std::size_t>(in.numberoffacets)];
  for (int f = 0; f < in.numberoffacets; ++f) {
    tetgenio::facet& facet = in.facetlist[f];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::polygon& polygon = facet.polygonlist[0];
    tetgenio::init(&polygon);
    polygon.numberofvertices = 3;
    polygon.vertexlist = new int[3];
    for (int k = 0; k < 3; ++k)
      polygon.vertexlist[k] = triangles[static_cast<std::size_t>(3 * f + k)];
  }
}

/// p: a surface; Y: its triangles stay as they are; q: quality; a: largest volume; Q: say nothing.
std::string switchesFor(const Request& request) {
  std::string switches = "pY";
  char number[40];
  if (request.radiusEdgeRatio > 0) {
    std::snprintf(number, sizeof number, "q%.9g", request.radiusEdgeRatio);
    switches += number;
  }
  if (request.maxVolume > 0) {
    std::snprintf(number, sizeof number, "a%.9g", request.maxVolume);
    switches += number;
  }
  return switches + "Q";
}

int mesh(int output) {
  Request request;
  if (!readAll(&request, sizeof request) || request.magic != kMagic || request.points > kMostItems ||
      request.triangles > kMostItems) {
    std::fputs("this is not a request for tetrahedra\n", stderr);
    return kBadRequest;
  }
  std::vector<double> points(3 * request.points);
  std::vector<std::int32_t> triangles(3 * request.triangles);
  if (!readAll(points.data(), points.size() * sizeof(double)) ||
      !readAll(triangles.data(), triangles.size() * sizeof(std::int32_t))) {
    std::fputs("the request for tetrahedra is cut short\n", stderr);
    return kBadRequest;
  }
  tetgenio in, out;
  fill(in, points, triangles);
  std::string switches = switchesFor(request);
  tetrahedralize(switches.data(), &in, &out);
  Reply reply;
  reply.points = static_cast<std::uint64_t>(out.numberofpoints);
  reply.tetrahedra = static_cast<std::uint64_t>(out.numberoftetrahedra);
  static_assert(sizeof(int) == sizeof(std::int32_t) && sizeof(REAL) == sizeof(double));
  const bool written = writeAll(output, &reply, sizeof reply) &&
                       writeAll(output, out.pointlist, 3 * reply.points * sizeof(REAL)) &&
                       writeAll(output, out.tetrahedronlist, 4 * reply.tetrahedra * sizeof(int));
  return written ? kDone : kBadRequest;
}

} // namespace

int main() {
  prctl(PR_SET_PDEATHSIG, SIGKILL); // Ends with the program that waits for the result.
  // TetGen talks on standard output, which is for the reply.
  const int output = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  std::setvbuf(stdout, nullptr, _IONBF, 0); // Unbuffered, so that messages before a crash are not lost.
  try {
    return mesh(output);
  } catch (const std::bad_alloc&) {
    std::fputs("out of memory\n", stderr);
    return kOutOfMemory;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kRefused;
  } catch (int code) { // TetGen's way to give up; 1 is its lack of memory.
    return code == 1 ? kOutOfMemory : kRefused;
  }
}
