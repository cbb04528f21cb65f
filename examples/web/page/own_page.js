// The page as a file: itself once more, with a session in it that it plays when it is opened.
import { pack, unpack } from './packing.js';

const SESSION = 'session'; // the element that has it

export class OwnPage {
  // Called by the page's own script before anything is changed.
  constructor(document) {
    this.program = document.currentScript;
    this.language = document.documentElement.lang;
    this.head = document.head.outerHTML;
    this.body = Array.from(document.body.children).filter(element => element.localName !== 'script').map(element => element.outerHTML).join('\n');
    this.element = document.getElementById(SESSION);
  }

  get hasSession() {
    return this.element.textContent.trim() !== '';
  }

  // The bytes of its log.
  session() {
    return unpack(this.element.textContent);
  }

  // The file, with the log in that blob.
  async fileWith(log) {
    const before = `<!DOCTYPE html>\n<html lang="${this.language}">\n${this.head}\n<body>\n${this.body}\n<script type="text/plain" id="${SESSION}">`;
    return new Blob([before, ...await pack(log), '</script>\n<script>', this.program.textContent, '</script>\n</body>\n</html>\n'], { type: 'text/html' });
  }
}
