#include "readers/obj_keywords.h"

#include <array>

namespace rad::readers {
namespace {

using enum ObjStatement;

// The commonest first: the table is searched from its start.
constexpr std::array<ObjKeyword, 47> kKeywords = {{
    {"v", Vertex, {}},
    {"f", Face, {}},
    {"vt", TextureCoordinates, {}},
    {"vn", Normal, {}},
    {"usemtl", UseMaterial, {}},
    {"g", Group, {}},
    {"o", Object, {}},
    {"s", SmoothingGroup, {}},
    {"fo", Face, {}},
    {"mtllib", MaterialLibrary, {}},
    {"p", Unsupported, "points (p)"},
    {"l", Unsupported, "lines (l)"},
    {"curv", Unsupported, "curves (curv)"},
    {"curv2", Unsupported, "curves on surfaces (curv2)"},
    {"surf", Unsupported, "freeform surfaces (surf)"},
    {"call", Unsupported, "included files (call), which are never opened"},
    {"csh", Unsupported, "commands (csh), which are never run"},
    {"bzp", Unsupported, "patches of an old version (bzp)"},
    {"bsp", Unsupported, "patches of an old version (bsp)"},
    {"cdc", Unsupported, "curves of an old version (cdc)"},
    {"cdp", Unsupported, "patches of an old version (cdp)"},
    {"vp", Harmless, {}},
    {"res", Harmless, {}},
    {"mg", Harmless, {}},
    {"lod", Harmless, {}},
    {"bevel", Harmless, {}},
    {"c_interp", Harmless, {}},
    {"d_interp", Harmless, {}},
    {"maplib", Harmless, {}},
    {"usemap", Harmless, {}},
    {"shadow_obj", Harmless, {}},
    {"trace_obj", Harmless, {}},
    {"cstype", Harmless, {}},
    {"deg", Harmless, {}},
    {"bmat", Harmless, {}},
    {"step", Harmless, {}},
    {"parm", Harmless, {}},
    {"trim", Harmless, {}},
    {"hole", Harmless, {}},
    {"scrv", Harmless, {}},
    {"sp", Harmless, {}},
    {"end", Harmless, {}},
    {"con", Harmless, {}},
    {"ctech", Harmless, {}},
    {"stech", Harmless, {}},
    {"stype", Harmless, {}},
    {"scmp", Harmless, {}},
}};

constexpr ObjKeyword kNone;

}  // namespace

const ObjKeyword& obj_keyword(std::string_view keyword) {
  for (const ObjKeyword& known : kKeywords) {
    if (known.keyword == keyword) return known;
  }
  return kNone;
}

}  // namespace rad::readers
