// The draft: the text of the case and its traces, kept in this browser, and its text in a link.

const KEY = "asperity-draft";
// Most bytes of traces that are stored; browsers store some 5 million characters.
const MOST = 1.5e6;
const MARK = "#case=";

const binary = (bytes) => Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
const bytes = (text) => Uint8Array.from(text, (character) => character.charCodeAt(0));

// Stores the draft; gives whether its traces are stored too, or nothing where the browser stores nothing.
export function keep({ name, text, files }) {
  const size = files.reduce((sum, file) => sum + file.bytes.length, 0);
  const stored = size > MOST ? [] : files.map((file) => [file.name, btoa(binary(file.bytes))]);
  try {
    localStorage.setItem(KEY, JSON.stringify({ name, text, files: stored }));
    return stored.length === files.length;
  } catch {
    return undefined;
  }
}

// The draft that is stored, if there is one.
export function kept() {
  try {
    const { name, text, files } = JSON.parse(localStorage.getItem(KEY));
    return { name: String(name), text: String(text), files: files.map(([each, content]) => ({ name: each, bytes: bytes(atob(content)) })) };
  } catch {
    return undefined;
  }
}

export function forget() {
  try {
    localStorage.removeItem(KEY);
  } catch {
    // Where nothing is stored there is nothing to forget.
  }
}

// The text of a case as the last part of an address.
export function asLink(text) {
  const code = btoa(binary(new TextEncoder().encode(text)));
  return MARK + code.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

// The text of a case in the address of the page, if there is one.
export function fromLink() {
  if (!location.hash.startsWith(MARK)) return undefined;
  try {
    const code = location.hash.slice(MARK.length).replaceAll("-", "+").replaceAll("_", "/");
    return new TextDecoder().decode(bytes(atob(code)));
  } catch {
    return undefined;
  }
}
