#include "bake/light_map.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "bake/png.h"
#include "bake/srgb_codes.h"

namespace rad::bake {
namespace {

using scene::LightMapLook;
using scene::Material;

dvec3 exitance(const Material& material) {
  return material.emission_unit == Material::EmissionUnit::Luminance ? std::numbers::pi * material.emission
                                                                     : material.emission;
}

// Texels are floats: the largest value may have been rounded up.
constexpr double kRounded = 1 + 1e-6;

double largest(const dvec3& colour) { return std::max({colour.x, colour.y, colour.z}); }

/// Calls `row` with the first texel of the chart in each of its rows, an index of the page, and their number.
template <typename Row>
void for_rows(const ChartPlace& place, std::uint32_t page_width, Row&& row) {
  for (std::uint32_t y = place.y; y < place.y + place.rows; ++y) {
    row(std::size_t{y} * page_width + place.x, std::size_t{place.columns});
  }
}

}  // namespace

LightMapBaker::LightMapBaker(const Atlas& atlas, const mesh::RadiosityMesh& mesh, std::span<const Material> materials,
                             const mesh::RadiosityField& field, LightMapOptions options)
    : atlas_(atlas), mesh_(mesh), field_(field), options_(std::move(options)), transfer_(materials.size()) {
  if (options_.stored == StoredQuantity::Irradiance) {
    for (std::size_t id = 0; id < materials.size(); ++id) {
      transfer_[id].from = exitance(materials[id]);
      for (int channel = 0; channel < 3; ++channel) {
        const double reflectance = materials[id].reflectance[channel];
        transfer_[id].factor[channel] = reflectance > 0 ? 1 / reflectance : 0;
      }
    }
  }
  choose_white();
  choose_precision();
}

scene::MaterialId LightMapBaker::material_of(std::uint32_t chart) const {
  return mesh_.patches[atlas_.charts[chart].patches.front()].material;
}

std::vector<double> LightMapBaker::brightest_of_charts() const {
  std::vector<double> brightest(atlas_.charts.size(), 0);
  for (const mesh::Element& element : mesh_.elements) {
    double& most = brightest[atlas_.chart_of_patch[element.patch]];
    for (const mesh::NodeId node : element.corners.all()) most = std::max(most, largest(field_.radiosity[node]));
  }
  return brightest;
}

void LightMapBaker::choose_white() {
  white_.assign(atlas_.charts.size(), 1 / options_.exposure);
  if (options_.look == LightMapLook::Unlit) return;
  const std::vector<double> brightest = brightest_of_charts();
  std::vector<double> of_material(transfer_.size(), 0);
  for (std::uint32_t chart = 0; chart < white_.size(); ++chart) {
    double& most = of_material[material_of(chart)];
    most = std::max(most, brightest[chart]);
  }
  for (std::uint32_t chart = 0; chart < white_.size(); ++chart) {
    double white = of_material[material_of(chart)];
    if (white <= 0) continue;
    for (int step = 1; step < kWhites && brightest[chart] <= white / kWhiteStep; ++step) white /= kWhiteStep;
    white_[chart] = white;
  }
}

void LightMapBaker::choose_precision() {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const mesh::Element& element : mesh_.elements) {
    const Transfer& transfer = transfer_[mesh_.patches[element.patch].material];
    for (const mesh::NodeId node : element.corners.all()) {
      const dvec3 value = transfer.stored(field_.radiosity[node]);
      for (int channel = 0; channel < 3; ++channel) {
        if (value[channel] > 0) least = std::min(least, value[channel]);
        most = std::max(most, value[channel]);
      }
    }
  }
  precision_ = precision_for(least, most);
}

BakedPage LightMapBaker::bake(std::uint32_t index) const {
  const LightPage page = paint_page(atlas_, index, mesh_, field_);
  BakedPage baked;
  add_areas(page, index, baked);
  tbb::parallel_invoke([&] { baked.exr = exr_page(page, index); }, [&] { baked.png = png_page(page, index); });
  return baked;
}

