// Runs in the browser: Babylon.js shows /model as one camera sees it. No tone mapping, codes in sRGB.
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { AppendSceneAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Scene } from '@babylonjs/core/scene.js';
import '@babylonjs/core/Loading/loadingScreen.js';
import '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import '@babylonjs/loaders/glTF/2.0/index.js';
import { codesOf } from './canvas_codes.js';

// Babylon.js takes 2.2 for the exponent of sRGB where it is not told otherwise.
const OPTIONS = { preserveDrawingBuffer: true, useExactSrgbConversions: true };

window.show = async ({ camera, perLuminance, options }, points) => {
  const canvas = document.querySelector('canvas');
  const engine = new Engine(canvas, false, { ...OPTIONS, ...options });
  const scene = new Scene(engine);
  scene.useRightHandedSystem = true; // that of glTF: no root that mirrors
  const shown = scene.imageProcessingConfiguration;
  shown.toneMappingEnabled = false;
  shown.contrast = 1;
  await AppendSceneAsync('/model', scene, { pluginExtension: '.glb' });
  shown.exposure = scene.materials.some(({ emissiveTexture }) => emissiveTexture) ? perLuminance : 1;
  const eye = new FreeCamera('eye', new Vector3(...camera.position), scene);
  eye.upVector = new Vector3(...camera.up);
  eye.setTarget(new Vector3(...camera.target));
  eye.fov = (camera.fieldOfView * Math.PI) / 180;
  eye.minZ = camera.near;
  eye.maxZ = camera.far;
  scene.activeCamera = eye;
  await scene.whenReadyAsync();
  scene.render();
  return codesOf(engine._gl, points);
};
