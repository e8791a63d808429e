// Repairing files: CPU seconds of each stage on one thread, peak memory, and the ratio to CGAL's detector of
// self-intersections on the same mesh in the same run.
#include <fmt/core.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <map>
#include <string>

#include "bench/repair_steps.h"
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

void measure_steps(const scene::Scene& scene) {
  const bench::StepTimes times = bench::time_steps(scene);
  const auto millions = [](std::size_t count, double seconds) { return 1e-6 * static_cast<double>(count) / seconds; };
  fmt::print(
      "  alone: weld {} corners {:.3f} s = {:.2f} million/s; insert T-vertices, {} triangles, {} splits {:.3f} s = ",
      times.corners, times.weld, millions(times.corners, times.weld), times.triangles, times.splits, times.insert);
  fmt::print("{:.2f} million/s\n", millions(times.triangles, times.insert));
}

void measure(const std::string& path, bool verbose) {
  const readers::ReadResult input = readers::read_file(path);
  const auto yardstick = bench::cgal_self_intersections(input.scene);
  const double before = bench::cpu_seconds();
  repair::RepairOptions options;
  std::map<std::string, int> rounds;
  options.progress = [&](const char* step, std::size_t left) {
    ++rounds[step];
    if (verbose) fmt::print("    {:7.2f} s  {} {}\n", bench::cpu_seconds() - before, step, left);
    return true;
  };
  const repair::Repaired repaired = repair::repair(input.scene, input.issues, options);
  const double whole = bench::cpu_seconds() - before;
  double stages = 0;
  fmt::print("{}: {} faces, {} intersecting pairs\n", std::filesystem::path(path).filename().string(),
             input.scene.faces.size(), yardstick.pairs);
  for (const auto& [stage, seconds] : repaired.cpu_timings) {
    fmt::print("  {:<10} {:8.3f} s\n", stage, seconds);
    if (stage != "orient") stages += seconds;
  }
  fmt::print(
      "  CGAL self_intersections {:.3f} s; grouper, isect and coplanar {:.3f} s = {:.1f} times; with the checks "
      "before and after {:.3f} s\n",
      yardstick.cpu_seconds, stages, stages / yardstick.cpu_seconds, whole);
  for (const auto& [step, count] : rounds) fmt::print("  {} times {}\n", count, step);
  fmt::print("  {} triangles, {} violations left, peak {:.0f} MiB\n", repaired.model.triangles.size(),
             repaired.unresolved, peak_mib());
  measure_steps(input.scene);
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const bool verbose = argc > 1 && std::string(argv[1]) == "-v";
  for (int i = verbose ? 2 : 1; i < argc; ++i) measure(argv[i], verbose);
  return 0;
}
