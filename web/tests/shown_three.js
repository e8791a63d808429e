// Runs in the browser: three.js shows /model as one camera sees it. No tone mapping, codes in sRGB.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { codesOf } from './canvas_codes.js';

THREE.ColorManagement.enabled = true;

// Display values per cd/m²: three.js shows a radiance of 1 as white.
function expose(root, perLuminance) {
  root.traverse(({ material }) => {
    if (material?.emissiveMap && !material.userData.exposed) {
      material.emissiveIntensity *= perLuminance;
      material.userData.exposed = true;
    }
  });
}

window.show = async ({ camera, perLuminance }, points) => {
  const canvas = document.querySelector('canvas');
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
  renderer.outputColorSpace = THREE.SRGBColorSpace;
  renderer.toneMapping = THREE.NoToneMapping;
  const { scene } = await new GLTFLoader().loadAsync('/model');
  expose(scene, perLuminance);
  const eye = new THREE.PerspectiveCamera(camera.fieldOfView, canvas.width / canvas.height, camera.near, camera.far);
  eye.position.set(...camera.position);
  eye.up.set(...camera.up);
  eye.lookAt(...camera.target);
  const world = new THREE.Scene();
  world.add(scene);
  renderer.render(world, eye);
  return codesOf(renderer.getContext(), points);
};
