// The data of the page: what cli/src/report/data.cpp has written.

function bytes(text) {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
}
const singles = (text) => new Float32Array(bytes(text));
const doubles = (text) => new Float64Array(bytes(text));

// NaN becomes null, as a gap is for uPlot. `spread` is how far the values are from the offset at most.
function curve({ name, offset, values }) {
  const less = singles(values);
  const spread = less.reduce((most, x) => (Math.abs(x) > most ? Math.abs(x) : most), 0);
  return { name, offset, spread, values: Array.from(less, (x) => (Number.isNaN(x) ? null : x + offset)) };
}

function scene(data) {
  if (!data) return null;
  return {
    ...data,
    seconds: doubles(data.seconds),
    attitude: singles(data.attitude),
    directions: data.directions.map((each) => ({ name: each.name, vectors: singles(each.vectors) })),
    views: data.views.map((each) => ({ name: each.name, quaternions: singles(each.quaternions) })),
    limb: data.limb && singles(data.limb),
    track: data.track && singles(data.track),
  };
}

export function read(text) {
  const data = JSON.parse(text);
  if (!data) return null;
  const plots = data.plots.map((plot) => ({
    ...plot,
    seconds: doubles(plot.seconds),
    curves: plot.curves.map(curve),
  }));
  return { ...data, plots, scene: scene(data.scene) };
}

// The place of the last time that is not after t, or of the first one.
export function place(seconds, t) {
  let low = 0;
  let high = seconds.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (seconds[middle] <= t) low = middle;
    else high = middle;
  }
  return low;
}

export function isWithin(seconds, t) {
  return t >= seconds[0] && t <= seconds[seconds.length - 1];
}

// Between which two samples t is, and how far from the first to the second.
export function between(seconds, t) {
  const from = place(seconds, t);
  const to = Math.min(from + 1, seconds.length - 1);
  const part = to > from ? (t - seconds[from]) / (seconds[to] - seconds[from]) : 0;
  return { from, to, part: Math.min(1, Math.max(0, part)) };
}
