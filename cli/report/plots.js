import uPlot from 'uplot';
import { isWithin, place } from './data.js';

const HEIGHT = 220;

const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const curveColour = (i) => () => colour(`--c${i % 8}`);

export function number(x, digits = 6) {
  return String(Number(x.toPrecision(digits))).replace('-', '\u2212');
}

// To six digits; of a curve with an offset, of what it is above that.
function valueText(x, { offset, spread }) {
  if (x == null) return '\u2013';
  const digits = offset && spread ? 6 + Math.ceil(Math.log10(Math.abs(offset) / spread)) : offset ? 15 : 6;
  return number(x, Math.min(15, digits));
}

// The smallest and the largest value that can be seen, and the limits; with a margin.
function valueRange(limits) {
  return (u, low, high) => {
    const all = [low, high, ...limits.map((limit) => limit.value)].filter((x) => x != null);
    if (!all.length) return [-1, 1];
    const from = Math.min(...all);
    const to = Math.max(...all);
    const pad = Math.max(0.05 * (to - from), 1e-10 * Math.abs(to)) || 1e-3;
    return [from - pad, to + pad];
  };
}

// Where the names of lines stand, the lowest line first: just above them, moved so that none covers another.
function textPlaces(lines, top, dot) {
  const places = [];
  for (const line of lines) places.push(Math.min(line - 5 * dot, (places.at(-1) ?? Infinity) - 15 * dot));
  let highest = top + 12 * dot;
  for (let i = places.length - 1; i >= 0; i--) {
    places[i] = Math.max(places[i], highest);
    highest = places[i] + 15 * dot;
  }
  return places;
}

function drawLimits(unordered) {
  const limits = [...unordered].sort((a, b) => a.value - b.value);
  return (u) => {
    const { ctx, bbox } = u;
    const dot = devicePixelRatio;
    const right = bbox.left + bbox.width;
    const lines = limits.map(({ value }) => u.valToPos(value, 'y', true));
    const places = textPlaces(lines, bbox.top, dot);
    ctx.save();
    Object.assign(ctx, { fillStyle: colour('--limit'), textAlign: 'right', lineJoin: 'round' });
    ctx.font = `${12 * dot}px ${getComputedStyle(document.body).fontFamily}`;
    limits.forEach(({ name }, i) => {
      Object.assign(ctx, { strokeStyle: colour('--limit'), lineWidth: dot });
      ctx.setLineDash([6 * dot, 4 * dot]);
      ctx.beginPath();
      ctx.moveTo(bbox.left, lines[i]);
      ctx.lineTo(right, lines[i]);
      ctx.stroke();
      Object.assign(ctx, { strokeStyle: colour('--paper'), lineWidth: 4 * dot });
      ctx.setLineDash([]);
      ctx.strokeText(name, right - 4 * dot, places[i]);
      ctx.fillText(name, right - 4 * dot, places[i]);
    });
    ctx.restore();
  };
}

// A sample between two gaps has no line; it gets a dot.
function lonely(values) {
  const isThere = (i) => values[i] != null;
  return values.flatMap((x, i) => (isThere(i) && !isThere(i - 1) && !isThere(i + 1) ? [i] : []));
}

