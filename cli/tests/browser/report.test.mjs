// The report in a browser. ./dev report runs it, with VECTRIX_BROWSER, VECTRIX_REPORT_SAMPLE, VECTRIX_SOURCE and, to write
// the pictures of the docs, VECTRIX_PICTURES.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Browser } from './browser.mjs';

const { VECTRIX_BROWSER: program, VECTRIX_REPORT_SAMPLE: sample, VECTRIX_SOURCE: source, VECTRIX_PICTURES: pictures } = process.env;
const SOFTWARE_WEBGL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const SHIFT = 8;
const SPAN = 7180; // s, of the cubesat: 719 rows, 10 s apart
const ROUNDING = 1e-9;

let folder;
let browser;
const url = (name) => `file://${join(folder, name)}.html`;
const state = (page, key) => page.value(`vectrix_report.${key}`);
const frame = (page) => page.value('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))');
const near = (a, b, tolerance, words) => assert.ok(Math.abs(a - b) <= tolerance, `${words ?? ''} ${a} is not ${b} within ${tolerance}`);

// Whether all plots show the time from..to.
async function shows(page, from, to, tolerance) {
  const ranges = await state(page, 'shown');
  assert.equal(ranges.length, 4);
  for (const range of ranges) {
    near(range[0], from, tolerance);
    near(range[1], to, tolerance);
  }
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'vectrix_report_'));
  for (const name of ['cubesat', 'long', 'hostile']) execFileSync(sample, [name, join(folder, `${name}.html`)]);
  browser = new Browser(program, SOFTWARE_WEBGL);
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

// Runs with a new page, which must not complain, nor ask for anything but itself.
async function withPage(name, options, use, by = browser) {
  const page = await by.open(url(name), options);
  await use(page);
  assert.deepEqual(page.complaints, []);
  assert.deepEqual(page.requests, [url(name)]);
  await page.close();
}

// Where a label of the view is, from the middle of the view.
async function label(page, text) {
  const [x, y] = await page.value(`(() => {
    const host = document.getElementById('canvas').getBoundingClientRect();
    const label = [...document.querySelectorAll('.label')].find((each) => each.textContent === ${JSON.stringify(text)} && !each.hidden);
    const box = label.getBoundingClientRect();
    return [box.left + box.width / 2 - host.left - host.width / 2, box.top + box.height / 2 - host.top - host.height / 2];
  })()`);
  return { x, y };
}

const choose = (page, id, text) => page.value(`(() => {
  const select = document.getElementById('${id}');
  select.selectedIndex = [...select.options].findIndex((option) => option.text === ${JSON.stringify(text)});
  select.dispatchEvent(new Event('change'));
})()`);

// How many pixels of a plot have about the colour of a variable of the style, by columns and by rows.
const coloured = (page, variable, { top = 1, plot = 0 } = {}) => page.value(`(() => {
  const figure = document.querySelectorAll('.plot')[${plot}];
  const canvas = figure.querySelector('canvas');
  const over = figure.querySelector('.u-over');
  const [left, width] = [over.offsetLeft, over.offsetWidth];
  const probe = document.body.appendChild(Object.assign(document.createElement('i'), { style: 'color: var(${variable})' }));
  const wanted = getComputedStyle(probe).color.match(/\\d+/g).map(Number);
  probe.remove();
  const height = Math.round(over.offsetHeight * ${top});
  const { data } = canvas.getContext('2d').getImageData(left, over.offsetTop, width, height);
  const columns = Array(width).fill(0);
  const rows = Array(over.offsetHeight).fill(0);
  for (let i = 0; i < data.length; i += 4)
    if (data[i + 3] > 60 && wanted.every((c, k) => Math.abs(data[i + k] - c) < 40)) {
      columns[(i / 4) % width]++;
      rows[Math.floor(i / 4 / width)]++;
    }
  return { columns, rows };
})()`);

