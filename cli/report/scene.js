import {
  AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight,
  EdgesGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshStandardMaterial,
  Quaternion, Scene as ThreeScene, Vector3, WebGLRenderer,
} from 'three';
import { Camera } from './camera.js';
import { between, isWithin } from './data.js';
import { Labels } from './labels.js';

const DEGREE = Math.PI / 180;
const NAMES = ['x', 'y', 'z'];
const UP = new Vector3(0, 1, 0);
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const unit = (i) => new Vector3(...[0, 1, 2].map((k) => (k === i ? 1 : 0)));
const vectorAt = (numbers, i) => new Vector3().fromArray(numbers, 3 * i);
const quaternionAt = (numbers, i) => new Quaternion().fromArray(numbers, 4 * i);
const isThere = (v) => !Number.isNaN(v.x);

function circle(axis, angle) {
  const u = new Vector3().crossVectors(axis, Math.abs(axis.z) < 0.9 ? unit(2) : unit(0)).normalize();
  const v = new Vector3().crossVectors(axis, u);
  const points = [];
  for (let i = 0; i <= 96; i++) {
    const a = (2 * Math.PI * i) / 96;
    points.push(
      new Vector3().addScaledVector(axis, Math.cos(angle)).addScaledVector(u, Math.sin(angle) * Math.cos(a))
        .addScaledVector(v, Math.sin(angle) * Math.sin(a)),
    );
  }
  return points;
}

