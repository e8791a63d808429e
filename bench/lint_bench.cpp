// Linting large clean meshes: triangles per second by stage, peak memory, and the ratio to CGAL's detector of
// self-intersections on the same mesh in the same run. CPU seconds are of one thread; wall seconds of all.
#include <fmt/core.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <chrono>
#include <string>
#include <thread>

#include "bench/self_intersections.h"
#include "corpus/generate/models.h"
#include "validate/lint.h"

namespace {

using namespace rad;

struct Run {
  validate::LintResult result;
  double wall = 0;
  double cpu = 0;
};

Run timed_lint(const scene::Scene& scene, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const double cpu = bench::cpu_seconds();
  const auto start = std::chrono::steady_clock::now();
  Run run;
  run.result = validate::lint(scene, {}, {});
  run.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.cpu = bench::cpu_seconds() - cpu;
  return run;
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void print_stages(const validate::LintResult& result) {
  for (const auto& [stage, seconds] : result.timings) {
    if (seconds < 0.01) continue;
    fmt::print("    {:<12} {:6.3f} s  {:8.2f} Mtri/s\n", stage, seconds,
               1e-6 * static_cast<double>(result.figures.triangles) / seconds);
  }
}

void measure(const std::string& name, const scene::Scene& scene) {
  const Run one = timed_lint(scene, 1);
  const Run all = timed_lint(scene, std::thread::hardware_concurrency());
  const double peak = peak_mib();
  const auto yardstick = bench::cgal_self_intersections(scene);
  const auto triangles = static_cast<double>(one.result.figures.triangles);
  fmt::print("{}: {:.0f} triangles, {} findings, peak {:.0f} MiB (scene and lint)\n", name, triangles,
             one.result.findings.size(), peak);
  fmt::print("  lint, 1 thread   {:6.2f} CPU s  {:7.3f} Mtri/s\n", one.cpu, 1e-6 * triangles / one.cpu);
  fmt::print("  lint, {} threads  {:6.2f} s      {:7.3f} Mtri/s\n", std::thread::hardware_concurrency(), all.wall,
             1e-6 * triangles / all.wall);
  fmt::print("  CGAL self_intersections {:6.2f} CPU s, {} pairs; whole lint / CGAL = {:.2f}\n", yardstick.cpu_seconds,
             yardstick.pairs, one.cpu / yardstick.cpu_seconds);
  print_stages(one.result);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t triangles = argc > 1 ? std::stoul(argv[1]) : 1'000'000;
  measure("sphere", corpus::clean_sphere(triangles));
  std::size_t cells = 1;
  while (2 * (cells + 1) * (cells + 1) <= triangles) ++cells;
  measure("terrain", corpus::clean_terrain(cells));
  return 0;
}
