#include "readers/occt/product_tree.h"

#include <Quantity_Color.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>

namespace rad::readers::occt {
namespace {

constexpr int kLongestName = 255;

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  std::string text = TCollection_AsciiString(name->Get(), '?').ToCString();
  if (text.size() > kLongestName) text.resize(kLongestName);
  return text;
}

std::uint32_t rgb_of(const Quantity_Color& colour) {
  // Colours are kept linear and shown in sRGB, as the files state them.
  double red = 0, green = 0, blue = 0;
  colour.Values(red, green, blue, Quantity_TOC_sRGB);
  const auto channel = [](double value) { return static_cast<std::uint32_t>(std::lround(value * 255)) & 0xFF; };
  return channel(red) << 16 | channel(green) << 8 | channel(blue);
}

template <typename Holder>
std::optional<std::uint32_t> colour_in(const Handle(XCAFDoc_ColorTool) & tool, const Holder& holder) {
  Quantity_Color colour;
  for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
    if (tool->GetColor(holder, type, colour)) return rgb_of(colour);
  }
  return std::nullopt;
}

class Walk {
 public:
  Walk(const Handle(TDocStd_Document) & document, std::uint64_t depth)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        depth_(depth) {}

  std::vector<Part> run() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    for (int i = 1; i <= roots.Length(); ++i) visit(roots.Value(i), TopLoc_Location(), {}, {}, 1);
    return std::move(parts_);
  }

 private:
  void visit(const TDF_Label& label, const TopLoc_Location& place, const std::string& path,
             std::optional<std::uint32_t> colour, std::uint64_t depth) {
    if (depth > depth_) return;
    if (const auto own = colour_in(colours_, label)) colour = own;
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      TDF_Label referred;
      if (!XCAFDoc_ShapeTool::GetReferredShape(label, referred)) return;
      return visit(referred, place * XCAFDoc_ShapeTool::GetLocation(label), path, colour, depth + 1);
    }
    const std::string name = name_of(label);
    const std::string full = path.empty() || name.empty() ? path + name : path + "/" + name;
    if (!XCAFDoc_ShapeTool::IsAssembly(label)) {
      parts_.push_back({XCAFDoc_ShapeTool::GetShape(label).Located(place), full, colour});
      return;
    }
    for (TDF_ChildIterator child(label); child.More(); child.Next()) {
      if (XCAFDoc_ShapeTool::IsComponent(child.Value())) visit(child.Value(), place, full, colour, depth + 1);
    }
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  std::uint64_t depth_;
  std::vector<Part> parts_;
};

}  // namespace

std::vector<Part> parts_of(const Handle(TDocStd_Document) & document, std::uint64_t depth) {
  return Walk(document, depth).run();
}

std::optional<std::uint32_t> colour_of_face(const Handle(TDocStd_Document) & document, const TopoDS_Shape& face) {
  return colour_in(XCAFDoc_DocumentTool::ColorTool(document->Main()), face);
}

}  // namespace rad::readers::occt