test('the plots hold the published numbers, in their order and at their times', () =>
  withPage('cubesat', {}, async (page) => {
    const rows = readFileSync(join(source, 'examples/data/CTIM_20230420_pointing.csv'), 'utf8')
      .split('\n').filter((line) => /^\d/.test(line)).map((line) => line.split(','));
    const [plot, , , height] = JSON.parse(await page.value('JSON.stringify(vectrix_report.plots.map((p) => ({ seconds: [...p.seconds], curves: p.curves })))'));
    const published = plot.curves.find((curve) => curve.name === 'published');
    const single = 2 ** -24 * 180; // half a unit of the last place of an angle, deg
    assert.equal(plot.seconds.length, rows.length);
    rows.forEach((row, i) => {
      near(plot.seconds[i], (row[0] - rows[0][0]) / 1e6, 1e-6);
      near(published.values[i], (Math.acos(row[3]) * 180) / Math.PI, single);
    });
    // Of a semi-major axis of 6830 km and an eccentricity of 0.0014 over the radii of the Earth, 6357 to 6378 km.
    assert.ok(height.curves[0].values.every((km) => km > 440 && km < 483));
  }));

test('a click plays, another one pauses, and playing ends at the end', () =>
  withPage('cubesat', {}, async (page) => {
    assert.equal(await state(page, 'time'), 0);
    const start = await label(page, 'y Body');
    await page.click('#play');
    assert.equal(await state(page, 'playing'), true);
    await page.value('new Promise((done) => setTimeout(done, 600))');
    await page.click('#play');
    const time = await state(page, 'time');
    assert.equal(await state(page, 'playing'), false);
    assert.ok(time > 0, 'the time moves');
    assert.notDeepEqual(await label(page, 'y Body'), start);
    await frame(page);
    assert.equal(await state(page, 'time'), time);
    await page.key('End');
    await page.key('ArrowLeft');
    await choose(page, 'speed', '10000\u00d7');
    await page.click('#play');
    for (let i = 0; i < 100 && (await state(page, 'playing')); i++) await frame(page);
    assert.equal(await state(page, 'playing'), false);
    near(await state(page, 'time'), SPAN, ROUNDING);
  }));

test('a click in a plot goes to its time, and the numbers there are written', () =>
  withPage('cubesat', {}, async (page) => {
    await page.click('.plot .u-over', 0.25);
    const width = (await page.box('.plot .u-over')).width;
    const time = await state(page, 'time');
    near(time, 0.25 * SPAN, (2 / width) * SPAN, 'time');
    await page.mouse('mouseMoved', { x: 1, y: 1 }, { button: 'none' });
    const expected = await page.value(`vectrix_report.plots.flatMap((p) => {
      const at = p.seconds.findLastIndex((t) => t <= ${time});
      return p.curves.map((curve) => curve.values[at]);
    })`);
    const written = await page.value("[...document.querySelectorAll('.plot output')].map((o) => o.value.replace('\\u2212', '-'))");
    assert.equal(written.length, 7);
    written.forEach((text, i) => near(Number(text), expected[i], 1e-5 * Math.abs(expected[i])));
    const marks = await page.value("[...document.querySelectorAll('.mark')].map((m) => parseFloat(m.style.left))");
    marks.forEach((left) => near(left, (time / SPAN) * width, 1, 'mark'));
    // The place on the map has moved along the track.
    const [moved, aside] = await page.value(`(() => {
      const { cx: { baseVal: { value: x } }, cy: { baseVal: { value: y } } } = document.querySelector('.track .place');
      const points = [...document.querySelectorAll('.track polyline')].flatMap((line) => [...line.points]);
      const distances = points.map((point) => Math.hypot(point.x - x, point.y - y));
      return [distances[0], Math.min(...distances)];
    })()`);
    assert.ok(moved > 50 && aside < 2, `the place is ${moved} from the start, ${aside} beside the track`);
  }));