export class Scene {
  // The context is of WebGL 2.
  constructor(host, canvas, context, data) {
    this.data = data;
    this.host = host;
    this.view = 'reference';
    this.world = new ThreeScene();
    this.camera = new Camera();
    this.light = new DirectionalLight(0xffffff, 2);
    this.world.add(new AmbientLight(0xffffff, 1.6), this.light);
    this.renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    this.labels = new Labels(host);
    this.painted = []; // [material, name of its colour]
    this.parts = new Map(); // by name, with whether it is wanted
    this.build();
    this.paint();
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  material(Kind, name, options = {}) {
    const material = new Kind(options);
    this.painted.push([material, name]);
    return material;
  }

  // A part that the list of what is shown names.
  part(name, object) {
    this.parts.set(name, { object, wanted: true });
    this.world.add(object);
    return object;
  }

  arrow(parent, name, colourName, length, radius) {
    const group = new Group();
    const paint = this.material(MeshBasicMaterial, colourName);
    const head = 7 * radius;
    const shaft = new Mesh(new CylinderGeometry(radius, radius, length - head, 12), paint);
    shaft.position.y = (length - head) / 2;
    const tip = new Mesh(new ConeGeometry(2.6 * radius, head, 16), paint);
    tip.position.y = length - head / 2;
    group.add(shaft, tip);
    parent.add(group);
    this.labels.add(name, colourName, group, length);
    return group;
  }

  axes(parent, frame, length, radius, colours) {
    NAMES.forEach((axis, i) => {
      const arrow = this.arrow(parent, `${axis} ${frame}`, colours[i], length, radius);
      arrow.quaternion.setFromUnitVectors(UP, unit(i));
    });
  }

  line(points, name, options) {
    return new Line(new BufferGeometry().setFromPoints(points), this.material(LineBasicMaterial, name, options));
  }

  build() {
    const { data } = this;
    const sphere = this.part('sphere', new Group());
    const grid = (axis, angle) => sphere.add(this.line(circle(axis, angle), '--line'));
    [30, 60, 90, 120, 150].forEach((angle) => grid(unit(2), angle * DEGREE));
    for (let a = 0; a < 180; a += 30) grid(new Vector3(Math.cos(a * DEGREE), Math.sin(a * DEGREE), 0), 90 * DEGREE);
    this.fixed = this.part('axes of the frame it is seen from', new Group());
    this.axes(this.fixed, '', 1, 0.004, ['--mute', '--mute', '--mute']);
    this.fixedLabels = this.labels.all.slice(-3);

    this.body = this.part(data.body, new Group());
    const box = new BoxGeometry(0.34, 0.48, 0.66);
    this.body.add(
      new Mesh(box, this.material(MeshStandardMaterial, '--body', { roughness: 0.8 })),
      new LineSegments(new EdgesGeometry(box), this.material(LineBasicMaterial, '--edge')),
    );
    this.axes(this.body, data.body, 0.8, 0.008, ['--x', '--y', '--z']);
    this.inBody = [];
    for (const { name, quaternion } of data.frames) {
      const group = this.part(name, new Group());
      this.axes(group, name, 0.55, 0.006, ['--x', '--y', '--z']);
      this.inBody.push([group, new Quaternion(...quaternion)]);
    }
    for (const { name, axis } of data.axes) {
      const group = this.part(name, new Group());
      this.arrow(group, name, '--marked', 1, 0.01);
      this.inBody.push([group, new Quaternion().setFromUnitVectors(UP, new Vector3(...axis))]);
    }
    this.directions = data.directions.map(({ name }, i) => {
      const group = this.part(name, new Group());
      this.arrow(group, name, `--d${i % 6}`, 1, 0.008);
      return group;
    });
    if (data.limb) this.limb = this.part('limb of the Earth', this.line(circle(UP, 1), '--earth'));
    this.trailAxes = [...data.axes.map(({ axis }) => new Vector3(...axis)), unit(0), unit(1), unit(2)];
    this.path = this.trailLine(0.5);
    this.past = this.trailLine(1);
    this.follow(0);
  }

  trailLine(opacity) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(6 * this.data.seconds.length), 3));
    const line = new LineSegments(geometry, this.material(LineBasicMaterial, '--marked', { transparent: true, opacity }));
    line.frustumCulled = false;
    this.world.add(line);
    return line;
  }

  paint() {
    for (const [material, name] of this.painted) material.color = new Color(colour(name));
    this.labels.paint(colour);
    this.render();
  }

  want(name, wanted) {
    this.parts.get(name).wanted = wanted;
    this.show(this.t);
  }

  // The quaternion that takes coordinates from the reference to the frame from which the scene is seen.
  viewAt(i) {
    if (this.view === 'reference') return new Quaternion();
    const numbers = this.view === 'body' ? this.data.attitude : this.data.views[+this.view].quaternions;
    const q = quaternionAt(numbers, i);
    return this.view === 'body' ? q.invert() : q;
  }

  seenFrom(view) {
    this.view = view;
    const { body, reference, views } = this.data;
    const name = view === 'body' ? body : view === 'reference' ? reference : views[+view].name;
    this.fixedLabels.forEach((label, i) => label.write(`${NAMES[i]} ${name}`));
    this.drawPath();
    this.show(this.t);
  }

  // Of the axis with this place in the list, or 'none'.
  follow(trail) {
    this.trail = trail;
    this.drawPath();
    this.show(this.t);
  }

  drawPath() {
    const axis = this.trailAxes[this.trail];
    this.path.visible = this.past.visible = Boolean(axis);
    if (!axis) return;
    const numbers = this.path.geometry.attributes.position.array;
    this.drawn = []; // ends of segments up to each sample
    let count = 0;
    let before = new Vector3(NaN);
    for (let i = 0; i < this.data.seconds.length; i++) {
      const point = axis.clone().applyQuaternion(quaternionAt(this.data.attitude, i)).applyQuaternion(this.viewAt(i));
      if (isThere(before) && isThere(point)) {
        before.toArray(numbers, 3 * count);
        point.toArray(numbers, 3 * (count + 1));
        count += 2;
      }
      before = point;
      this.drawn.push(count);
    }
    this.path.geometry.setDrawRange(0, count);
    this.past.geometry.attributes.position.array.set(numbers);
    for (const line of [this.path, this.past]) line.geometry.attributes.position.needsUpdate = true;
  }

  // By the shortest way, unless it is longer than a quarter of a turn: then as at the earlier sample.
  turned(read, { from, to, part }) {
    const a = read(from);
    const b = read(to);
    return a.angleTo(b) > Math.PI / 2 ? a : a.slerp(b, part);
  }

  show(t) {
    if (t === undefined) return;
    this.t = t;
    this.world.visible = isWithin(this.data.seconds, t);
    const at = between(this.data.seconds, t);
    const view = this.turned((i) => this.viewAt(i), at);
    const attitude = this.turned((i) => quaternionAt(this.data.attitude, i), at).premultiply(view);
    this.place(this.body, isThere(attitude) && attitude);
    for (const [group, q] of this.inBody) this.place(group, isThere(attitude) && attitude.clone().multiply(q));
    this.directions.forEach((group, i) => this.aim(group, this.data.directions[i].vectors, at, view));
    if (this.limb) this.placeLimb(at, view);
    for (const name of ['sphere', 'axes of the frame it is seen from']) this.place(this.parts.get(name).object, new Quaternion());
    this.fixed.visible &&= this.view !== 'body';
    this.past.geometry.setDrawRange(0, this.drawn[at.from]);
    this.render();
  }

  // Not there if there is no quaternion, or if it is not wanted.
  place(object, quaternion) {
    object.visible = Boolean(quaternion) && [...this.parts.values()].some((part) => part.object === object && part.wanted);
    if (object.visible) object.quaternion.copy(quaternion);
  }

  aim(group, vectors, { from, to, part }, view) {
    const v = vectorAt(vectors, from).lerp(vectorAt(vectors, to), part).normalize().applyQuaternion(view);
    this.place(group, isThere(v) && new Quaternion().setFromUnitVectors(UP, v));
  }

  placeLimb({ from, to, part }, view) {
    const numbers = this.data.limb;
    const [x, y, z, angle] = [0, 1, 2, 3].map((k) => numbers[4 * from + k] * (1 - part) + numbers[4 * to + k] * part);
    const v = new Vector3(x, y, z).normalize().applyQuaternion(view);
    this.place(this.limb, isThere(v) && !Number.isNaN(angle) && new Quaternion().setFromUnitVectors(UP, v));
    if (this.limb.visible) this.limb.geometry.setFromPoints(circle(UP, angle));
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.render();
  }

  turn(azimuth, elevation) {
    this.camera.turn(azimuth, elevation);
    this.render();
  }

  magnify(factor) {
    this.camera.magnify(factor);
    this.render();
  }

  render() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.camera.fit(width, height);
    this.light.position.copy(this.camera.three.position).add(new Vector3(0, 0, 6));
    this.renderer.render(this.world, this.camera.three);
    this.labels.place(this.camera.three, width, height, this.world.visible);
  }
}
