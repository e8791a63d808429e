// The model as three.js draws it: faces shaded flat, edges of faces as lines, faces at fault hatched over them.
import * as THREE from 'three';

const SHADER_PRELUDE = `
  varying vec3 seen;
`;

// Flat shading by a light at the eye: the normal comes from the derivatives of the position, so vertices need none.
function faceMaterial(uniforms, body) {
  return new THREE.ShaderMaterial({
    uniforms,
    vertexShader: `${SHADER_PRELUDE}
      void main() {
        vec4 position4 = modelViewMatrix * vec4(position, 1.0);
        seen = position4.xyz;
        gl_Position = projectionMatrix * position4;
      }`,
    fragmentShader: `${SHADER_PRELUDE}
      uniform vec3 colour;
      uniform vec3 back;
      uniform float opacity;
      const vec3 lamp = normalize(vec3(0.35, 0.8, 0.5));
      // Light at the eye and a little from above it, so that faces at an angle to each other differ.
      float shade() {
        vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
        vec3 towards = -normalize(seen);
        if (dot(normal, towards) < 0.0) normal = -normal;
        return 0.5 + 0.3 * dot(normal, towards) + 0.25 * dot(normal, lamp);
      }
      void main() { ${body} }`,
  });
}

function surfaceMaterial(theme) {
  return faceMaterial(
    { colour: { value: new THREE.Color(theme.surface) }, back: { value: new THREE.Color(theme.back) }, opacity: { value: 1 } },
    `gl_FragColor = vec4((gl_FrontFacing ? colour : back) * shade(), opacity);
     #include <colorspace_fragment>`,
  );
}

function hatchMaterial(colour) {
  const material = faceMaterial(
    { colour: { value: new THREE.Color(colour) }, opacity: { value: 1 } },
    `float stripe = step(5.0, mod(gl_FragCoord.x + gl_FragCoord.y, 10.0));
     gl_FragColor = vec4(colour * (0.3 + 0.7 * shade()), mix(0.25, 0.6, stripe) * opacity);
     #include <colorspace_fragment>`,
  );
  material.transparent = true;
  material.side = THREE.DoubleSide;
  material.polygonOffset = true;
  material.polygonOffsetFactor = -1;
  material.polygonOffsetUnits = -1;
  material.depthWrite = false;
  return material;
}

// Every edge of a face once, as pairs of vertices.
function edgesOf({ positions, corners, outlines }) {
  const vertices = positions.length / 3;
  const seen = new Set();
  const pairs = [];
  for (let triangle = 0; triangle < outlines.length; ++triangle) {
    for (let i = 0; i < 3; ++i) {
      if (!(outlines[triangle] & (1 << i))) continue;
      const a = corners[3 * triangle + i];
      const b = corners[3 * triangle + ((i + 1) % 3)];
      const key = a < b ? a * vertices + b : b * vertices + a;
      if (seen.has(key)) continue;
      seen.add(key);
      pairs.push(a, b);
    }
  }
  return new Uint32Array(pairs);
}

export class Model {
  // `place` takes the geometry to the space of the faults.
  constructor(content, theme, place) {
    this.content = content;
    this.group = new THREE.Group();
    this.group.scale.setScalar(place.scale);
    this.group.position.fromArray(place.offset);
    this.group.updateMatrix();
    const positions = new THREE.BufferAttribute(content.positions, 3);

    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', positions);
    geometry.setIndex(new THREE.BufferAttribute(content.corners, 1));
    this.surface = new THREE.Mesh(geometry, surfaceMaterial(theme));
    this.surface.material.polygonOffset = true;
    this.surface.material.polygonOffsetFactor = 1;
    this.surface.material.polygonOffsetUnits = 1;
    this.group.add(this.surface);

    const lines = new THREE.BufferGeometry();
    lines.setAttribute('position', positions);
    lines.setIndex(new THREE.BufferAttribute(edgesOf(content), 1));
    const strength = content.outlines.length > 50_000 ? 0.35 : 0.8;
    this.edges = new THREE.LineSegments(
      lines,
      new THREE.LineBasicMaterial({ color: theme.edge, transparent: true, opacity: strength }),
    );
    this.group.add(this.edges);

    this.hatch = new THREE.Mesh(new THREE.BufferGeometry(), hatchMaterial('#000'));
    this.hatch.visible = false;
    this.hatch.renderOrder = 1;
    this.group.add(this.hatch);
  }

  // Hatches triangles, given as first, count, first, count…
  highlight(stretches, colour) {
    const length = stretches.reduce((sum, value, i) => sum + (i % 2 ? value : 0), 0);
    const corners = new Uint32Array(3 * length);
    let at = 0;
    for (let i = 0; i < stretches.length; i += 2) {
      const part = this.content.corners.subarray(3 * stretches[i], 3 * (stretches[i] + stretches[i + 1]));
      corners.set(part, at);
      at += part.length;
    }
    this.hatch.geometry.dispose();
    this.hatch.geometry = new THREE.BufferGeometry();
    this.hatch.geometry.setAttribute('position', this.surface.geometry.getAttribute('position'));
    this.hatch.geometry.setIndex(new THREE.BufferAttribute(corners, 1));
    this.hatch.material.uniforms.colour.value.set(colour);
    this.hatch.visible = length > 0;
  }

  showBacks(shown) {
    this.surface.material.side = shown ? THREE.DoubleSide : THREE.FrontSide;
    this.surface.material.needsUpdate = true;
  }

  seeThrough(on) {
    const material = this.surface.material;
    material.transparent = on;
    material.depthWrite = !on;
    material.uniforms.opacity.value = on ? 0.18 : 1;
    material.needsUpdate = true;
  }

  showEdges(shown) {
    this.edges.visible = shown;
  }

  paint(theme) {
    this.surface.material.uniforms.colour.value.set(theme.surface);
    this.surface.material.uniforms.back.value.set(theme.back);
    this.edges.material.color.set(theme.edge);
  }

  box() {
    const box = new THREE.Box3().setFromBufferAttribute(this.surface.geometry.getAttribute('position'));
    return box.applyMatrix4(this.group.matrix);
  }

  dispose() {
    for (const part of [this.surface, this.edges, this.hatch]) {
      part.geometry.dispose();
      part.material.dispose();
    }
  }
}
