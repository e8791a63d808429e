// STEP and IGES through OpenCASCADE: every face of the CAD model becomes triangles within a named deflection.
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_Face.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <unordered_map>

#include "readers/components.h"
#include "readers/instance_lines.h"
#include "readers/occt/product_tree.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "readers/unread_formats.h"
#include "scene/drawing_colour.h"
#include "scene/scene_builder.h"

namespace rad::readers {

namespace occt {
namespace {

using scene::ReadIssueKind;

constexpr std::string_view kStepMark = "ISO-10303-21;";
// How far triangles may be from the surface that they stand for: a thousandth of the diagonal of the part's box, and
// by how much their planes may turn against it.
constexpr double kDeflection = 1e-3;
constexpr double kAngularDeflection = 0.35;  ///< radians, 20°
constexpr double kMetresPerUnit = 0.001;     ///< OpenCASCADE gives millimetres, whatever the file states

void be_silent() { Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream)); }

Handle(TDocStd_Document) new_document() {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  return document;
}

using FaceNumbers = std::unordered_map<const void*, std::uint64_t>;

/// The number "#12" of the record that each face was made of.
FaceNumbers numbers_of_faces(const STEPCAFControl_Reader& reader) {
  FaceNumbers numbers;
  const Handle(XSControl_WorkSession) session = reader.Reader().WS();
  const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(session->Model());
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  if (model.IsNull()) return numbers;
  for (int i = 1; i <= process->NbMapped(); ++i) {
    const Handle(Standard_Transient) record = process->Mapped(i);
    if (!record->IsKind(STANDARD_TYPE(StepShape_Face))) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, record);
    const int number = model->IdentLabel(record);
    if (!shape.IsNull() && number > 0) numbers.emplace(shape.TShape().get(), static_cast<std::uint64_t>(number));
  }
  return numbers;
}

class OcctReader {
 public:
  explicit OcctReader(const Input& input)
      : input_(input), is_step_(input.bytes.starts_with(kStepMark)), builder_(input.path, is_step_ ? "step" : "iges") {
    builder_.add_section({input.path, {}, scene::RecordKind::Line});
    scene::Scene& scene = builder_.scene();
    scene.metres_per_unit = kMetresPerUnit;
    scene.triangles_only = true;
    scene.splits_vertices = true;
  }

  ReadResult run() {
    try {
      be_silent();
      const bool read = is_step_ ? read_step() : read_iges();
      if (read) add_parts();
    } catch (const Standard_Failure& failure) {
      refuse(std::string("OpenCASCADE gives up: ") + failure.GetMessageString());
    }
    return {builder_.take(), std::move(issues_)};
  }

 private:
  bool refuse(std::string what) {
    issues_.add({ReadIssueKind::ParseError, std::move(what), {}, 1});
    return false;
  }

  bool read_step() {
    STEPCAFControl_Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    std::istringstream stream{std::string(input_.bytes)};
    if (reader.ChangeReader().ReadStream("model.step", stream) != IFSelect_RetDone) {
      return refuse("OpenCASCADE finds no STEP model in the file");
    }
    document_ = new_document();
    if (!reader.Transfer(document_)) return refuse("OpenCASCADE finds no shape in the STEP model");
    numbers_ = numbers_of_faces(reader);
    lines_ = lines_of_instances(input_.bytes);
    return true;
  }

  bool read_iges() {
    IGESCAFControl_Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    if (reader.ReadFile(input_.path.c_str()) != IFSelect_RetDone)
      return refuse("OpenCASCADE finds no IGES model in the file");
    document_ = new_document();
    return reader.Transfer(document_) || refuse("OpenCASCADE finds no shape in the IGES model");
  }

  void add_parts() {
    for (const Part& part : parts_of(document_, input_.limits.node_depth)) {
      if (full_) return;
      if (part.shape.IsNull()) continue;
      add_part(part);
    }
  }

