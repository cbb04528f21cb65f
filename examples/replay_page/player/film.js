// The film of a session, as film_code.c writes it: all frames are unpacked at once, so that any time is as near as another.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// Little-endian, whatever this machine is.
function shortsOf(base64, signed) {
  const bytes = bytesOf(base64);
  const view = new DataView(bytes.buffer);
  const numbers = new (signed ? Int16Array : Uint16Array)(bytes.length / 2);
  for (let i = 0; i < numbers.length; i++) {
    numbers[i] = signed ? view.getInt16(2 * i, true) : view.getUint16(2 * i, true);
  }
  return numbers;
}

export function columnsOf(model, name) {
  const unit = model[name + 'Unit'];
  return Float32Array.from(shortsOf(model[name], true), n => n * unit);
}

export function trianglesOf(model) {
  return shortsOf(model.triangles, false);
}

export const rowSize = form => (form === 'rigid' ? 7 : 3);

// For each number of a frame: how many before it stands the one of the place before; 0 where there is none.
function placesBefore(items) {
  const before = [];
  for (const item of items) {
    for (let i = 0; i < item.size; i++) before.push(i < item.row ? 0 : item.row);
  }
  return before;
}

function readLayout(rows, models) {
  let at = 0;
  const items = rows.map(([model, count]) => {
    const row = rowSize(models[model].form);
    const size = row * (models[model].form === 'rigid' ? 1 : count);
    const item = { model, at, row, size };
    at += size;
    return item;
  });
  return { items, size: at, before: placesBefore(items) };
}

function reader(bytes) {
  let at = 0;
  return () => {
    let number = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = bytes[at++];
      number += (byte & 127) * 2 ** shift;
      if (byte < 128) return number;
    }
  };
}

export function readFilm(film) {
  const layouts = film.layouts.map(rows => readLayout(rows, film.models));
  const next = reader(bytesOf(film.numbers));
  const frames = [];
  let last = null;
  for (let f = 0; f < film.frames; f++) {
    const layout = layouts[next()];
    const numbers = new Int16Array(layout.size);
    const same = last !== null && last.layout === layout;
    let zeros = 0;
    for (let i = 0; i < numbers.length; i++) {
      const folded = zeros > 0 ? 0 : next();
      if (zeros > 0) zeros--;
      else if (folded === 0) zeros = next();
      const difference = folded % 2 === 1 ? -(folded + 1) / 2 : folded / 2;
      const back = layout.before[i];
      numbers[i] = difference + (same ? last.numbers[i] : back > 0 ? numbers[i - back] : 0);
    }
    last = { layout, numbers };
    frames.push(last);
  }
  return frames;
}
