import { Vector3 } from 'three';

const GAP = 8; // pixels from the tip of an arrow
const STEP = 3;
const MARGIN = 4; // between two names, to the sides

const overlap = (a, b) => a.left < b.right + MARGIN && b.left < a.right + MARGIN && a.top < b.bottom && b.top < a.bottom;

// The names at the tips of arrows: HTML above the canvas, moved down until none covers another.
export class Labels {
  constructor(host) {
    this.host = host;
    this.all = [];
  }

  // The arrow points along y of the group.
  add(text, colourName, group, length) {
    const element = Object.assign(document.createElement('span'), { className: 'label', textContent: text });
    this.host.append(element);
    const label = { element, colourName, group, length };
    label.write = (words) => {
      element.textContent = words;
      label.width = 0;
    };
    this.all.push(label);
  }

  paint(colour) {
    for (const { element, colourName } of this.all) element.style.color = colour(colourName);
  }

  place(camera, width, height, wanted) {
    const tips = [];
    for (const label of this.all) {
      const seen = wanted && label.group.visible && label.group.parent.visible;
      label.element.hidden = !seen;
      if (seen) tips.push(this.tip(label, camera, width, height));
    }
    tips.sort((a, b) => a.top - b.top);
    const placed = [];
    for (const box of tips) {
      while (placed.some((other) => overlap(box, other))) {
        box.top += STEP;
        box.bottom += STEP;
      }
      placed.push(box);
      box.label.element.style.transform = `translate(${box.left}px, ${box.top}px)`;
    }
  }

  tip(label, camera, width, height) {
    label.width ||= label.element.offsetWidth;
    label.height ||= label.element.offsetHeight;
    label.group.updateWorldMatrix(true, false);
    const at = new Vector3(0, label.length, 0).applyMatrix4(label.group.matrixWorld).project(camera);
    const x = 0.5 * width * at.x;
    const y = -0.5 * height * at.y;
    const far = GAP / Math.max(GAP, Math.hypot(x, y));
    const wanted = 0.5 * width + x * (1 + far) - (x < 0 ? label.width : 0);
    const left = Math.max(MARGIN, Math.min(wanted, width - label.width - MARGIN));
    const top = 0.5 * height + y * (1 + far) - 0.5 * label.height;
    return { label, left, top, right: left + label.width, bottom: top + label.height };
  }
}