test('a drag zooms all plots, a double click shows all', () =>
  withPage('cubesat', {}, async (page) => {
    await page.drag('.plot .u-over', [0.2, 0.5], [0.4, 0.5]);
    await frame(page);
    await shows(page, 0.2 * SPAN, 0.4 * SPAN, 0.01 * SPAN);
    assert.equal(await state(page, 'time'), 0); // a drag is no click
    assert.equal(await page.value("[...document.querySelectorAll('.mark')].every((m) => m.hidden)"), true);
    const at = await page.point('.plot:nth-of-type(2) .u-over', 0.5);
    for (const clickCount of [1, 2]) {
      await page.mouse('mousePressed', at, { clickCount });
      await page.mouse('mouseReleased', at, { clickCount });
    }
    await frame(page);
    await shows(page, 0, SPAN, ROUNDING);
  }));

test('everything goes by keyboard, and shows where it is', () =>
  withPage('cubesat', {}, async (page) => {
    await page.key('ArrowRight');
    near(await state(page, 'time'), SPAN / 100, 1e-6);
    await page.key('ArrowRight', SHIFT);
    near(await state(page, 'time'), (11 * SPAN) / 100, 1e-6);
    await page.key('+');
    await frame(page);
    await shows(page, 0.055 * SPAN, 0.555 * SPAN, ROUNDING); // about 0.11
    await page.key('0');
    await frame(page);
    await shows(page, 0, SPAN, ROUNDING);
    await page.key('Home');
    await page.key(' ');
    assert.equal(await state(page, 'playing'), true);
    await page.key(' ');
    assert.equal(await state(page, 'playing'), false);
    const reached = [];
    for (let i = 0; i < 12; i++) {
      await page.key('Tab');
      reached.push(await page.value('document.activeElement.id || document.activeElement.tagName'));
      const seen = await page.value("document.activeElement === document.body || getComputedStyle(document.activeElement).outlineStyle === 'solid'");
      assert.ok(seen, `the focus is seen on ${reached.at(-1)}`);
    }
    for (const id of ['play', 'time', 'speed', 'view', 'trail', 'canvas']) assert.ok(reached.includes(id), `${id} is reached`);
    await page.value("document.getElementById('play').focus()");
    await page.key(' '); // once, not twice
    assert.equal(await state(page, 'playing'), true);
    await page.key(' ');
    await page.value("document.querySelector('#keys summary').focus()");
    await page.key(' '); // is of the summary
    assert.equal(await state(page, 'playing'), false);
    assert.equal(await page.value("document.getElementById('keys').open"), true);
    await page.key('Home');
    await page.value("document.getElementById('canvas').focus()");
    const before = await label(page, 'x GCRF');
    await page.key('ArrowRight');
    assert.notDeepEqual(await label(page, 'x GCRF'), before);
    assert.equal(await state(page, 'time'), 0);
  }));

test('seen from LVLH the Earth is along z, seen from the body the body rests', () =>
  withPage('cubesat', {}, async (page) => {
    const beside = 60; // pixels: names stand beside and below each other, where the radius is 197
    await choose(page, 'view', 'LVLH');
    for (let i = 0; i < 3; i++) {
      for (let k = 0; k < 17; k++) await page.key('ArrowRight');
      const [earth, z] = [await label(page, 'Earth'), await label(page, 'z LVLH')];
      near(earth.x, z.x, beside, 'x');
      near(earth.y, z.y, beside, 'y');
    }
    await choose(page, 'view', 'Body');
    const [sun, axis] = [await label(page, 'Sun'), await label(page, 'x Body')];
    await page.key('Home');
    const [moved, still] = [await label(page, 'Sun'), await label(page, 'x Body')];
    assert.ok(Math.hypot(still.x - axis.x, still.y - axis.y) < beside);
    assert.ok(Math.hypot(moved.x - sun.x, moved.y - sun.y) > beside);
  }));

test('no name of the view covers another', () =>
  withPage('cubesat', {}, async (page) => {
    for (let i = 0; i < 20; i++) {
      const boxes = await page.value(`[...document.querySelectorAll('.label')].filter((l) => !l.hidden)
        .map((l) => { const { left, right, top, bottom } = l.getBoundingClientRect(); return [left, right, top, bottom]; })`);
      assert.ok(boxes.length > 10);
      boxes.forEach((a, i) => boxes.slice(0, i).forEach((b) =>
        assert.ok(a[0] >= b[1] || b[0] >= a[1] || a[2] >= b[3] - 0.01 || b[2] >= a[3] - 0.01, `${a} covers ${b}`)));
      for (let k = 0; k < 5; k++) await page.key('ArrowRight');
    }
  }));

