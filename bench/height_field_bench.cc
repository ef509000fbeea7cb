#include <benchmark/benchmark.h>
#include <gable/grammar/height_field.h>

namespace gable {
namespace {

// One million point samples of a default L house.
void BM_HeightField(benchmark::State& state) {
  const HeightField field(make_house(Foundation::kL));
  for (auto _ : state) {
    double sum = 0.0;
    for (int i = 0; i < 1000000; ++i) {
      sum += field.at_local({1e-5 * i, 1e-5 * i}, 0.5, 0.0);
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(BM_HeightField)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gable
