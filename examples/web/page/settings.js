// What a person chooses; a browser keeps it where it allows that.
import { LENGTH, PITCH } from './tool_offset.js';

const KEY = 'suturing';
const CHOICES = { leftHanded: false, standing: false, ports: false, contrast: false };
const NUMBERS = { leftLength: LENGTH, leftPitch: PITCH, rightLength: LENGTH, rightPitch: PITCH };

export class Settings {
  constructor(elementOf, changed) {
    this.elementOf = elementOf;
    this.changed = changed;
    Object.assign(this, CHOICES);
    for (const [name, range] of Object.entries(NUMBERS)) this[name] = range.usual;
    this.read();
    for (const name of Object.keys(CHOICES)) this.listenToChoice(name);
    for (const name of Object.keys(NUMBERS)) this.listenToNumber(name);
  }

  read() {
    try {
      const kept = JSON.parse(localStorage.getItem(KEY) || '{}');
      for (const name of Object.keys(CHOICES)) if (typeof kept[name] === 'boolean') this[name] = kept[name];
      for (const name of Object.keys(NUMBERS)) if (Number.isFinite(kept[name])) this[name] = this.within(name, kept[name]);
    } catch {
      // no storage, or none of ours
    }
  }

  listenToChoice(name) {
    const box = this.elementOf(name);
    box.checked = this[name];
    box.addEventListener('change', () => {
      this[name] = box.checked;
      this.keep();
      this.changed(name);
    });
  }

  listenToNumber(name) {
    const box = this.elementOf(name);
    Object.assign(box, { min: NUMBERS[name].least, max: NUMBERS[name].most });
    box.value = this[name].toFixed(0);
    box.addEventListener('change', () => {
      this.put(name, box.value === '' ? NUMBERS[name].usual : Number(box.value));
      this.keep();
    });
  }

  within(name, value) {
    return Math.min(Math.max(value, NUMBERS[name].least), NUMBERS[name].most);
  }

  // A number, from wherever it is adjusted; keep() follows the last one.
  put(name, value) {
    this[name] = this.within(name, value);
    this.elementOf(name).value = this[name].toFixed(0);
  }

  keep() {
    try {
      localStorage.setItem(KEY, JSON.stringify(Object.fromEntries(Object.keys({ ...CHOICES, ...NUMBERS }).map(name => [name, this[name]]))));
    } catch {
      // as above
    }
  }
}