test('what is not wanted is not shown', () =>
  withPage('cubesat', {}, async (page) => {
    const shown = () => page.value("[...document.querySelectorAll('.label')].some((l) => l.textContent === 'Sun' && !l.hidden)");
    const box = "[...document.querySelectorAll('#shown label')].find((l) => l.textContent.trim() === 'Sun').click()";
    assert.equal(await shown(), true);
    await page.value(box);
    assert.equal(await shown(), false);
    await page.key('ArrowRight');
    assert.equal(await shown(), false);
    await page.value(box);
    assert.equal(await shown(), true);
  }));

test('in dark mode the page and the plots are dark, also when it changes', () =>
  withPage('cubesat', { dark: true }, async (page) => {
    const paper = () => page.value("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)");
    const drawn = async () => (await coloured(page, '--c0', { plot: 1 })).columns.filter(Boolean).length;
    assert.ok(Math.max(...(await paper())) < 40);
    const many = 500; // of the columns, more than 600, have a bit of the curve
    assert.ok((await drawn()) > many);
    await page.media({ dark: false });
    await frame(page);
    assert.deepEqual(await paper(), [255, 255, 255]);
    assert.ok((await drawn()) > many);
  }));

test('on paper there are drawings, and no controls', () =>
  withPage('cubesat', {}, async (page) => {
    await page.media({ print: true });
    const displays = await page.value(`['#controls', '#canvas', '.plot .live', '#scene > svg', '.plot > svg']
      .map((name) => getComputedStyle(document.querySelector(name)).display)`);
    assert.deepEqual(displays, ['none', 'none', 'none', 'block', 'block']);
    const { data } = await page.send('Page.printToPDF', { printBackground: false });
    assert.ok(Buffer.from(data, 'base64').toString('latin1', 0, 5) === '%PDF-');
  }));

test('where WebGL is off there is a drawing, and the rest works', async () => {
  const without = new Browser(program, ['--disable-3d-apis']);
  const plain = async (page) => {
    assert.equal(await state(page, 'view'), null);
    assert.equal(await page.value("getComputedStyle(document.querySelector('#scene > svg')).display"), 'block');
    await page.click('#play');
    await page.value('new Promise((done) => setTimeout(done, 200))');
    assert.ok((await state(page, 'time')) > 0);
  };
  await withPage('cubesat', {}, plain, without).finally(() => without.close());
});

