// Small helpers for building the page.

export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key === 'class') node.className = value;
    else if (key.startsWith('on')) node.addEventListener(key.slice(2), value);
    else if (key === 'style') Object.assign(node.style, value);
    else node.setAttribute(key, value === true ? '' : value);
  }
  for (const child of children.flat()) {
    if (child === undefined || child === null) continue;
    node.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
  return node;
}

export const percent = (value) => (value === undefined ? '–' : `${(100 * value).toFixed(0)} %`);
export const fraction = (value, digits = 3) => (value === undefined ? '–' : value.toFixed(digits));

export function swatch(color) {
  return element('span', {class: 'swatch', style: {background: color}});
}

/** The JSON text behind base64 of a zlib stream. */
export async function unpack(text) {
  const bytes = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
}

/** A value of the style sheet, so that plots follow light and dark. */
export function theme(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function onThemeChange(action) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', action);
  addEventListener('scanchor-theme', action);
}
