// The surfaces of an IFC file, for radlint and radfix: one JSON object a line on standard output.
//
//   node ifc_faces.mjs FILE.ifc
//
// First {"schema", "program"}, then for every geometry of every product {"id" (of the line in the file), "guid", "type",
// "name", "storey", "material", "colour" (red, green, blue, opacity; 0..1), "vertices" (x, y, z, metres, Z up),
// "triangles" (vertex numbers from 0)}; at the end {"end", "products"}. {"error"} where the file cannot be read.
// Openings are cut out of what they are in.
import fs from 'node:fs';
import * as WebIFC from 'web-ifc';

// Nothing but the report may reach standard output.
for (const method of ['log', 'info', 'warn', 'debug']) console[method] = console.error;

function put(object) {
  fs.writeSync(1, JSON.stringify(object) + '\n');
}

function line(api, model, id) {
  try {
    return api.GetLine(model, id);
  } catch {
    return null;
  }
}

function lines_of_type(api, model, type) {
  const ids = api.GetLineIDsWithType(model, type);
  return Array.from({ length: ids.size() }, (_, i) => line(api, model, ids.get(i))).filter((item) => item !== null);
}

const list = (value) => (Array.isArray(value) ? value : value ? [value] : []);

// The storey of every product that a spatial structure contains, and of the parts of such products.
function storeys(api, model) {
  const names = new Map();
  for (const relation of lines_of_type(api, model, WebIFC.IFCRELCONTAINEDINSPATIALSTRUCTURE)) {
    const structure = line(api, model, relation.RelatingStructure?.value);
    for (const product of list(relation.RelatedElements)) names.set(product.value, structure?.Name?.value ?? '');
  }
  // Parts of parts: as many passes as there are levels, and no more than a sound file can need.
  const aggregates = lines_of_type(api, model, WebIFC.IFCRELAGGREGATES);
  for (let pass = 0, changed = true; changed && pass < 16; ++pass) {
    changed = false;
    for (const relation of aggregates) {
      const name = names.get(relation.RelatingObject?.value);
      if (name === undefined) continue;
      for (const part of list(relation.RelatedObjects)) {
        changed ||= !names.has(part.value);
        if (!names.has(part.value)) names.set(part.value, name);
      }
    }
  }
  return names;
}

// The name of the first material in an association, however it is wrapped.
function material_name(api, model, id, depth = 0) {
  const item = depth < 6 ? line(api, model, id) : null;
  if (item === null) return '';
  if (item.type === WebIFC.IFCMATERIAL) return item.Name?.value ?? '';
  const inner = [item.ForLayerSet, item.ForProfileSet, item.Material, ...list(item.MaterialLayers), ...list(item.Materials),
    ...list(item.MaterialConstituents), ...list(item.MaterialProfiles)];
  for (const reference of inner) {
    const name = reference?.value ? material_name(api, model, reference.value, depth + 1) : '';
    if (name) return name;
  }
  return '';
}

function materials(api, model) {
  const names = new Map();
  for (const relation of lines_of_type(api, model, WebIFC.IFCRELASSOCIATESMATERIAL)) {
    const name = material_name(api, model, relation.RelatingMaterial?.value);
    for (const product of list(relation.RelatedObjects)) if (name) names.set(product.value, name);
  }
  return names;
}

// web-ifc gives metres with Y up; (x, y, z) was (x, -z, y).
function placed(vertices, matrix) {
  const points = [];
  for (let i = 0; i + 5 < vertices.length; i += 6) {
    const [x, y, z] = [vertices[i], vertices[i + 1], vertices[i + 2]];
    const at = (row) => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row];
    points.push(at(0), -at(2), at(1));
  }
  return points;
}

function put_mesh(api, model, mesh, storey_of, material_of) {
  const product = line(api, model, mesh.expressID);
  for (let i = 0; i < mesh.geometries.size(); ++i) {
    const part = mesh.geometries.get(i);
    const geometry = api.GetGeometry(model, part.geometryExpressID);
    const vertices = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
    const triangles = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
    geometry.delete();
    if (triangles.length === 0) continue;
    put({
      id: mesh.expressID,
      guid: product?.GlobalId?.value ?? '',
      type: api.GetNameFromTypeCode(api.GetLineType(model, mesh.expressID)) ?? '',
      name: product?.Name?.value ?? '',
      storey: storey_of.get(mesh.expressID) ?? '',
      material: material_of.get(mesh.expressID) ?? '',
      colour: [part.color.x, part.color.y, part.color.z, part.color.w],
      vertices: placed(vertices, part.flatTransformation),
      triangles: Array.from(triangles),
    });
  }
}

async function main() {
  const api = new WebIFC.IfcAPI();
  await api.Init();
  api.SetLogLevel(WebIFC.LogLevel.LOG_LEVEL_OFF);
  const model = api.OpenModel(new Uint8Array(fs.readFileSync(process.argv[2])), { COORDINATE_TO_ORIGIN: false });
  if (model < 0) throw new Error('web-ifc cannot open the file');
  put({ schema: api.GetModelSchema(model), program: `web-ifc ${api.GetVersion?.() ?? ''}`.trim() });
  const storey_of = storeys(api, model);
  const material_of = materials(api, model);
  let products = 0;
  api.StreamAllMeshes(model, (mesh) => {
    put_mesh(api, model, mesh, storey_of, material_of);
    ++products;
  });
  api.CloseModel(model);
  put({ end: true, products });
}

main().catch((error) => {
  put({ error: String(error?.message ?? error).slice(0, 200) });
  process.exitCode = 1;
});
