#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera {
namespace {

sample_organs::SampleLibrary libraryWithoutCache() {
  return {std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs", {}};
}

void generate(benchmark::State& state, const std::string& organ, sample_organs::Resolution resolution) {
  Eigen::Index triangles = 0;
  for (auto _ : state) {
    Progress progress;
    triangles = 0;
    for (const auto& surface :
         sample_organs::sampleOrgan(libraryWithoutCache(), organ, resolution, progress).surfaces)
      triangles += surface.mesh->triangles.rows();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

/// What a user waits for when the cache is empty and every organ is asked for.
void generateAllMedium(benchmark::State& state) {
  for (auto _ : state)
    for (const std::string& organ : sample_organs::sampleNames(libraryWithoutCache())) {
      Progress progress;
      sample_organs::sampleOrgan(libraryWithoutCache(), organ, sample_organs::Resolution::medium, progress);
    }
}

void evaluate(benchmark::State& state, const std::string& organ, const std::string& node) {
  const sample_organs::ImplicitSurface surface =
      sample_organs::implicitSurface(libraryWithoutCache(), organ, node);
  double sum = 0, x = 0;
  for (auto _ : state) {
    x = x < 60 ? x + 0.37 : -60;
    sum += surface({x, 0.3 * x, -20 + 0.1 * x});
  }
  benchmark::DoNotOptimize(sum);
}

} // namespace

BENCHMARK(generateAllMedium)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(generate, heart_medium, "heart", sample_organs::Resolution::medium)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(generate, heart_high, "heart", sample_organs::Resolution::high)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(generate, stomach_medium, "stomach", sample_organs::Resolution::medium)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(generate, stomach_and_bowel_medium, "stomach_and_bowel", sample_organs::Resolution::medium)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(evaluate, heart_outer, "heart", "surf outer");
BENCHMARK_CAPTURE(evaluate, stomach_and_bowel_outer, "stomach_and_bowel", "surf outer");

} // namespace viscera
