// Bytes as text of a page: gzip, then base64.
const PIECE = 3 * 8192; // bytes: a multiple of three, so that the pieces' texts make the text of the whole

// Texts to be written one after the other.
export async function pack(blob) {
  const stream = blob.stream().pipeThrough(new CompressionStream('gzip'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const texts = [];
  for (let at = 0; at < bytes.length; at += PIECE) texts.push(btoa(String.fromCharCode(...bytes.subarray(at, at + PIECE))));
  return texts;
}

export async function unpack(base64) {
  const text = atob(base64);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
