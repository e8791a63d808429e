// Google's Draco, as npm has it: encoder and decoder, without ours.
import draco3d from 'draco3d';

let decoding, encoding;

// { corners, attributes: { NAME: Float32Array or Uint16Array, one row a vertex } } of a stream; `ids` are unique ids by name.
export async function decoded(bytes, ids) {
  const draco = await (decoding ??= draco3d.createDecoderModule({}));
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  const status = decoder.DecodeArrayToMesh(new Int8Array(bytes), bytes.length, mesh);
  if (!status.ok()) throw new Error(status.error_msg());
  const attributes = {};
  for (const [name, id] of Object.entries(ids)) {
    const attribute = decoder.GetAttributeByUniqueId(mesh, id);
    const whole = attribute.data_type() === draco.DT_UINT16;
    const values = whole ? new draco.DracoUInt16Array() : new draco.DracoFloat32Array();
    if (whole) decoder.GetAttributeUInt16ForAllPoints(mesh, attribute, values);
    else decoder.GetAttributeFloatForAllPoints(mesh, attribute, values);
    attributes[name] = (whole ? Uint16Array : Float32Array).from({ length: values.size() }, (_, i) => values.GetValue(i));
    draco.destroy(values);
  }
  const face = new draco.DracoInt32Array();
  const corners = new Uint32Array(3 * mesh.num_faces());
  for (let i = 0; i < mesh.num_faces(); ++i) {
    decoder.GetFaceFromMesh(mesh, i, face);
    for (let k = 0; k < 3; ++k) corners[3 * i + k] = face.GetValue(k);
  }
  for (const thing of [face, mesh, decoder]) draco.destroy(thing);
  return { corners, attributes };
}

const KINDS = { POSITION: 'POSITION', NORMAL: 'NORMAL', COLOR_0: 'COLOR', TEXCOORD_0: 'TEX_COORD', TEXCOORD_1: 'TEX_COORD' };
// What draco_encoder quantises to unless told otherwise.
const BITS = { POSITION: 11, NORMAL: 8, COLOR: 8, TEX_COORD: 10, GENERIC: 8 };

// A stream of one primitive on its own, { bytes, ids }, with positions of `positionBits` in the primitive's own box.
export async function encodedAlone({ corners, attributes }, positionBits) {
  const draco = await (encoding ??= draco3d.createEncoderModule({}));
  const builder = new draco.MeshBuilder();
  const mesh = new draco.Mesh();
  const encoder = new draco.Encoder();
  const vertices = attributes.POSITION.length / 3;
  builder.AddFacesToMesh(mesh, corners.length / 3, corners);
  const ids = {};
  for (const [name, values] of Object.entries(attributes)) {
    const kind = draco[KINDS[name] ?? 'GENERIC'];
    const add = values instanceof Uint16Array ? 'AddUInt16Attribute' : 'AddFloatAttribute';
    ids[name] = builder[add](mesh, kind, vertices, values.length / vertices, values);
  }
  for (const [kind, bits] of Object.entries(BITS)) {
    encoder.SetAttributeQuantization(draco[kind], kind === 'POSITION' ? positionBits : bits);
  }
  const out = new draco.DracoInt8Array();
  const length = encoder.EncodeMeshToDracoBuffer(mesh, out);
  if (!length) throw new Error('Draco encodes nothing');
  const bytes = Uint8Array.from({ length }, (_, i) => out.GetValue(i));
  for (const thing of [out, mesh, encoder, builder]) draco.destroy(thing);
  return { bytes, ids };
}