test('without scripts the page is complete', async () => {
  const page = await browser.open('about:blank');
  await page.scripts(false);
  await page.go(url('cubesat'));
  const { root } = await page.send('DOM.getDocument', { depth: 0 });
  const shown = async (selector) => {
    const { nodeId } = await page.send('DOM.querySelector', { nodeId: root.nodeId, selector });
    return page.send('DOM.getBoxModel', { nodeId }).then(({ model }) => model.height > 0, () => false);
  };
  for (const selector of ['.verdicts', '.plot > svg', '#scene > svg', '.track']) assert.equal(await shown(selector), true, selector);
  for (const selector of ['#controls', '#canvas', '#keys']) assert.equal(await shown(selector), false, selector);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('names that end a script are only names', () =>
  withPage('hostile', {}, async (page) => {
    const name = '</script><script>document.title = \'taken\'</script><!-- & "';
    assert.equal(await page.value('document.title'), name);
    assert.equal(await page.value("document.querySelector('h1').textContent"), name);
    assert.equal(await page.value("document.querySelector('.verdicts td:nth-child(2)').textContent"), name);
    assert.equal(await page.value('vectrix_report.plots[0].title'), name);
    assert.equal(await page.value("document.querySelectorAll('script').length"), 2);
  }));

test('outside its times a motion is not shown, nor a value', () =>
  withPage('hostile', {}, async (page) => {
    const shown = () => page.value("[...document.querySelectorAll('.label')].some((label) => !label.hidden)");
    const value = () => page.value("document.querySelector('.plot output').value");
    assert.equal(await state(page, 'time'), 0); // the first time of the scene
    assert.equal(await shown(), true);
    assert.equal(await value(), '1');
    await page.key('Home');
    assert.equal(await state(page, 'time'), -1);
    assert.equal(await shown(), false);
    assert.equal(await value(), '\u2013');
  }));

test('in a gap of the attitude no body is drawn, however long the run', () =>
  withPage('long', {}, async (page) => {
    const shown = () => page.value("[...document.querySelectorAll('.label')].some((label) => !label.hidden && label.textContent === 'x Body')");
    const goTo = async (time) => {
      await page.key('0');
      for (const width of [100000, 2000, 100]) {
        const range = () => page.value('vectrix_report.shown[0]');
        let [from, to] = await range();
        for (; to - from > width; [from, to] = await range()) await page.key('+'); // about the time of the view
        await page.click('.plot .u-over', (time - from) / (to - from));
      }
      near(await state(page, 'time'), time, 0.5);
    };
    await goTo(29900);
    assert.equal(await shown(), true);
    await goTo(30000);
    assert.equal(await shown(), false);
    await goTo(30100);
    assert.equal(await shown(), true);
  }));

test('a sample between gaps is a dot at its place, and a limit a line at its value', () =>
  withPage('hostile', {}, async (page) => {
    const filled = (counts) => counts.flatMap((count, i) => (count ? [i] : []));
    const dot = await coloured(page, '--c0');
    const { width, height } = await page.box('.plot .u-over');
    const columns = filled(dot.columns);
    assert.ok(columns.length >= 2 && columns.length <= 6, `columns ${columns}`);
    columns.forEach((column) => near(column, width / 2, 4));
    // The sample is 1 and the limit 0, with a margin of 5 % of that.
    filled(dot.rows).forEach((row) => near(row, (height * 0.05) / 1.1, 4));
    const limit = (await coloured(page, '--limit')).rows;
    near(limit.indexOf(Math.max(...limit)), (height * 1.05) / 1.1, 1.5);
  }));

test('a million samples: below 5 MB, the extreme is drawn at its place, the gap is empty, and it is smooth', () =>
  withPage('long', {}, async (page) => {
    assert.ok(statSync(join(folder, 'long.html')).size < 5e6);
    const { columns } = await coloured(page, '--c0', { top: 0.45 }); // above all of the curve but its extreme
    const at = columns.flatMap((count, i) => (count ? [i] : []));
    assert.ok(at.length > 0 && at.at(-1) - at[0] <= 3, `one extreme: ${at}`);
    near(at[0] / columns.length, 0.654321, 0.005);
    await page.key('0');
    const gap = await page.value('vectrix_report.plots[0].seconds.findIndex((t, i) => vectrix_report.plots[0].curves[0].values[i] === null)');
    near(await page.value(`vectrix_report.plots[0].seconds[${gap}]`), 30000, 20);
    const took = await page.value(`(async () => {
      const press = (key) => document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
      const took = [];
      for (const key of ['+', '+', '-', '-', '+', '0', 'ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowRight']) {
        const start = performance.now();
        press(key);
        await Promise.resolve().then(() => {}); // uPlot draws at the end of the task
        took.push(performance.now() - start);
      }
      return took.sort((a, b) => a - b)[5];
    })()`);
    assert.ok(took < 100, `a step takes ${took} ms`); // ten a second, also on a slow machine without a GPU
  }));

// Down to the end of the third plot.
test('the pictures of the docs', { skip: !pictures }, async () => {
  for (const dark of [false, true])
    await withPage('cubesat', { width: 1280, height: 1000, dark }, async (page) => {
      for (let i = 0; i < 29; i++) await page.key('ArrowRight');
      await page.size(1280, await page.value("Math.ceil(document.querySelectorAll('.plot')[2].getBoundingClientRect().bottom + scrollY)"));
      await frame(page);
      writeFileSync(join(pictures, dark ? 'report_dark.png' : 'report.png'), await page.picture());
    });
});
