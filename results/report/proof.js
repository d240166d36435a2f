// What a thing is, how sure, and why.

import {element, percent, swatch} from './page.js';

function bar(value, words) {
  return element('div', {class: 'probability'},
    element('span', {class: 'track'}, element('span', {class: 'fill', style: {width: `${100 * value}%`}})),
    element('span', {}, words));
}

function clause(one, scene, select) {
  const measured = one.unit !== undefined && one.unit !== '1'
    ? `measured ${one.measured.toPrecision(3)} ${one.unit} ± ${one.sigma.toPrecision(2)}`
    : one.unit === '1' ? `measured ${one.measured.toPrecision(3)} ± ${one.sigma.toPrecision(2)}` : '';
  const targets = (one.targets ?? []).slice(0, 6).map((id) => scene.entities.find((e) => e.id === id)).filter(Boolean);
  return element('li', {class: one.likelihood >= 0.5 ? 'holds' : 'fails'},
    element('div', {class: 'clause'}, element('span', {class: 'mark'}, one.likelihood >= 0.5 ? '✓' : '✗'), one.text),
    bar(one.likelihood, `${one.likelihood.toFixed(2)} (by chance ${one.background.toFixed(2)})`),
    measured ? element('div', {class: 'faint'}, measured) : null,
    targets.length ? element('div', {class: 'targets'}, targets.map((e) =>
      element('button', {class: 'link', onclick: () => select(e.id)}, `${e.label} ${e.id}`))) : null);
}

export function proofPanel(entity, scene, run, select) {
  if (!entity) {
    return element('div', {class: 'panel', id: 'proof'},
      element('p', {class: 'faint'}, 'Click a surface, or choose a thing from the list, to read what it is and why.'));
  }
  const color = entity.class > 0 ? run.classes[entity.class][1] : '#adb5bd';
  const [l, w, h] = entity.size.map((s) => (s / 1000).toFixed(2));
  const surfaces = entity.surfaces.map((id) => scene.surfaces.find((s) => s.id === id)).filter(Boolean);
  return element('div', {class: 'panel', id: 'proof', 'aria-live': 'polite'},
    element('h3', {}, swatch(color), entity.label, ' ', element('span', {class: 'faint'}, `thing ${entity.id}`)),
    bar(entity.probability, `probability ${percent(entity.probability)}`),
    element('p', {class: 'faint'}, `${l} × ${w}${Number(h) > 0 ? ` × ${h}` : ''} m, ${entity.area.toFixed(2)} m²`,
      surfaces.length === 1 ? `; ${surfaces[0].text}; ${surfaces[0].points} points` : `; ${surfaces.length} surfaces`),
    entity.classes.length > 1 ? element('details', {}, element('summary', {}, 'What else it could be'),
      element('ul', {class: 'plain'}, entity.classes.map(([name, p]) => element('li', {}, bar(p, `${name} ${p.toFixed(2)}`))))) : null,
    element('h4', {}, 'Because'),
    entity.proof.length ? element('ol', {class: 'proof'}, entity.proof.map((c) => clause(c, scene, select)))
      : element('p', {class: 'faint'}, 'No description fits it.'));
}
