#include "validate/rules.h"

namespace rad::validate {

constinit const Rule parse_error{
    .id = "RL001",
    .alias = "parse-error",
    .title = "A file or a record of it cannot be read",
    .message = "{detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Error,
    .citation = "",
    .doc = {.what =
                "The file, or one record of it, does not follow its format, is empty, or is in a format that is not "
                "read.",
            .why = "What cannot be read cannot be judged: surfaces may be missing from everything that follows.",
            .how = "The reader reports the line, byte offset or JSON pointer at which it stopped or skipped a record. "
                   "Other records and other files are still judged.",
            .fix = "Export the file again. For a format that is not read, export OBJ, glTF, PLY, STL or OFF.",
            .modeller = "SketchUp: File > Export > 3D Model, OBJ or glTF. Revit: export IFC or FBX and convert. Rhino: "
                        "Export Selected, OBJ. Blender: File > Export > glTF 2.0 or Wavefront.",
            .limits = "After a damaged record in a binary file, what follows may be lost; the message says so."},
    .reports = scene::ReadIssueKind::ParseError,
};

}  // namespace rad::validate
