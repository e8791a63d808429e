// Code values of what a WebGL context has drawn, at pixels [x, y] from the upper left.
export function codesOf(gl, points) {
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const code = new Uint8Array(4);
  return points.map(([x, y]) => {
    gl.readPixels(x, gl.drawingBufferHeight - 1 - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, code);
    return [...code.subarray(0, 3)];
  });
}
