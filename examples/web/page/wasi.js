// As much of WASI (preview 1) as the module needs: text to the console, a clock, and files that are only written, which are
// kept here. The module sees one folder.
const SUCCESS = 0, BAD_FILE = 8;
const FOLDER = 3, DIRECTORY = 3, REGULAR_FILE = 4, CHARACTER_DEVICE = 2;
const BLOB_BYTES = 1 << 20; // pieces are gathered in blobs, which a browser keeps on its disk when they are many

class WrittenFile {
  constructor() {
    this.pieces = [];
    this.fresh = 0; // bytes since the last blob
    this.bytes = 0;
  }

  write(piece) {
    this.pieces.push(piece.slice());
    this.fresh += piece.length;
    this.bytes += piece.length;
    if (this.fresh >= BLOB_BYTES) {
      this.pieces = [new Blob(this.pieces)];
      this.fresh = 0;
    }
  }

  toBlob() {
    return new Blob(this.pieces, { type: 'application/octet-stream' });
  }
}

export class Wasi {
  constructor(say) {
    this.say = say; // receives what the module prints
    this.memory = null; // set when the module is there
    this.open = new Map();
    this.files = new Map();
    this.next = FOLDER + 1;
  }

  view() {
    return new DataView(this.memory.buffer);
  }

  bytes(at, size) {
    return new Uint8Array(this.memory.buffer, at, size);
  }

  text(at, size) {
    return new TextDecoder().decode(this.bytes(at, size).slice());
  }

  imports() {
    const calls = {
      clock_time_get: (clock, precision, time) => {
        this.view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
        return SUCCESS;
      },
      fd_write: (file, list, count, written) => {
        const out = this.open.get(file);
        if (!out && file !== 1 && file !== 2) return BAD_FILE;
        let total = 0;
        for (let i = 0; i < count; i++) {
          const at = this.view().getUint32(list + 8 * i, true), size = this.view().getUint32(list + 8 * i + 4, true);
          if (out) out.write(this.bytes(at, size));
          else if (size > 0) this.say(this.text(at, size));
          total += size;
        }
        this.view().setUint32(written, total, true);
        return SUCCESS;
      },
      fd_close: file => (this.open.delete(file) ? SUCCESS : BAD_FILE),
      fd_seek: () => BAD_FILE,
      fd_filestat_set_size: file => (this.open.has(file) ? SUCCESS : BAD_FILE), // they begin empty
      fd_fdstat_get: (file, stat) => {
        this.bytes(stat, 24).fill(0);
        this.view().setUint8(stat, file === FOLDER ? DIRECTORY : file < FOLDER ? CHARACTER_DEVICE : REGULAR_FILE);
        this.view().setBigUint64(stat + 8, ~0n, true); // all rights
        this.view().setBigUint64(stat + 16, ~0n, true);
        return SUCCESS;
      },
      fd_prestat_get: (file, prestat) => {
        if (file !== FOLDER) return BAD_FILE;
        this.view().setUint32(prestat, 0, true);
        this.view().setUint32(prestat + 4, 1, true);
        return SUCCESS;
      },
      fd_prestat_dir_name: (file, at) => {
        this.view().setUint8(at, '.'.charCodeAt(0));
        return SUCCESS;
      },
      path_open: (folder, lookup, path, size, flags, rights, inherited, mode, file) => {
        const written = new WrittenFile();
        this.files.set(this.text(path, size), written);
        this.open.set(this.next, written);
        this.view().setUint32(file, this.next++, true);
        return SUCCESS;
      },
      proc_exit: code => {
        throw new Error(`the module has ended with ${code}`);
      },
    };
    return { wasi_snapshot_preview1: calls };
  }
}
