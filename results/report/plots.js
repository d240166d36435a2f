// Plots that answer to the mouse.

import uPlot from 'uplot';
import {element, onThemeChange, theme} from './page.js';

const plots = [];

function axes(x, y) {
  const common = () => ({
    stroke: () => theme('--ink'), grid: {stroke: () => theme('--line'), width: 1}, ticks: {stroke: () => theme('--line')},
    font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif', labelSize: 22,
  });
  return [{...common(), ...x}, {...common(), ...y}];
}

function show(parent, options, data) {
  const width = () => Math.min(560, Math.max(280, parent.clientWidth - 4));
  const plot = new uPlot({width: width(), height: 280, ...options}, data, parent);
  plots.push(plot);
  new ResizeObserver(() => {
    const w = width();
    if (Math.abs(w - plot.width) > 3) plot.setSize({width: w, height: 280});
  }).observe(parent);
}

onThemeChange(() => plots.forEach((plot) => plot.redraw(false, true)));

function figure(title, words) {
  const box = element('div', {class: 'plot'});
  return [element('figure', {}, element('figcaption', {}, element('strong', {}, title), ' ', words), box), box];
}

/** What a stated probability was worth: 95 % intervals, and the diagonal where stated and true share agree. */
export function reliability(run) {
  const rows = run.reliability;
  if (rows.length === 0) return null;
  const [node, box] = figure('Is a probability what it says?', `${rows.reduce((a, r) => a + r.count, 0)} labels by stated probability`);
  const bars = (u) => {
    const {ctx} = u;
    ctx.save();
    ctx.setLineDash([]);
    ctx.strokeStyle = theme('--accent');
    ctx.lineWidth = 1.5 * devicePixelRatio;
    for (const row of rows) {
      const x = u.valToPos(row.stated, 'x', true);
      ctx.beginPath();
      ctx.moveTo(x, u.valToPos(row.low, 'y', true));
      ctx.lineTo(x, u.valToPos(row.high, 'y', true));
      ctx.stroke();
    }
    ctx.restore();
  };
  const x = [0, ...rows.map((r) => r.stated), 1];
  requestAnimationFrame(() => show(box, {
    scales: {x: {time: false, range: [0, 1]}, y: {range: [0, 1]}},
    axes: axes({label: 'stated probability'}, {label: 'share that was right'}),
    series: [{label: 'stated', value: (u, v) => (v == null ? '–' : v.toFixed(2))},
      {label: 'right', stroke: () => theme('--accent'), width: 2, points: {show: true, size: 8}, spanGaps: true, value: (u, v) => (v == null ? '–' : v.toFixed(2))},
      {label: 'ideal', stroke: () => theme('--faint'), dash: [5, 5], points: {show: false}, value: (u, v) => (v == null ? '–' : v.toFixed(2))}],
    hooks: {draw: [bars]},
  }, [x, [null, ...rows.map((r) => r.right), null], x]));
  return node;
}

/** Median and slowest time of each stage. */
export function stages(run) {
  const timed = run.scenes.filter((s) => s.seconds);
  if (timed.length === 0) return null;
  const names = Object.keys(timed[0].seconds);
  const [node, box] = figure('Where the time goes', `median and slowest of ${timed.length} ${timed.length === 1 ? 'room' : 'rooms'}`);
  const sorted = names.map((n) => timed.map((s) => 1e3 * (s.seconds[n] ?? 0)).sort((a, b) => a - b));
  const x = names.map((_, i) => i);
  const paths = uPlot.paths.bars({size: [0.6, 60]});
  requestAnimationFrame(() => show(box, {
    scales: {x: {time: false, range: [-0.6, names.length - 0.4]}, y: {range: (u, low, high) => [0, high * 1.05 || 1]}},
    axes: axes({splits: () => x, values: () => names, rotate: -35, size: 62}, {label: 'milliseconds', size: 62}),
    series: [{label: 'stage', value: (u, v) => names[v] ?? '–'},
      {label: 'slowest', stroke: () => theme('--faint'), fill: () => theme('--line'), paths, points: {show: false}, value: (u, v) => (v == null ? '–' : `${v.toFixed(0)} ms`)},
      {label: 'median', stroke: () => theme('--accent'), fill: () => theme('--accent'), paths, points: {show: false}, value: (u, v) => (v == null ? '–' : `${v.toFixed(0)} ms`)}],
  }, [x, sorted.map((t) => t[t.length - 1]), sorted.map((t) => t[Math.floor(t.length / 2)])]));
  return node;
}

/** Found share of each room, in order: which rooms are hard. */
export function rooms(run, open) {
  if (run.scenes.length < 3) return null;
  const [node, box] = figure('Room by room', 'share of the things that were found; click opens the room');
  const x = run.scenes.map((_, i) => i);
  requestAnimationFrame(() => show(box, {
    scales: {x: {time: false, range: [-0.5, run.scenes.length - 0.5]}, y: {range: [0, 1]}},
    axes: axes({label: 'room', incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500]}, {label: 'found'}),
    series: [{label: 'room', value: (u, v) => run.scenes[v]?.name ?? '–'},
      {label: 'found', stroke: () => theme('--accent'), width: 0, paths: () => null, points: {show: true, size: 7, fill: () => theme('--accent')}, value: (u, v) => (v == null ? '–' : v.toFixed(2))}],
    hooks: {ready: [(u) => u.over.addEventListener('click', () => u.cursor.idx !== null && open(u.cursor.idx))]},
  }, [x, run.scenes.map((s) => (s.there ? s.found / s.there : null))]));
  return node;
}

/** A sweep's curves with their intervals: {x, unit, curves: [{name, value, low, high}]}. */
export function sweep(curve) {
  const colors = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00'];
  const [node, box] = figure(curve.title, curve.words ?? '');
  const data = [curve.x];
  const series = [{label: curve.axis, value: (u, v) => v}];
  const bands = [];
  curve.curves.forEach((c, i) => {
    const color = colors[i % colors.length];
    data.push(c.value);
    series.push({label: c.name, stroke: color, width: 2, points: {show: true, size: 6}, value: (u, v) => (v == null ? '–' : v.toFixed(3))});
    if (!c.low) return;
    data.push(c.high, c.low);
    // The ends of the band are no curves of their own: the style sheet leaves them out of the legend.
    const end = {stroke: 'transparent', points: {show: false}, class: 'band'};
    series.push({...end, label: `${c.name} high`}, {...end, label: `${c.name} low`});
    bands.push({series: [data.length - 2, data.length - 1], fill: `${color}33`});
  });
  requestAnimationFrame(() => show(box, {
    scales: {x: {time: false}, y: {range: [0, 1]}}, axes: axes({label: curve.axis}, {label: curve.measure}), series, bands,
  }, data));
  return node;
}
