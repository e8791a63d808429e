// The light of a model: radiosity at its vertices, exposed and curved as a display shows it, or in false colours.
import * as THREE from 'three';

const SCALE_TEXELS = 256;

const rgb = (code) => [code >> 16, (code >> 8) & 255, code & 255];

// sRGB codes of the scale at a value from 0 to 1.
export function scaleCodes(palette, value) {
  const at = Math.min(1, Math.max(0, value)) * (palette.length - 1);
  const first = Math.min(Math.floor(at), palette.length - 2);
  const [a, b] = [palette[first], palette[first + 1]].map(rgb);
  return a.map((code, i) => Math.round(code + (b[i] - code) * (at - first)));
}

function scaleTexture(palette) {
  const codes = new Uint8Array(4 * SCALE_TEXELS);
  for (let i = 0; i < SCALE_TEXELS; ++i) codes.set([...scaleCodes(palette, i / (SCALE_TEXELS - 1)), 255], 4 * i);
  const texture = new THREE.DataTexture(codes, SCALE_TEXELS, 1);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export const CURVES = ['linear', 'shoulder', 'reinhard'];

// As scene/display_curve.h has the curves; mode 3 is false colours, whose texture holds codes.
const FRAGMENT = `
  varying vec3 light;
  uniform float exposure;
  uniform int mode;
  uniform sampler2D scale;
  const vec3 weights = vec3(0.2126, 0.7152, 0.0722);
  vec3 curved(vec3 exposed) {
    float most = max(exposed.r, max(exposed.g, exposed.b));
    float l = dot(exposed, weights);
    if (mode == 1 && most > 0.6) {
      float beyond = (most - 0.6) / 0.4;
      return exposed * ((0.6 + 0.4 * beyond / (1.0 + beyond)) / most);
    }
    return mode == 2 ? exposed * ((1.0 + l / 16.0) / (1.0 + l)) : exposed;
  }
  void main() {
    vec3 exposed = exposure * max(light, vec3(0.0));
    if (!gl_FrontFacing) {
      gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);
    } else if (mode == 3) {
      float at = clamp(dot(exposed, weights), 0.0, 1.0);
      gl_FragColor = vec4(texture2D(scale, vec2((at * ${SCALE_TEXELS - 1}.0 + 0.5) / ${SCALE_TEXELS}.0, 0.5)).rgb, 1.0);
      return;
    } else {
      gl_FragColor = vec4(clamp(curved(exposed), 0.0, 1.0), 1.0);
    }
    #include <colorspace_fragment>
  }`;

// A material that shows the attribute `radiosity` (W/m²).
export function lightMaterial(palette) {
  return new THREE.ShaderMaterial({
    uniforms: {
      exposure: { value: 1 },
      mode: { value: 0 },
      scale: { value: scaleTexture(palette) },
      // What a stage sets of any surface.
      opacity: { value: 1 },
      colour: { value: new THREE.Color() },
      back: { value: new THREE.Color() },
    },
    vertexShader: `
      attribute vec3 radiosity;
      varying vec3 light;
      void main() {
        light = radiosity;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: FRAGMENT,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}

export const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