std::string LightMapBaker::exr_page(const LightPage& page, std::uint32_t index) const {
  const bool exitance_is_stored = options_.stored == StoredQuantity::Exitance;
  std::vector<float> changed;
  if (!exitance_is_stored) {
    changed = page.radiosity;
    for (std::uint32_t chart = 0; chart < atlas_.charts.size(); ++chart) {
      if (atlas_.places[chart].page != index) continue;
      const Transfer& transfer = transfer_[material_of(chart)];
      for_rows(atlas_.places[chart], page.width, [&](std::size_t first, std::size_t count) {
        for (float* texel = &changed[3 * first]; texel < &changed[3 * first] + 3 * count; texel += 3) {
          const dvec3 value = transfer.stored({texel[0], texel[1], texel[2]});
          for (int channel = 0; channel < 3; ++channel)
            texel[channel] = static_cast<float>(std::max(0.0, value[channel]));
        }
      });
    }
  }
  ExrHeader header;
  header.quantity = exitance_is_stored ? "radiant exitance" : "irradiance";
  header.units = "W/m2";
  header.software = options_.software;
  header.comments = "light map: page " + std::to_string(index) + "; rows run from the top, texture coordinate 1";
  // A diffuse surface of radiosity 1 has the radiance 1 / π; the project takes watts for lumens throughout.
  if (exitance_is_stored) header.white_luminance = std::numbers::inv_pi;
  return exr_bytes({page.width, page.height, exitance_is_stored ? page.radiosity : changed, page.coverage, precision_},
                   header);
}

std::string LightMapBaker::png_page(const LightPage& page, std::uint32_t index) const {
  const SrgbCodes codes;
  std::vector<std::uint8_t> shown(page.radiosity.size(), 0);
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(atlas_.charts.size()), [&](std::uint32_t chart) {
    if (atlas_.places[chart].page != index) return;
    const auto scale = static_cast<float>(1 / white_[chart]);
    for_rows(atlas_.places[chart], page.width, [&](std::size_t first, std::size_t count) {
      if (options_.curve == scene::DisplayCurve::Linear) {
        for (std::size_t i = 3 * first; i < 3 * (first + count); ++i) shown[i] = codes.of(scale * page.radiosity[i]);
        return;
      }
      for (std::size_t i = 3 * first; i < 3 * (first + count); i += 3) {
        const dvec3 exposed(scale * page.radiosity[i], scale * page.radiosity[i + 1], scale * page.radiosity[i + 2]);
        const dvec3 colour = scene::curved(options_.curve, exposed);
        for (int channel = 0; channel < 3; ++channel) {
          shown[i + static_cast<std::size_t>(channel)] = codes.of(static_cast<float>(colour[channel]));
        }
      }
    });
  });
  return png_bytes(page.width, shown);
}

void LightMapBaker::add_areas(const LightPage& page, std::uint32_t index, BakedPage& baked) const {
  for (std::uint32_t chart = 0; chart < atlas_.charts.size(); ++chart) {
    const ChartPlace& place = atlas_.places[chart];
    if (place.page != index) continue;
    const double white = white_[chart];
    double all = 0, clamped = 0;
    for_rows(place, page.width, [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) {
        const float* texel = &page.radiosity[3 * i];
        const double share = page.coverage[i];
        all += share;
        if (std::max({texel[0], texel[1], texel[2]}) > white * kRounded) clamped += share;
      }
    });
    baked.area += all * place.texel.x * place.texel.y;
    baked.clamped_area += clamped * place.texel.x * place.texel.y;
  }
}

scene::LightMap light_map_places(const Atlas& atlas, const mesh::DisplayMesh& display, const geom::Lattice& lattice,
                                 std::span<const double> white) {
  scene::LightMap map;
  map.page_of_face.reserve(display.faces.size());
  map.white_luminance.reserve(display.faces.size());
  for (const mesh::DisplayFace& face : display.faces) {
    const std::uint32_t chart = atlas.chart_of_patch[face.patch];
    map.page_of_face.push_back(atlas.places[chart].page);
    map.white_luminance.push_back(white[chart] / std::numbers::pi);
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const dvec3 position = lattice.position(display.vertices[face.corner[i]].point);
      map.coordinates.push_back(atlas.page_coordinates(chart, position));
    }
  }
  return map;
}

}  // namespace rad::bake
