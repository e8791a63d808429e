#include "validate/rules.h"

namespace rad::validate {

constinit const Rule index_out_of_range{
    .id = "RL002",
    .alias = "index-out-of-range",
    .title = "A face names a vertex that does not exist",
    .message = "{detail}; the face is left out",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Error,
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "drop-bad-faces",
    .citation = "",
    .doc = {.what = "A face refers to vertex 0, to a vertex beyond the last, or by a negative index to one before the "
                    "first.",
            .why = "The face cannot be built. Where it should be there is a hole, and light passes through.",
            .how = "Indices are checked against the number of vertices of the whole file (OBJ: negative ones against "
                   "those read so far).",
            .fix = "Export the model again; an index error usually means a truncated or hand-edited file. radfix "
                   "refuses the model until then, since faces would be lost.",
            .modeller =
                "In every modeller: re-export. If the error stays, the exporter is at fault; try another format.",
            .limits = "None known."},
    .reports = scene::ReadIssueKind::IndexOutOfRange,
};

}  // namespace rad::validate