  void add_part(const Part& part) {
    Bnd_Box box;
    BRepBndLib::Add(part.shape, box);
    if (box.IsVoid()) return;
    const double diagonal = std::sqrt(box.SquareExtent());
    const BRepMesh_IncrementalMesh mesher(part.shape, kDeflection * diagonal, false, kAngularDeflection, false);
    builder_.use_object(builder_.object(part.name));
    std::uint64_t index = 0;
    for (TopExp_Explorer faces(part.shape, TopAbs_FACE); faces.More() && !full_; faces.Next()) {
      add_face(TopoDS::Face(faces.Current()), part, ++index);
    }
    for (TopExp_Explorer edges(part.shape, TopAbs_EDGE, TopAbs_FACE); edges.More(); edges.Next()) {
      issues_.add_unsupported("curves that bound no face", {});
    }
  }

  void add_face(const TopoDS_Face& face, const Part& part, std::uint64_t index) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, place);
    const auto number = numbers_.find(face.TShape().get());
    const std::string name =
        number == numbers_.end() ? "face " + std::to_string(index) : "face #" + std::to_string(number->second);
    if (triangles.IsNull()) return issues_.add_unsupported("faces that OpenCASCADE cannot divide into triangles", {});
    std::string why =
        limit_before_vertices(builder_.scene(), static_cast<std::uint64_t>(triangles->NbNodes()), input_.limits);
    if (why.empty())
      why =
          limit_before_face(builder_.scene(), 3 * static_cast<std::uint64_t>(triangles->NbTriangles()), input_.limits);
    if (!why.empty()) {
      full_ = true;
      refuse(std::move(why));
      return;
    }
    const auto line = number == numbers_.end() ? lines_.end() : lines_.find(number->second);
    builder_.use_group(builder_.group(name));
    builder_.use_entity(builder_.add_entity(name));
    const auto own_colour = colour_of_face(document_, face.Located(TopLoc_Location()));
    builder_.use_material(material_of(own_colour ? own_colour : part.colour));
    add_triangles(*triangles, place.Transformation(), face.Orientation() == TopAbs_REVERSED,
                  line == lines_.end() ? 0 : line->second);
  }

  void add_triangles(const Poly_Triangulation& triangles, const gp_Trsf& place, bool reversed, std::uint64_t line) {
    const auto first = static_cast<scene::VertexId>(builder_.vertex_count());
    for (int i = 1; i <= triangles.NbNodes(); ++i) {
      const gp_Pnt at = triangles.Node(i).Transformed(place);
      builder_.add_vertex({at.X(), at.Y(), at.Z()}, line);
    }
    // A mirroring placement turns triangles over as well.
    const bool turned = reversed != place.IsNegative();
    for (int i = 1; i <= triangles.NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      triangles.Triangle(i).Get(a, b, c);
      if (turned) std::swap(b, c);
      const auto vertex = [&](int node) { return first + static_cast<scene::VertexId>(node - 1); };
      builder_.add_face(std::array{vertex(a), vertex(b), vertex(c)}, line);
    }
  }

  scene::MaterialId material_of(std::optional<std::uint32_t> colour) {
    if (!colour) return 0;
    std::array<char, 8> name{};
    std::snprintf(name.data(), name.size(), "#%06X", *colour & 0xFFFFFF);
    const scene::MaterialId id = builder_.material(name.data());
    builder_.material_at(id).reflectance = scene::reflectance_of_colour(*colour);
    builder_.material_at(id).reflectance_stated = true;
    return id;
  }

  const Input& input_;
  bool is_step_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  Handle(TDocStd_Document) document_;
  FaceNumbers numbers_;
  std::map<std::uint64_t, std::uint64_t> lines_;
  bool full_ = false;
};

}  // namespace
}  // namespace occt
}  // namespace rad::readers

// The one name that readers/step.cpp looks up.
extern "C" __attribute__((visibility("default"))) void rad_read_step(const rad::readers::Input& input,
                                                                    rad::readers::ReadResult& result) {
  result = rad::readers::occt::OcctReader(input).run();
}
