// Puts the page together from the run's numbers.

import uplotStyle from 'uplot/dist/uPlot.min.css';
import {element, percent, swatch, unpack} from './page.js';
import {reliability, rooms, stages, sweep} from './plots.js';
import {proofPanel} from './proof.js';
import {MODES, SceneView} from './scene.js';
import {allMetrics, classTable, confusionTable, tiles} from './scores.js';

const run = JSON.parse(document.getElementById('run').textContent);
document.head.append(element('style', {}, uplotStyle));
const app = document.getElementById('app');
app.replaceChildren();

function section(id, title, ...children) {
  return element('section', {id, 'aria-label': title}, element('h2', {}, title), ...children);
}

// ---- one room ----------------------------------------------------------------------------------------------------

const stage = element('div', {class: 'viewer', hidden: true});
let view = null;

async function openScene(index, push = true) {
  const scene = run.scenes[index];
  const text = document.getElementById(`scene-${index}`)?.textContent;
  if (!text) return;
  view?.dispose();
  view = null;
  stage.hidden = false;
  stage.replaceChildren(element('p', {}, `Opening ${scene.name} …`));
  stage.scrollIntoView({block: 'start'});
  const data = await unpack(text);
  const holder = element('div', {class: 'canvas'});
  const side = element('div', {class: 'side'});
  let panel = proofPanel(null, data, run);
  const names = element('div', {class: 'things', role: 'listbox', 'aria-label': 'Things'});
  const select = (id) => {
    const entity = data.entities.find((e) => e.id === id);
    const next = proofPanel(entity, data, run, select);
    panel.replaceWith(next);
    panel = next;
    view?.select(entity ? id : null);
    for (const button of names.children) button.setAttribute('aria-selected', button.dataset.id === String(id));
  };
  const owners = new Set(data.surfaces.map((s) => s.entity));
  const listed = data.entities.filter((e) => owners.has(e.id) && e.label !== 'unknown')
    .sort((a, b) => a.label.localeCompare(b.label) || a.id - b.id);
  names.append(...listed.map((e) => element('button', {
    role: 'option', 'data-id': e.id, 'aria-selected': 'false', onclick: () => select(e.id),
  }, swatch(e.class > 0 ? run.classes[e.class][1] : '#adb5bd'), e.label, element('span', {class: 'faint'}, ` ${percent(e.probability)}`))));
  const modes = element('div', {class: 'modes', role: 'radiogroup', 'aria-label': 'Colours'},
    MODES.filter(([mode]) => data.truth || !['truth', 'error'].includes(mode)).map(([mode, words], i) => element('button', {
      role: 'radio', 'data-mode': mode, 'aria-checked': mode === 'prediction', title: `Key ${i + 1}`, onclick: () => setMode(mode),
    }, words)));
  const setMode = (mode) => {
    view.setMode(mode);
    for (const button of modes.children) button.setAttribute('aria-checked', button.dataset.mode === mode);
    legend.hidden = mode !== 'error';
  };
  const legend = element('div', {class: 'legend', hidden: true}, swatch('#0072b2'), 'right ', swatch('#d55e00'), 'wrong ', swatch('#adb5bd'), 'nothing said or no truth');
  side.append(element('h3', {}, 'Things'), names, panel);
  stage.replaceChildren(
    element('div', {class: 'bar-top'}, element('h2', {}, scene.name),
      element('span', {class: 'faint'}, `${scene.family ?? ''} · ${data.all_points.toLocaleString('en')} points${data.points.length / 3 < data.all_points ? `, ${(data.points.length / 3).toLocaleString('en')} shown` : ''} · ${scene.found ?? '–'} of ${scene.there ?? '–'} things found`),
      modes, element('button', {onclick: () => step(-1), title: 'Key p'}, '‹ previous'), element('button', {onclick: () => step(1), title: 'Key n'}, 'next ›'),
      element('button', {onclick: closeScene, title: 'Escape'}, 'close')),
    element('div', {class: 'split'}, holder, side), legend,
    element('p', {class: 'faint'}, 'Drag to turn, wheel to zoom, right button to shift. Keys: arrows turn, + and − zoom, 0 all, 1–4 colours, n and p next and previous room, Escape closes.'));
  view = new SceneView(holder, data, run, select);
  Object.assign(stage, {setMode, index});
  if (push) history.replaceState(null, '', `#${scene.name}`);
  window.scanchorView = view;  // for tests and the curious
}

