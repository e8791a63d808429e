// Runs in the browser: loads /model with three.js, frames it and counts what was drawn.
import * as THREE from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

// No surface has this colour by accident: what differs from it was drawn.
const BACKGROUND = [255, 0, 255];
const VIEWS = 8;
// As many pixels as a viewer has to see before it is a picture and not a speck.
const ENOUGH = 0.01;

const canvas = document.querySelector('canvas');
const renderer = new THREE.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
const scene = new THREE.Scene();
scene.background = new THREE.Color().setRGB(...BACKGROUND.map((code) => code / 255), THREE.SRGBColorSpace);
scene.add(new THREE.HemisphereLight(0xffffff, 0x808080, 3));

function cameraAt(view, box) {
  const sphere = box.getBoundingSphere(new THREE.Sphere());
  const radius = Math.max(sphere.radius, Number.MIN_VALUE);
  const camera = new THREE.PerspectiveCamera(40, canvas.width / canvas.height, radius / 100, radius * 10);
  const azimuth = ((view + 0.6) * 2 * Math.PI) / VIEWS;
  const direction = new THREE.Vector3(Math.sin(azimuth), 0.6, Math.cos(azimuth)).normalize();
  camera.position.copy(sphere.center).addScaledVector(direction, radius / Math.sin((20 * Math.PI) / 180));
  camera.lookAt(sphere.center);
  return camera;
}

// What the canvas shows: the share of it that was drawn, and the sRGB code values seen most often there.
function picture() {
  const copy = document.createElement('canvas');
  copy.width = canvas.width;
  copy.height = canvas.height;
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  let drawn = 0;
  const seen = new Map();
  let commonest = null;
  for (let i = 0; i < data.length; i += 4) {
    if (BACKGROUND.every((code, channel) => Math.abs(data[i + channel] - code) <= 2)) continue;
    ++drawn;
    const colour = data.slice(i, i + 3).join(' ');
    seen.set(colour, (seen.get(colour) ?? 0) + 1);
    if (!commonest || seen.get(colour) > seen.get(commonest)) commonest = colour;
  }
  return { drawn: drawn / (data.length / 4), commonest: commonest?.split(' ').map(Number) };
}

function countedMeshes(root) {
  const counts = { meshes: 0, triangles: 0, coloured: 0 };
  root.traverse((object) => {
    if (!object.isMesh) return;
    ++counts.meshes;
    counts.triangles += (object.geometry.index ?? object.geometry.attributes.position).count / 3;
    if (object.geometry.attributes.color && object.material.vertexColors) ++counts.coloured;
  });
  return counts;
}

async function show() {
  const loader = new GLTFLoader();
  loader.setDRACOLoader(new DRACOLoader().setDecoderPath('/node_modules/three/examples/jsm/libs/draco/gltf/'));
  loader.setMeshoptDecoder(MeshoptDecoder);
  const gltf = await loader.loadAsync('/model');
  scene.add(gltf.scene);
  const box = new THREE.Box3().setFromObject(gltf.scene);
  let shown = { drawn: 0 };
  // Surfaces are one-sided: from behind there may be nothing to see.
  for (let view = 0; view < VIEWS && shown.drawn < ENOUGH; ++view) {
    renderer.render(scene, cameraAt(view, box));
    shown = picture();
  }
  return { ...countedMeshes(gltf.scene), ...shown, enough: shown.drawn >= ENOUGH };
}

window.shown = show();
