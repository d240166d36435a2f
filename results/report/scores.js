// The numbers: metrics with their change against the baseline, the table of classes, the confusion of points.

import {element, fraction, percent, swatch} from './page.js';

const SHOWN = [
  ['objects.f1', 'Things, F1'], ['objects.precision', 'Things, precision'], ['objects.recall', 'Things, recall'],
  ['panoptic.pq', 'Panoptic quality'], ['points.miou', 'Points, mean IoU'], ['points.accuracy', 'Points, accuracy'],
  ['planes.f1', 'Planes, F1'], ['planes.adjusted_rand', 'Planes, adjusted Rand'], ['labels.ece', 'Calibration error'],
];
const LOWER_IS_BETTER = /error|ece|brier|risk|rms|bias|mean_deg|unknown|ambiguous|missed|noise/;

function light(metric) {
  if (metric.before === undefined) return null;
  const change = metric.value - metric.before;
  const good = LOWER_IS_BETTER.test(metric.name) ? -change : change;
  const tone = Math.abs(change) < 0.005 ? 'same' : good > 0 ? 'good' : 'bad';
  const word = {same: 'unchanged', good: 'better', bad: 'worse'}[tone];
  const sign = change >= 0 ? '+' : '−';
  return element('span', {class: `light ${tone}`, title: `${word}: was ${fraction(metric.before)}`},
    `${{same: '●', good: '▲', bad: '▼'}[tone]} ${sign}${Math.abs(change).toFixed(3)}`);
}

export function tiles(run) {
  const byName = new Map(run.metrics.map((m) => [m.name, m]));
  const shown = SHOWN.filter(([name]) => byName.has(name));
  return element('div', {class: 'tiles'}, shown.map(([name, words]) => {
    const metric = byName.get(name);
    return element('div', {class: 'tile', title: name}, element('div', {class: 'number'}, fraction(metric.value)),
      element('div', {class: 'words'}, words), light(metric));
  }));
}

export function allMetrics(run) {
  const withBaseline = run.metrics.some((m) => m.before !== undefined);
  const head = ['metric', 'value', ...(withBaseline ? ['before', 'change'] : [])];
  return element('details', {},
    element('summary', {}, `All ${run.metrics.length} metrics`),
    element('table', {class: 'numbers'},
      element('thead', {}, element('tr', {}, head.map((h) => element('th', {scope: 'col'}, h)))),
      element('tbody', {}, run.metrics.map((m) => element('tr', {},
        element('td', {}, element('code', {}, m.name)), element('td', {}, fraction(m.value, 4)),
        ...(withBaseline ? [element('td', {}, m.before === undefined ? '–' : fraction(m.before, 4)),
          element('td', {}, light(m))] : []))))));
}

export function classTable(run) {
  const bar = (value) => element('td', {class: 'bar'},
    value === undefined ? '–' : [element('span', {class: 'fill', style: {width: `${60 * value}px`}}), percent(value)]);
  return element('table', {class: 'numbers'},
    element('thead', {}, element('tr', {}, ['class', 'there', 'found', 'missed', 'wrong', 'precision', 'recall']
      .map((h) => element('th', {scope: 'col'}, h)))),
    element('tbody', {}, run.by_class.map((row) => element('tr', {},
      element('td', {}, swatch(run.classes[row.class][1]), run.classes[row.class][0]),
      element('td', {}, row.there), element('td', {}, row.found), element('td', {}, row.there - row.found),
      element('td', {}, row.wrong + row.repeated), bar(row.precision), bar(row.recall)))));
}

export function confusionTable(run) {
  const {classes, counts} = run.confusion;
  const name = (id) => (id === 0 ? 'none' : run.classes[id][0]);
  return element('div', {class: 'scroll'}, element('table', {class: 'confusion'},
    element('caption', {}, 'Rows: true class of a point; columns: what it was called; shares of the row.'),
    element('thead', {}, element('tr', {}, element('th'), classes.map((c) => element('th', {scope: 'col'}, element('span', {}, name(c)))))),
    element('tbody', {}, classes.map((t, r) => {
      const sum = counts[r].reduce((a, b) => a + b, 0);
      if (sum === 0) return null;
      return element('tr', {}, element('th', {scope: 'row'}, name(t)), classes.map((p, c) => {
        const share = counts[r][c] / sum;
        return element('td', {
          title: `${name(t)} called ${name(p)}: ${counts[r][c]} of ${sum} points`, class: share > 0.55 ? 'deep' : '',
          style: {background: share > 0 ? `rgba(${r === c ? '0,114,178' : '213,94,0'},${0.08 + 0.85 * share})` : ''},
        }, share >= 0.005 ? (100 * share).toFixed(0) : '');
      }));
    }))));
}