function closeScene() {
  view?.dispose();
  view = null;
  stage.hidden = true;
  stage.replaceChildren();
  history.replaceState(null, '', location.pathname + location.search);
}

function step(by) {
  const open = run.scenes.map((s, i) => (s.view ? i : -1)).filter((i) => i >= 0);
  const at = open.indexOf(stage.index);
  openScene(open[(at + by + open.length) % open.length]);
}

addEventListener('keydown', (event) => {
  if (stage.hidden || event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === 'INPUT') return;
  if (event.key === 'Escape') closeScene();
  else if (event.key === 'n') step(1);
  else if (event.key === 'p') step(-1);
  else if (/^[1-4]$/.test(event.key)) stage.querySelectorAll('.modes button')[event.key - 1]?.click();
});

// ---- lists -------------------------------------------------------------------------------------------------------

function sceneTable() {
  const body = element('tbody');
  const fill = (filter) => body.replaceChildren(...run.scenes.flatMap((s, i) => {
    if (filter && !`${s.name} ${s.family}`.toLowerCase().includes(filter.toLowerCase())) return [];
    return [element('tr', {},
      element('td', {}, s.view ? element('button', {class: 'link', onclick: () => openScene(i)}, s.name) : s.name, s.problem ? element('span', {class: 'problem'}, ` ⚠ ${s.problem}`) : null),
      element('td', {}, s.family ?? ''), element('td', {}, String(s.seed ?? '')), element('td', {}, (s.points ?? 0).toLocaleString('en')),
      element('td', {}, s.surfaces ?? ''), element('td', {}, s.there ?? ''), element('td', {}, s.found ?? ''),
      element('td', {}, s.there ? percent(s.found / s.there) : '–'))];
  }));
  fill('');
  return [run.scenes.length > 12 ? element('input', {type: 'search', placeholder: 'filter rooms', 'aria-label': 'Filter rooms', oninput: (e) => fill(e.target.value)}) : null,
    element('div', {class: 'scroll tall'}, element('table', {class: 'numbers'},
      element('thead', {}, element('tr', {}, ['room', 'family', 'seed', 'points', 'surfaces', 'there', 'found', 'share'].map((h) => element('th', {scope: 'col'}, h)))), body))];
}

function gallery() {
  const shown = run.scenes.map((s, i) => [s, i]).filter(([s]) => s.picture);
  if (shown.length === 0) return null;
  return section('gallery', 'Gallery', element('div', {class: 'gallery'}, shown.map(([s, i]) =>
    element('button', {class: 'card', onclick: () => openScene(i), title: s.view ? 'Open in 3D' : s.name},
      element('img', {src: s.picture, alt: `What was found in ${s.name}`, loading: 'lazy'}), element('span', {}, `${s.name}: ${s.found ?? '–'} of ${s.there ?? '–'} found`)))));
}

function themeButton() {
  const button = element('button', {class: 'theme', title: 'Light or dark'}, '◐');
  button.addEventListener('click', () => {
    const root = document.documentElement;
    const dark = root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    root.dataset.theme = dark ? 'light' : 'dark';
    dispatchEvent(new Event('scanchor-theme'));
  });
  return button;
}

app.append(
  element('header', {}, element('h1', {}, run.title), themeButton(),
    element('p', {class: 'sentence'}, run.sentence),
    element('p', {class: 'faint'}, `${run.ignored} things could hardly be seen and do not count; ${run.not_described} are of classes without a description. Scored by ${run.protocol}.`,
      run.baseline ? ` Compared with ${run.baseline}.` : '')),
  tiles(run),
  stage,
  gallery() ?? '',
  section('rooms', 'Rooms', ...sceneTable()),
  section('classes', 'Classes', classTable(run)),
  section('plots', 'Plots', element('div', {class: 'plots'}, ...[...(run.sweeps ?? []).map(sweep), reliability(run), stages(run), rooms(run, openScene)].filter(Boolean))),
  section('confusion', 'Which class was called what', confusionTable(run)),
  section('metrics', 'Metrics', allMetrics(run)),
  element('footer', {class: 'faint'}, 'Made by Scanchor. This page needs no network. Viewer: three.js and uPlot, both under the MIT licence.'));

const wanted = run.scenes.findIndex((s) => `#${s.name}` === decodeURIComponent(location.hash));
if (wanted >= 0) openScene(wanted, false);
document.documentElement.dataset.ready = 'yes';