// One plot in its figure. `zoomed` is called with the first and the last second that are shown.
class Plot {
  constructor(figure, data, { name: unitName, seconds: unit }, { clicked, zoomed }) {
    this.data = data;
    this.unit = unit;
    this.host = figure.querySelector('.live');
    this.outputs = [...figure.querySelectorAll('figcaption output')];
    this.mark = Object.assign(document.createElement('div'), { className: 'mark' });
    figure.classList.add('has-script');
    const dots = data.curves.map((curve) => lonely(curve.values));
    const axis = {
      stroke: () => colour('--mute'),
      font: `12px ${getComputedStyle(document.body).fontFamily}`,
      grid: { stroke: () => colour('--grid'), width: 1 },
      ticks: { show: false },
    };
    this.u = new uPlot(
      {
        width: this.host.clientWidth,
        height: HEIGHT,
        legend: { show: false },
        cursor: { sync: { key: 'time', scales: ['x', null] }, drag: { x: true, y: false }, points: { size: 6 } },
        scales: { x: { time: false }, y: { range: valueRange(data.limits) } },
        axes: [
          { ...axis, size: 26, space: 70, values: (u, ticks) => ticks.map((x) => number(x, 12)), label: `time, ${unitName}`, labelSize: 18, labelFont: axis.font },
          { ...axis, size: 72, values: (u, ticks) => ticks.map((x) => number(x, 12)) },
        ],
        series: [
          {},
          ...data.curves.map((curve, i) => ({
            label: curve.name,
            stroke: curveColour(i),
            width: 1.5,
            pxAlign: 0,
            points: { show: false, filter: () => dots[i], size: 4, fill: curveColour(i) },
          })),
        ],
        hooks: {
          draw: [drawLimits(data.limits)],
          ready: [(u) => u.over.append(this.mark)],
          setCursor: [() => this.write()],
          setScale: [(u, key) => key === 'x' && this.rescaled(zoomed)],
        },
      },
      [Float64Array.from(data.seconds, (t) => t / unit), ...data.curves.map((curve) => curve.values)],
      this.host,
    );
    // uPlot stops the click at the end of a drag.
    this.u.over.addEventListener('click', (event) =>
      clicked(this.u.posToVal(event.clientX - this.u.over.getBoundingClientRect().left, 'x') * unit),
    );
    new ResizeObserver(() => this.fit()).observe(this.host);
  }

  fit() {
    const width = this.host.clientWidth;
    if (width && width !== this.u.width) this.u.setSize({ width, height: HEIGHT });
    this.place();
  }

  rescaled(zoomed) {
    this.place();
    const { min, max } = this.u.scales.x;
    if (min != null) zoomed(min * this.unit, max * this.unit);
  }

  zoom(from, to) {
    const { min, max } = this.u.scales.x;
    if (min !== from / this.unit || max !== to / this.unit)
      this.u.setScale('x', { min: from / this.unit, max: to / this.unit });
  }

  show(t) {
    this.t = t;
    this.place();
    this.write();
  }

  place() {
    if (this.t === undefined || !this.u) return;
    const { min, max } = this.u.scales.x;
    const x = this.t / this.unit;
    this.mark.hidden = !(x >= min && x <= max);
    this.mark.style.left = `${this.u.valToPos(x, 'x')}px`;
  }

  // Of the sample under the cursor, or else of the last one that is not after the time.
  write() {
    if (this.t === undefined) return;
    const { seconds, curves } = this.data;
    const at = this.u?.cursor.idx ?? (isWithin(seconds, this.t) ? place(seconds, this.t) : -1);
    this.outputs.forEach((output, i) => (output.value = valueText(curves[i].values[at], curves[i])));
  }
}

export class Plots {
  constructor(figures, data, clicked) {
    this.whole = [data.first, data.last > data.first ? data.last : data.first + data.unit.seconds];
    const hooks = { clicked, zoomed: (from, to) => this.zoom(from, to) };
    this.all = data.plots.map((plot, i) => new Plot(figures[i], plot, data.unit, hooks));
    this.zoom(...this.whole);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () =>
      this.all.forEach(({ u }) => u.redraw(false)),
    );
  }

  show(t) {
    this.all.forEach((plot) => plot.show(t));
  }

  // All plots show the same time, which stays within the whole one.
  zoom(from, to) {
    if (this.zooming) return;
    this.zooming = true;
    this.shown = [Math.max(from, this.whole[0]), Math.min(to, this.whole[1])];
    this.all.forEach((plot) => plot.zoom(...this.shown));
    this.zooming = false;
  }

  // The first and the last second that each plot shows.
  get ranges() {
    return this.all.map(({ u, unit }) => [u.scales.x.min * unit, u.scales.x.max * unit]);
  }

  zoomBy(factor, t) {
    const [from, to] = this.shown;
    const about = Math.min(to, Math.max(from, t));
    this.zoom(about + (from - about) * factor, about + (to - about) * factor);
  }

  unzoom() {
    this.zoom(...this.whole);
  }
}
