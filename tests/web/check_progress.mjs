// Progress in the page: outcomes are counted, and what is kept and is not ours stays as it is.
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';

const { Progress, addOutcome, readProgress } = await import(pathToFileURL(process.argv[2]));

const outcomes = [[false, false, 5], [true, true, 6], [true, false, 9], [true, false, 7.5]];
const rows = outcomes.reduce((all, [passed, aided, time]) => addOutcome(all, { name: 'cut', passed, aided, time }), {});
assert.deepEqual(rows, { cut: { attempts: 4, passed: 3, unaided: 2, best: 7.5 } });

assert.deepEqual(readProgress(null), {});
assert.deepEqual(readProgress(JSON.stringify(rows)), rows);
for (const text of ['a letter', '[]', '3', 'null', '{"cut":1}', '{"cut":null}', '{"cut":{"attempts":1,"passed":2,"unaided":0,"best":0}}',
  '{"cut":{"attempts":1.5,"passed":1,"unaided":0,"best":0}}']) {
  assert.equal(readProgress(text), null, text);
}

class Storage {
  constructor(text) { this.text = text; }
  getItem() { return this.text; }
  setItem(_, text) { this.text = text; }
}
const good = new Storage(null);
assert.equal(new Progress(good).note({ name: 'cut', passed: true, aided: false, time: 4 }), '1 of 1 passed, 1 without aids');
assert.equal(JSON.parse(good.text).cut.best, 4);
const bad = new Storage('a letter');
assert.match(new Progress(bad).note({ name: 'cut', passed: true, aided: false, time: 4 }), /damaged/);
assert.equal(bad.text, 'a letter');
const none = { getItem() { throw new Error('no storage'); }, setItem() { throw new Error('no storage'); } };
assert.match(new Progress(none).note({ name: 'cut', passed: true, aided: false, time: 4 }), /keeps no progress/);
console.log('progress: counted, and kept as it is where it is damaged');
