// What the page shows of a model: its triangles, pictures, and a view of every fault. Made while the scene is at hand.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bake/camera.h"
#include "report/html/packed_geometry.h"
#include "report/report.h"

namespace rad::report::html {

/// Triangles that a page holds of one model; of a larger one those at fault come first, then the largest.
inline constexpr std::size_t kShownTriangles = 400'000;
/// Pictures of faults of one model: of the first finding of each rule, the most severe first.
inline constexpr std::size_t kFaultPictures = 10;

/// Sizes of pictures, pixels, and width over height.
inline constexpr std::uint32_t kOverviewWidth = 720, kOverviewHeight = 450;
inline constexpr std::uint32_t kFaultWidth = 336, kFaultHeight = 224;
inline constexpr double kOverviewAspect = static_cast<double>(kOverviewWidth) / kOverviewHeight;
inline constexpr double kFaultAspect = static_cast<double>(kFaultWidth) / kFaultHeight;

struct Picture {
  std::string png;  ///< empty for none
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

/// A finding as it is listed.
struct FaultView {
  std::optional<bake::Camera> camera;                          ///< nothing for a fault without a place
  std::vector<std::pair<std::size_t, std::size_t>> triangles;  ///< of its faces: first and count, ascending
  Picture picture;
};

struct ModelView {
  geom::dvec3 up{0, 0, 1};
  bake::Camera camera;
  PackedGeometry geometry;
  std::size_t triangles = 0;  ///< that are shown
  std::size_t left_out = 0;
  Picture overview;
  std::vector<FaultView> faults;  ///< of listed_findings(), in their order
};

/// Bytes of geometry and pictures.
std::size_t size_of(const ModelView& view);

/// `input` is the judgement of `scene`. Nothing where there is no triangle to show.
std::optional<ModelView> model_view(const scene::Scene& scene, const InputReport& input, std::size_t max_issues);

}  // namespace rad::report::html
