// Repairing files: CPU seconds of each stage on one thread, peak memory, and the ratio to CGAL's detector of
// self-intersections on the same mesh in the same run.
#include <fmt/core.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <string>

#include "bench/self_intersections.h"
#include "readers/reader.h"
#include "repair/repair.h"

namespace {

using namespace rad;

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void measure(const std::string& path) {
  const readers::ReadResult input = readers::read_file(path);
  const auto yardstick = bench::cgal_self_intersections(input.scene);
  const double before = bench::cpu_seconds();
  repair::RepairOptions options;
  const repair::Repaired repaired = repair::repair(input.scene, input.issues, options);
  const double whole = bench::cpu_seconds() - before;
  double stages = 0;
  fmt::print("{}: {} faces, {} intersecting pairs\n", std::filesystem::path(path).filename().string(),
             input.scene.faces.size(), yardstick.pairs);
  for (const auto& [stage, seconds] : repaired.timings) {
    fmt::print("  {:<10} {:8.3f} s\n", stage, seconds);
    if (stage != "orient") stages += seconds;
  }
  fmt::print("  CGAL self_intersections {:.3f} s; grouper, isect and coplanar {:.3f} s = {:.1f} times; with the checks "
             "before and after {:.3f} s\n",
             yardstick.cpu_seconds, stages, stages / yardstick.cpu_seconds, whole);
  fmt::print("  {} triangles, {} violations left, peak {:.0f} MiB\n", repaired.model.triangles.size(),
             repaired.unresolved, peak_mib());
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (int i = 1; i < argc; ++i) measure(argv[i]);
  return 0;
}
