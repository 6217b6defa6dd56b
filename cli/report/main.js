import { between, isWithin, read } from './data.js';
import { number, Plots } from './plots.js';
import { Scene } from './scene.js';

const SPEEDS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000];
const WATCHED = 60; // seconds that the whole time takes, about

const byId = (id) => document.getElementById(id);
const data = read(byId('data').textContent);

class Player {
  constructor(show) {
    this.show = show;
    this.span = data.last - data.first;
    this.playing = false;
    this.speed = SPEEDS.find((speed) => speed * WATCHED >= this.span) ?? SPEEDS.at(-1);
    this.button = byId('play');
    this.slider = byId('time');
    Object.assign(this.slider, { min: data.first, max: data.last, step: this.span / 1000 || 1 });
    byId('speed').append(...SPEEDS.map((speed) => new Option(`${speed}\u00d7`, speed, speed === this.speed, speed === this.speed)));
    byId('speed').addEventListener('change', (event) => (this.speed = Number(event.target.value)));
    this.button.addEventListener('click', () => this.toggle());
    this.slider.addEventListener('input', () => this.go(Number(this.slider.value)));
    this.go(data.scene ? data.scene.seconds[0] : data.first);
  }

  go(t) {
    this.t = Math.min(data.last, Math.max(data.first, t));
    this.slider.value = this.t;
    byId('clock').value = this.text();
    this.slider.setAttribute('aria-valuetext', byId('clock').value);
    this.show(this.t);
  }

  text() {
    const passed = `${number(this.t / data.unit.seconds, 5)} ${data.unit.name}`;
    if (data.utc === null) return passed;
    return `${new Date(Date.parse(data.utc) + 1000 * this.t).toISOString().replace(/\.(\d).*/, '.$1')} UTC \u00b7 ${passed}`;
  }

  toggle() {
    this.playing = !this.playing;
    this.button.textContent = this.playing ? 'Pause' : 'Play';
    if (!this.playing) return;
    if (this.t >= data.last) this.go(data.first);
    this.before = undefined;
    requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    if (!this.playing) return;
    if (this.before !== undefined) this.go(this.t + ((now - this.before) / 1000) * this.speed);
    this.before = now;
    if (this.t >= data.last) this.toggle();
    else requestAnimationFrame((next) => this.tick(next));
  }
}

// The three-dimensional view, or nothing where WebGL is off: then the drawing stays.
function sceneOf(host) {
  if (!data.scene) return null;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true });
  if (!context) return null;
  byId('scene').classList.add('has-script');
  host.hidden = false;
  host.append(canvas);
  const scene = new Scene(host, canvas, context, data.scene);
  canvas.addEventListener('webglcontextlost', () => {
    byId('scene').classList.remove('has-script');
    host.hidden = true;
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => scene.paint());
  return scene;
}

function offerParts(scene) {
  const list = byId('shown');
  list.hidden = false;
  for (const name of scene.parts.keys()) {
    const box = Object.assign(document.createElement('input'), { type: 'checkbox', checked: true });
    box.addEventListener('change', () => scene.want(name, box.checked));
    const label = document.createElement('label');
    label.append(box, ` ${name}`);
    list.append(label);
  }
}

function takeMouse(host, scene) {
  let from = null;
  host.addEventListener('pointerdown', (event) => {
    from = event;
    host.setPointerCapture(event.pointerId);
  });
  host.addEventListener('pointermove', (event) => {
    if (!from) return;
    scene.turn((from.clientX - event.clientX) / 150, (event.clientY - from.clientY) / 150);
    from = event;
  });
  host.addEventListener('pointerup', () => (from = null));
  host.addEventListener('wheel', (event) => {
    if (document.activeElement !== host) return; // the page scrolls
    event.preventDefault();
    scene.magnify(Math.exp(-event.deltaY / 500));
  }, { passive: false });
}

const TURN = Math.PI / 36;

// Whether the key was one of the view.
function viewKey(key, scene) {
  const turns = { ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN] };
  if (turns[key]) scene.turn(...turns[key]);
  else if (key === '+' || key === '=') scene.magnify(1.2);
  else if (key === '-') scene.magnify(1 / 1.2);
  else return false;
  return true;
}

function timeKey(event, player, plots) {
  const step = ((event.shiftKey ? 10 : 1) * player.span) / 100;
  const actions = {
    ' ': () => player.toggle(),
    ArrowRight: () => player.go(player.t + step),
    ArrowLeft: () => player.go(player.t - step),
    Home: () => player.go(data.first),
    End: () => player.go(data.last),
    '+': () => plots.zoomBy(0.5, player.t),
    '=': () => plots.zoomBy(0.5, player.t),
    '-': () => plots.zoomBy(2, player.t),
    0: () => plots.unzoom(),
  };
  actions[event.key]?.();
  return event.key in actions;
}

// What has the focus keeps the keys that it takes itself.
function takesKey(target, key) {
  if (target.matches('select')) return true;
  if (target.matches('button, summary, input[type=checkbox]')) return key === ' ';
  return target.matches('input[type=range]') && key !== ' ' && !'+-=0'.includes(key);
}

function takeKeys(host, scene, player, plots) {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || takesKey(event.target, event.key)) return;
    const done = (scene && event.target === host && viewKey(event.key, scene)) || timeKey(event, player, plots);
    if (done) event.preventDefault();
  });
}

// Moves the place on the map of the ground track.
function groundTrack() {
  const place = document.querySelector('.track .place');
  if (!place) return () => {};
  const [left, right, bottom, top] = place.dataset.edges.split(' ').map(Number);
  const { seconds, track } = data.scene;
  return (t) => {
    const { from, to, part } = between(seconds, t);
    const near = part < 0.5 ? from : to;
    const [latitude, longitude] = [track[2 * near], track[2 * near + 1]];
    const isPlace = (i) => !Number.isNaN(track[2 * i]);
    const isThere = isWithin(seconds, t) && isPlace(from) && (part === 0 || isPlace(to));
    place.setAttribute('visibility', isThere ? 'visible' : 'hidden');
    if (!isThere) return;
    place.setAttribute('cx', left + ((longitude + 180) / 360) * (right - left));
    place.setAttribute('cy', bottom + ((latitude + 90) / 180) * (top - bottom));
  };
}

function start() {
  const host = byId('canvas');
  const scene = sceneOf(host);
  byId('controls').hidden = byId('keys').hidden = false;
  const moved = groundTrack();
  let player;
  const plots = new Plots(document.querySelectorAll('figure.plot'), data, (t) => player.go(t));
  player = new Player((t) => {
    scene?.show(t);
    plots.show(t);
    moved(t);
  });
  if (scene) {
    offerParts(scene);
    takeMouse(host, scene);
    byId('view').addEventListener('change', (event) => scene.seenFrom(event.target.value));
    byId('trail').addEventListener('change', (event) => scene.follow(event.target.value === 'none' ? 'none' : event.target.selectedIndex));
    scene.seenFrom('reference');
  } else if (data.scene) {
    byId('view').disabled = byId('trail').disabled = true;
  }
  takeKeys(host, scene, player, plots);
  // For tests: what the page shows.
  window.vectrix_report = {
    get time() { return player.t; },
    get playing() { return player.playing; },
    get shown() { return plots.ranges; },
    get view() { return scene ? scene.view : null; },
    plots: data.plots,
  };
}

if (data) start();
