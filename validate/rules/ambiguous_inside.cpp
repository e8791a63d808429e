#include <array>

#include "validate/open_winding.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-share", "1", 0.01, 0, 1, "share of sample points with no clear inside that is accepted"},
};

double threshold(const Context& context) { return context.parameter(ambiguous_inside, "max-share"); }

void check(const Context& context, Violations& out) {
  const Ambiguity ambiguity = sample_ambiguity(context);
  if (ambiguity.share <= threshold(context)) return;
  out.add({.point = context.position(ambiguity.worst), .measure = ambiguity.share, .cluster = kWholeModel});
}

}  // namespace

constinit const Rule ambiguous_inside{
    .id = "RL105",
    .alias = "ambiguous-inside",
    .title = "The faces do not say what is inside and what is outside",
    .message =
        "inside and outside cannot be told apart at a share {measure} of the places around open surfaces (at most "
        "{limit})",
    .requirement = Requirement::SolidModel,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .measure = {"share of sample points", MeasureUnit::Ratio},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 2.1",
    .doc = {.what = "Open surfaces go around a volume neither wholly nor not at all. The share is a score of how far "
                    "the model is from solids: 0 where all is closed.",
            .why = "The paper asks for solids or for facades whose backs are never seen. Where it cannot be told what "
                   "is inside, no program can tell which side of a face is the front, or what is matter and what air.",
            .how = "The winding number at up to 512 points that are spread over the box of the open surfaces. Closed "
                   "ones give whole numbers; what is left hangs on the rims alone. A point more than 0.1 from a whole "
                   "number is ambiguous; reported where more than 1 % are. Facades that are proved valid and ground "
                   "do not count.",
            .fix = "Close the openings (RL101 lists them), or leave facades whose backs cannot be seen.",
            .modeller = "SketchUp: Solid Inspector. Rhino: ShowEdges, Cap. Blender: 3D Print Toolbox, Solid. Revit: "
                        "export walls with their cores.",
            .limits = "Two openings whose winding cancels at a point hide each other there."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
