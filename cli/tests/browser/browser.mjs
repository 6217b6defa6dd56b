// A Chromium without a window, told what to do by its DevTools protocol over a pipe.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const PATIENCE = 30000; // ms

export class Browser {
  constructor(program, flags = []) {
    this.folder = mkdtempSync(join(tmpdir(), 'vectrix_browser_'));
    this.process = spawn(
      program,
      ['--no-sandbox', '--remote-debugging-pipe', `--user-data-dir=${this.folder}`, '--force-color-profile=srgb', '--hide-scrollbars', ...flags],
      { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] },
    );
    this.waiting = new Map();
    this.pages = new Map();
    this.count = 0;
    let rest = '';
    this.process.stdio[4].setEncoding('utf8').on('data', (text) => {
      const messages = (rest + text).split('\0');
      rest = messages.pop();
      messages.forEach((message) => this.take(JSON.parse(message)));
    });
  }

  take(message) {
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (waiting && message.error) waiting.reject(new Error(`${waiting.method}: ${message.error.message}`));
    else if (waiting) waiting.resolve(message.result);
    else this.pages.get(message.sessionId)?.take(message);
  }

  send(method, params = {}, sessionId = undefined) {
    const id = ++this.count;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => reject(new Error(`${method}: no answer`)), PATIENCE);
      const done = (settle) => (value) => {
        clearTimeout(timer);
        settle(value);
      };
      this.waiting.set(id, { method, resolve: done(resolve), reject: done(reject) });
    });
  }

  async open(url, { width = 1400, height = 900, dark = false } = {}) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    this.pages.set(sessionId, page);
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await page.send(`${domain}.enable`);
    await page.size(width, height);
    await page.media({ dark });
    if (url !== 'about:blank') await page.go(url);
    return page;
  }

  async close() {
    const ended = new Promise((resolve) => this.process.once('exit', resolve));
    await this.send('Browser.close');
    await ended;
    rmSync(this.folder, { recursive: true, force: true });
  }
}

class Page {
  constructor(browser, session, target) {
    Object.assign(this, { browser, session, target, complaints: [], requests: [], expected: [] });
  }

  async go(url) {
    const loaded = this.next('Page.loadEventFired');
    await this.send('Page.navigate', { url });
    await loaded;
  }

  close() {
    return this.browser.send('Target.closeTarget', { targetId: this.target });
  }

  send(method, params) {
    return this.browser.send(method, params, this.session);
  }

  next(method) {
    return new Promise((resolve) => this.expected.push({ method, resolve }));
  }

  take({ method, params }) {
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type))
      this.complaints.push(params.args.map((arg) => arg.value ?? arg.description).join(' '));
    if (method === 'Runtime.exceptionThrown') this.complaints.push(params.exceptionDetails.exception?.description ?? 'exception');
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.complaints.push(params.entry.text);
    if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url);
    const at = this.expected.findIndex((each) => each.method === method);
    if (at >= 0) this.expected.splice(at, 1)[0].resolve(params);
  }

  // The value of an expression in the page.
  async value(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  size(width, height) {
    return this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
  }

  media({ dark = false, print = false }) {
    return this.send('Emulation.setEmulatedMedia', {
      media: print ? 'print' : '',
      features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }],
    });
  }

  scripts(on) {
    return this.send('Emulation.setScriptExecutionDisabled', { value: !on });
  }

  // Where an element is, as its left, top, width and height on the screen.
  async box(selector) {
    return this.value(`(() => {
      const element = document.querySelector(${JSON.stringify(selector)});
      element.scrollIntoView({ block: 'center', behavior: 'instant' });
      const { left, top, width, height } = element.getBoundingClientRect();
      return { left, top, width, height };
    })()`);
  }

  // Parts of the width and of the height of the element.
  async point(selector, right = 0.5, down = 0.5) {
    const { left, top, width, height } = await this.box(selector);
    return { x: left + right * width, y: top + down * height };
  }

  mouse(type, at, more = {}) {
    return this.send('Input.dispatchMouseEvent', { type, ...at, button: 'left', clickCount: 1, ...more });
  }

  async click(selector, right, down) {
    const at = await this.point(selector, right, down);
    await this.mouse('mouseMoved', at, { button: 'none' });
    await this.mouse('mousePressed', at);
    await this.mouse('mouseReleased', at);
  }

  async drag(selector, from, to) {
    const [start, end] = [await this.point(selector, ...from), await this.point(selector, ...to)];
    await this.mouse('mouseMoved', start, { button: 'none' });
    await this.mouse('mousePressed', start);
    await this.mouse('mouseMoved', { x: (start.x + end.x) / 2, y: (start.y + end.y) / 2 });
    await this.mouse('mouseMoved', end);
    await this.mouse('mouseReleased', end);
  }

  async key(key, modifiers = 0) {
    const text = key.length === 1 ? key : undefined;
    const code = { ' ': 32, Tab: 9, Home: 36, End: 35, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 }[key];
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key, text, modifiers, windowsVirtualKeyCode: code });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, modifiers, windowsVirtualKeyCode: code });
  }

  // Of the window, as a PNG.
  async picture() {
    const { data } = await this.send('Page.captureScreenshot', { format: 'png' });
    return Buffer.from(data, 'base64');
  }
}
