#include "cli/light_map_stage.h"

#include <fmt/format.h>

#include <numbers>

#include "bake/light_map.h"
#include "report/atlas_json.h"
#include "writers/registry.h"

namespace rad::cli {
namespace {

namespace fs = std::filesystem;

// Texels along the shortest edges that elements are divided to.
constexpr double kTexelsOfElement = 4;

// "out" of out.glb and of out.draco.glb.
fs::path stem_of(const std::string& output) {
  const fs::path path(output);
  fs::path stem = path.stem();
  if (stem.extension() == ".draco") stem = stem.stem();
  return path.parent_path() / stem;
}

fs::path page_path(const std::string& output, std::size_t page, const char* extension) {
  fs::path path = stem_of(output);
  path += fmt::format(".light-{}.{}", page, extension);
  return path;
}

// A dry run may have no output.
bool embeds_images(const std::string& output) {
  const writers::Writer* const writer = writers::writer_for(output);
  return writer == nullptr || writer->name != "glTF";
}

class Baking {
 public:
  Baking(const FixCommand& command, const SolvedMesh& solved, const std::function<void(const std::string&)>& progress)
      : command_(command), solved_(solved), progress_(progress) {
    options_.look = command.bake == BakeMode::Emissive ? scene::LightMapLook::Emissive : scene::LightMapLook::Unlit;
    options_.stored = command.stored;
    options_.exposure = solved.exposure;
    options_.curve = command.curve;
    options_.software = "radfix " RAD_VERSION;
  }

  BakedLightMap run() {
    progress_("bake: charts");
    const bake::Atlas atlas = bake::lay_out_atlas(
        solved_.mesh, {command_.texel, solved_.finest_element / kTexelsOfElement, command_.page_size});
    if (!atlas.problem.empty()) return {"--bake: " + atlas.problem, {}, {}, {}};
    const bake::LightMapBaker baker(atlas, solved_.mesh, solved_.scene.materials, solved_.field, options_);
    result_.map = bake::light_map_places(atlas, solved_.display, solved_.lattice, baker.white());
    result_.map.look = options_.look;
    result_.figures.charts = atlas.charts.size();
    result_.figures.texel = atlas.texel;
    for (const bake::AtlasPage& page : atlas.pages) result_.figures.texels += std::uint64_t{page.width} * page.height;
    bake_pages(atlas, baker);
    if (!command_.dry_run) add_atlas(atlas, baker);
    return std::move(result_);
  }

 private:
  void bake_pages(const bake::Atlas& atlas, const bake::LightMapBaker& baker) {
    double area = 0, clamped = 0;
    for (std::uint32_t page = 0; page < atlas.pages.size(); ++page) {
      progress_(fmt::format("bake: page {} of {}", page + 1, atlas.pages.size()));
      bake::BakedPage baked = baker.bake(page);
      area += baked.area;
      clamped += baked.clamped_area;
      add_page(page, std::move(baked));
    }
    result_.map.clamped_share = area > 0 ? clamped / area : 0;
    result_.figures.clamped_share = result_.map.clamped_share;
  }

  void add_page(std::uint32_t page, bake::BakedPage baked) {
    const fs::path png = page_path(command_.output, page, "png");
    auto image = std::make_shared<scene::Image>();
    if (embeds_images(command_.output)) {
      image->name = png.filename().string();
      image->media_type = "image/png";
    } else {
      image->path = png.filename().string();
    }
    image->bytes = std::move(baked.png);
    result_.map.pages.push_back(image);
    if (command_.dry_run) return;
    add_file(page_path(command_.output, page, "exr"), std::make_shared<std::string>(std::move(baked.exr)));
    add_file(png, std::shared_ptr<const std::string>(image, &image->bytes));
  }

  void add_file(fs::path path, std::shared_ptr<const std::string> bytes) {
    result_.files.push_back({std::move(path), std::move(bytes)});
  }

  void add_atlas(const bake::Atlas& atlas, const bake::LightMapBaker& baker) {
    report::AtlasRecord record{atlas,
                               solved_.display,
                               solved_.scene,
                               options_,
                               baker.precision(),
                               baker.white(),
                               result_.map.clamped_share,
                               {},
                               {},
                               {}};
    record.model = fs::path(command_.output).filename().string();
    for (std::size_t page = 0; page < atlas.pages.size(); ++page) {
      record.exr_pages.push_back(page_path(command_.output, page, "exr").filename().string());
      record.png_pages.push_back(page_path(command_.output, page, "png").filename().string());
    }
    add_file(atlas_path(command_.output), std::make_shared<std::string>(report::atlas_json(record)));
    result_.figures.files.push_back(result_.files.back().path.string());
    for (std::size_t i = 0; i + 1 < result_.files.size(); ++i) {
      result_.figures.files.push_back(result_.files[i].path.string());
    }
  }

  const FixCommand& command_;
  const SolvedMesh& solved_;
  const std::function<void(const std::string&)>& progress_;
  bake::LightMapOptions options_;
  BakedLightMap result_;
};

}  // namespace

BakedLightMap bake_light_map(const FixCommand& command, const SolvedMesh& solved,
                             const std::function<void(const std::string&)>& progress) {
  return Baking(command, solved, progress).run();
}

fs::path atlas_path(const std::string& output) {
  fs::path path = stem_of(output);
  path += ".atlas.json";
  return path;
}

}  // namespace rad::cli
