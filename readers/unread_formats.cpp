#include "readers/unread_formats.h"

#include <algorithm>
#include <array>

namespace rad::readers {
namespace {

struct Mark {
  std::string_view mark;
  std::string_view format;
};

constexpr std::array<Mark, 19> kSuffixes = {{
    {".dwg", "DWG"},     {".ifczip", "IFC"},      {".ifcxml", "IFC"},    {".city.jsonl", "CityJSON"},
    {".gbxml", "gbXML"}, {".usd", "USD"},         {".usda", "USD"},      {".usdc", "USD"},
    {".usdz", "USD"},    {".skp", "SketchUp"},    {".blend", "Blender"}, {".3dm", "Rhino 3DM"},
    {".max", "3ds Max"}, {".rvt", "Revit"},       {".amf", "AMF"},       {".wrl", "VRML"},
    {".gml", "CityGML"}, {".citygml", "CityGML"}, {".brep", "BREP"},
}};

constexpr std::array<Mark, 6> kFirstBytes = {{
    {"ISO-10303-21;", "STEP or IFC"},
    {"BLENDER", "Blender"},
    {"AC10", "DWG"},
    {"#usda", "USD"},
    {"PXR-USDC", "USD"},
    {"#VRML", "VRML"},
}};

}  // namespace

std::string lower_case_name(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return name;
}

std::string_view unread_format(std::string_view head, const std::filesystem::path& path) {
  const std::string name = lower_case_name(path);
  for (const Mark& suffix : kSuffixes) {
    if (name.ends_with(suffix.mark)) return suffix.format;
  }
  for (const Mark& first : kFirstBytes) {
    if (head.starts_with(first.mark)) return first.format;
  }
  return {};
}

}  // namespace rad::readers
