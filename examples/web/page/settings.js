// What a person chooses before the session; a browser keeps it where it allows that.
const KEY = 'suturing';
const USUAL = { leftHanded: false, standing: false, ports: false, contrast: false };

export class Settings {
  constructor(elementOf, changed) {
    Object.assign(this, USUAL);
    try {
      const kept = JSON.parse(localStorage.getItem(KEY) || '{}');
      for (const name of Object.keys(USUAL)) if (typeof kept[name] === 'boolean') this[name] = kept[name];
    } catch {
      // no storage, or none of ours
    }
    for (const name of Object.keys(USUAL)) {
      const box = elementOf(name);
      box.checked = this[name];
      box.addEventListener('change', () => {
        this[name] = box.checked;
        this.keep();
        changed(name);
      });
    }
  }

  keep() {
    try {
      localStorage.setItem(KEY, JSON.stringify(Object.fromEntries(Object.keys(USUAL).map(name => [name, this[name]]))));
    } catch {
      // as above
    }
  }
}
