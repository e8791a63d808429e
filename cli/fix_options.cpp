// radfix's command line.
#include "cli/option_parser.h"
#include "cli/options.h"

namespace rad::cli {

namespace {

constexpr const char* kRadfixFooter = R"(Examples:
  radfix house.obj -o house.glb               repair it
  radfix house.obj -o mesh.ply --mesh         and mesh it
  radfix house.obj -o lit.glb --solve --preview lit.png
                                              and light it, with a picture
  radfix house.obj --dry-run --diff           what would be done, and where
  radfix convert plan.dxf plan.obj            another format, nothing repaired
  radfix --only grouper < a.stage.json | radfix --only isect > b.stage.json
                                              filter by filter

Reports: json and text say what was done; concise, jsonl, sarif, junit, github,
markdown, html, csv and leak-line are radlint's on the model that was written.

Formats: .obj .ply .stl .off .glb .gltf .drc .rad .dxf .city.json .3mf, and
.stage.json for a model between two stages (radfix convert --list says what
each holds). Standard output (-) carries a stage file.

Exit codes:
  0  written, read back, and clean at the stage that was asked for
  1  written, but errors remain; or a contract does not hold
  2  usage error, unreadable input, nothing that emits light, a file that cannot
     be written
  3  stopped: what was written, if anything, says that it is incomplete
  4  refused: no surface, faces would be lost, or every filter would make it
     worse; nothing was written)";

void add_coplanar_options(CLI::App& app, FixCommand& command, FixWords& words) {
  app.add_option("--coplanar-policy", words.coplanar_policy, "paper, area, priority, keep-first, keep-last")
      ->type_name("POLICY")
      ->group("Faces that overlap in a plane");
  app.add_option("--priority", command.coplanar.priority, "Material or object to be seen first; repeatable")
      ->allow_extra_args(false)
      ->type_name("GLOB")
      ->group("Faces that overlap in a plane");
  app.add_flag_callback(
         "--no-emitter-priority", [&command] { command.coplanar.emitter_priority = false; },
         "Lights give way like other faces")
      ->group("Faces that overlap in a plane");
}

CLI::Option* add_names(CLI::App& app, const char* name, std::vector<std::string>& into, const char* what) {
  return app.add_option(name, into, what)->delimiter(',')->allow_extra_args(false);
}

void add_stage_options(CLI::App& app, FixWords& words) {
  constexpr const char* kGroup = "Stages: grouper, isect, coplanar, orient, pmesh, emesh, solve, bake";
  app.add_flag("--mesh", words.mesh, "Go on to patches and elements")->group(kGroup);
  app.add_flag("--solve", words.solve, "Go on to a radiosity solution")->group(kGroup);
  app.add_option("--until", words.until, "Stop after this one")->type_name("STAGE")->group(kGroup);
  add_names(app, "--only", words.only, "Run these alone")->type_name("STAGES")->group(kGroup);
  add_names(app, "--skip", words.skip, "Leave these out; repair: the first four")->type_name("STAGES")->group(kGroup);
}

void add_repair_options(CLI::App& app, FixCommand& command, FixWords& words) {
  constexpr const char* kGroup = "Repair";
  add_names(app, "--fix-only", words.fix_only, "Cure these alone: RL110, t-vertex")->type_name("RULES")->group(kGroup);
  app.add_flag("--unsafe-fixes", command.unsafe_fixes, "Leave out faces that cannot be kept")->group(kGroup);
  app.add_flag("--check-contracts", command.check_contracts, "Judge between the stages; exit 1 where one fails")
      ->group(kGroup);
}

void add_light_options(CLI::App& app, FixCommand& command, FixWords& words) {
  constexpr const char* kGroup = "Mesh and light";
  app.add_option("--patch-size", words.patch_size, "Longest patch edge, file units (by area)")
      ->type_name("LENGTH")
      ->group(kGroup);
  app.add_option("--patch-size-of", words.patch_sizes, "Another for objects or materials, repeatable")
      ->allow_extra_args(false)
      ->type_name("GLOB=LENGTH")
      ->group(kGroup);
  app.add_option("--pmesh", words.pmesh, "grid (default), graded near short edges")->type_name("METHOD")->group(kGroup);
  app.add_option("--element-size", words.element_size, "Longest element edge (a quarter of the patch size)")
      ->type_name("LENGTH")
      ->group(kGroup);
  app.add_option("--emesh", words.emesh, "Shadows: silhouette (default), hemicube, none")
      ->type_name("SEARCH")
      ->group(kGroup);
  app.add_option("--shadow-size", words.shadow_size, "Longest element edge there (half the element size)")
      ->type_name("LENGTH")
      ->group(kGroup);
  app.add_option("--dump-hemicube", command.dump_hemicube, "Item and depth over the strongest emitter")
      ->type_name("EXR")
      ->group(kGroup);
  app.add_option("--refine", command.refine_levels, "Divide elements where light bends so often (4)")
      ->check(CLI::Range(0, 16))
      ->type_name("LEVELS")
      ->group(kGroup);
  app.add_option("--most-elements", command.most_elements, "Elements that it may lead to (half more)")
      ->type_name("N")
      ->group(kGroup);
  app.add_option("--exposure", words.exposure, "Display colour per W/m2 (automatic)")
      ->type_name("NUMBER")
      ->group(kGroup);
  app.add_option("--curve", words.curve, "linear (default), shoulder, reinhard")->type_name("CURVE")->group(kGroup);
  app.add_flag("--falsecolor", words.false_colour, "Colours that stand for W/m2, with a scale")->group(kGroup);
}

void add_bake_options(CLI::App& app, FixWords& words) {
  constexpr const char* kGroup = "Light maps";
  app.add_option("--bake", words.bake, "Light as: vertex (default), lightmap, emissive")
      ->type_name("MODE")
      ->group(kGroup);
  app.add_option("--texel", words.texel, "Longest side of a texel, file units (automatic)")
      ->type_name("LENGTH")
      ->group(kGroup);
  app.add_option("--page-size", words.page_size, "Longest side of a page in texels (4096)")
      ->type_name("N")
      ->group(kGroup);
  app.add_option("--store", words.store, "OpenEXR pages hold: M (default), E")->type_name("QUANTITY")->group(kGroup);
}

void add_output_options(CLI::App& app, FixCommand& command, FixWords& words) {
  constexpr const char* kGroup = "Output and reports";
  app.add_option("-o,--output", command.output, "A name in one of the formats, or -")->type_name("OUT")->group(kGroup);
  app.add_flag("--in-place", command.in_place, "Write to IN, which is kept as IN.orig")->group(kGroup);
  app.add_flag("--dry-run", command.dry_run, "Write no model, say what would be done")->group(kGroup);
  app.add_flag("--diff", command.diff, "Say what changed, and where")->group(kGroup);
  app.add_option("--report", words.reports, "Write a report to a file; repeatable")
      ->allow_extra_args(false)
      ->type_name("FORMAT=PATH")
      ->group(kGroup);
  app.add_option("--annotate", command.annotate, "Write a model coloured by what was done")
      ->type_name("GLB")
      ->group(kGroup);
  app.add_flag("--draco", command.draco, "Write OUT.draco.glb beside OUT.glb")->group(kGroup);
  app.add_option("--preview", command.preview, "Write a picture as well")->type_name("PNG")->group(kGroup);
  app.add_option("--camera", words.camera, "Taken from where, x,y,z:x,y,z (chosen)")
      ->type_name("EYE:MIDDLE")
      ->group(kGroup);
  app.add_option("--viewer", command.viewer, "Write a page that shows the solution")->type_name("HTML")->group(kGroup);
  app.add_option("--preview-mesh", words.preview_mesh, "Draw the edges of: patches, elements")
      ->type_name("WHICH")
      ->group(kGroup);
  app.add_flag("--timings", command.timings, "Put seconds for each stage into the report")->group(kGroup);
}

void add_facade_options(CLI::App& app, FixCommand& command) {
  app.add_option("--two-sided", command.two_sided, "Double faces of objects or materials, repeatable")
      ->allow_extra_args(false)
      ->type_name("GLOB")
      ->group("Unsafe");
  app.add_flag("--cap-planar", command.cap_planar, "Close flat openings")->group("Unsafe");
}

}  // namespace

std::variant<FixCommand, Stop> parse_radfix(std::span<const std::string> args) {
  CLI::App app("Repairs polygon models, meshes them, solves for light; judges what it wrote.", "radfix");
  FixCommand command;
  ModelWords words;
  prepare(app, kRadfixFooter);
  app.add_option("input", command.input, "Model file; - or none for standard input")->type_name("IN");
  FixWords fix;
  add_stage_options(app, fix);
  add_repair_options(app, command, fix);
  add_coplanar_options(app, command, fix);
  add_light_options(app, command, fix);
  add_bake_options(app, fix);
  add_output_options(app, command, fix);
  add_facade_options(app, command);
  add_model_options(app, words);
  add_config_options(app, command.judging);
  if (auto stop = parse(app, args)) return *stop;
  std::string fault = read_model_words(words, command.model);
  if (fault.empty()) fault = read_fix_words(fix, command);
  command.judging.model = command.model;
  if (fault.empty()) fault = read_settings(command.judging);
  if (!fault.empty()) return usage_error("radfix", fault);
  return command;
}

}  // namespace rad::cli
