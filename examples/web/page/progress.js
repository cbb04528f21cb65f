// What a trainee has passed, kept by the browser where it allows that. What is kept and is not ours stays as it is.
const KEY = 'suturing-progress';
const COUNTS = ['attempts', 'passed', 'unaided'];

function isRow(row) {
  return row !== null && typeof row === 'object' && COUNTS.every(name => Number.isInteger(row[name]) && row[name] >= 0) &&
    row.unaided <= row.passed && row.passed <= row.attempts && Number.isFinite(row.best) && row.best >= 0;
}

// Rows by the names of exercises; null: these are none.
export function readProgress(text) {
  if (text === null) return {};
  try {
    const rows = JSON.parse(text);
    return rows !== null && typeof rows === 'object' && !Array.isArray(rows) && Object.values(rows).every(isRow) ? rows : null;
  } catch {
    return null;
  }
}

export function addOutcome(rows, { name, passed, aided, time }) {
  const row = { attempts: 0, passed: 0, unaided: 0, best: 0, ...rows[name] };
  row.attempts++;
  if (passed) row.passed++;
  if (passed && !aided) {
    row.best = row.unaided === 0 ? time : Math.min(row.best, time);
    row.unaided++;
  }
  return { ...rows, [name]: row };
}

export class Progress {
  constructor(storage) {
    this.storage = storage;
  }

  read() {
    try {
      return readProgress(this.storage.getItem(KEY));
    } catch {
      return {}; // no storage
    }
  }

  // Words of what came of it.
  note(outcome) {
    const rows = this.read();
    if (rows === null) return 'the progress that this browser keeps is damaged, and stays as it is';
    const now = addOutcome(rows, outcome);
    try {
      this.storage.setItem(KEY, JSON.stringify(now));
    } catch {
      return 'this browser keeps no progress';
    }
    const row = now[outcome.name];
    return `${row.passed} of ${row.attempts} passed, ${row.unaided} without aids`;
  }
}
