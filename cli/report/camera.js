import { OrthographicCamera } from 'three';

const DEGREE = Math.PI / 180;
const HIGHEST = 89 * DEGREE;
const HALF = 1.26; // of what is seen; the sphere has the radius 1
const DISTANCE = 10;

// A parallel projection towards the origin, with z up; it begins as the drawing of report_scene.cpp is.
export class Camera {
  constructor() {
    this.azimuth = -55 * DEGREE;
    this.elevation = 22 * DEGREE;
    this.zoom = 1;
    this.three = new OrthographicCamera(-1, 1, 1, -1, 0.1, 2 * DISTANCE);
    this.three.up.set(0, 0, 1);
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(HIGHEST, Math.max(-HIGHEST, this.elevation + elevation));
  }

  magnify(factor) {
    this.zoom = Math.min(8, Math.max(0.5, this.zoom * factor));
  }

  // For a picture of so many pixels.
  fit(width, height) {
    const across = (HALF / this.zoom) * Math.max(1, width / height);
    const upwards = (HALF / this.zoom) * Math.max(1, height / width);
    Object.assign(this.three, { left: -across, right: across, top: upwards, bottom: -upwards });
    this.three.updateProjectionMatrix();
    const level = Math.cos(this.elevation);
    this.three.position
      .set(level * Math.cos(this.azimuth), level * Math.sin(this.azimuth), Math.sin(this.elevation))
      .multiplyScalar(DISTANCE);
    this.three.lookAt(0, 0, 0);
  }
}
