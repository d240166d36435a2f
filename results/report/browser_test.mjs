// Opens a report in a real Chromium and uses it: npm-free, needs chromium and chromedriver on the PATH and Node 18 or later.
//
//   node results/report/browser_test.mjs REPORT.html [SCREENSHOT.png]
//
// Fails (exit 1) unless the page opens without network, a room opens, the view turns, all colours work, a click on a thing shows its
// proof, dark works, and the console has no error.

import {spawn} from 'node:child_process';
import {writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [page, screenshot] = process.argv.slice(2);
if (!page) {
  console.error('usage: node browser_test.mjs REPORT.html [SCREENSHOT.png]');
  process.exit(2);
}
const port = 9517 + (process.pid % 400);
const driver = spawn('chromedriver', [`--port=${port}`], {stdio: 'ignore'});
const base = `http://127.0.0.1:${port}`;
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

async function call(method, path, body) {
  const answer = await fetch(base + path, {method, body: body === undefined ? undefined : JSON.stringify(body)});
  const {value} = await answer.json();
  if (value && value.error) throw new Error(`${value.error}: ${value.message.split('\n')[0]}`);
  return value;
}

let session = '';
const run = (script, ...args) => call('POST', `${session}/execute/sync`, {script, args});
async function until(what, script, ms = 60000) {
  for (const end = Date.now() + ms; Date.now() < end; await sleep(200)) {
    const value = await run(script);
    if (value) return value;
  }
  throw new Error(`waited in vain until ${what}`);
}
const checks = [];
function check(words, good) {
  checks.push(good);
  console.log(`${good ? 'ok  ' : 'FAIL'} ${words}`);
}
/** A number of what the canvas shows: its pixels, read back small. */
const look = `const c = document.querySelector('.canvas canvas'); const s = document.createElement('canvas'); s.width = 96; s.height = 54;
  const g = s.getContext('2d'); g.drawImage(c, 0, 0, 96, 54); const d = g.getImageData(0, 0, 96, 54).data;
  let h = 0; const seen = new Set(); for (let i = 0; i < d.length; i += 4) { const v = d[i] << 16 | d[i + 1] << 8 | d[i + 2]; seen.add(v); h = (h * 31 + v) % 1000000007; }
  return [h, seen.size];`;

try {
  for (let i = 0; i < 50; ++i) {
    try {
      await call('GET', '/status');
      break;
    } catch {
      await sleep(200);
    }
  }
  const made = await call('POST', '/session', {capabilities: {alwaysMatch: {
    browserName: 'chrome',
    'goog:chromeOptions': {args: ['--headless=new', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--window-size=1280,1000', '--host-resolver-rules=MAP * ~NOTFOUND']},
    'goog:loggingPrefs': {browser: 'ALL'},
  }}});
  session = `/session/${made.sessionId}`;
  await call('POST', `${session}/url`, {url: pathToFileURL(resolve(page)).href});
  await until('the page is ready', `return document.documentElement.dataset.ready === 'yes'`);
  check('opens with a sentence', (await run(`return document.querySelector('.sentence').textContent`)).length > 20);
  check('lists its rooms', await run(`return document.querySelectorAll('#rooms tbody tr').length`) > 0);
  await until('the plots are drawn', `return document.querySelectorAll('.uplot canvas').length > 0`);
  check('draws plots', true);
  await run(`document.querySelector('#rooms tbody button').click()`);
  await until('the room is open', `return window.scanchorView !== undefined && document.querySelector('.canvas canvas')`);
  await sleep(500);
  const [first, colors] = await run(look);
  check('shows the room', colors > 20);
  await run(`document.querySelector('.canvas canvas').dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft', bubbles: true}))`);
  await sleep(300);
  const [turned] = await run(look);
  check('turns by key', turned !== first);
  for (const mode of ['truth', 'error', 'planes', 'prediction']) {
    const before = (await run(look))[0];
    const there = await run(`const b = document.querySelector('.modes [data-mode=${mode}]'); b?.click(); return Boolean(b)`);
    await sleep(200);
    check(`switches to ${mode}`, !there || (await run(look))[0] !== before);
  }
  const at = await run(`const v = window.scanchorView; const named = v.surfaces.children.filter((m) => (v.entityOf.get(m.userData.entity)?.class ?? 0) > 3);
    for (const mesh of named) { mesh.geometry.computeBoundingSphere(); const p = mesh.geometry.boundingSphere.center.clone().project(v.camera);
      const box = v.canvas.getBoundingClientRect(); const x = Math.round(box.left + (p.x + 1) / 2 * box.width), y = Math.round(box.top + (1 - p.y) / 2 * box.height);
      if (x > box.left + 5 && x < box.right - 5 && y > 5 && y < Math.min(innerHeight, box.bottom) - 5) return {x, y}; } return null;`);
  check('has a named thing in view', at !== null);
  if (at) {
    await call('POST', `${session}/actions`, {actions: [{type: 'pointer', id: 'mouse', parameters: {pointerType: 'mouse'}, actions: [
      {type: 'pointerMove', duration: 0, x: at.x, y: at.y}, {type: 'pointerDown', button: 0}, {type: 'pause', duration: 50}, {type: 'pointerUp', button: 0}]}]});
    await sleep(400);
    check('a click shows the proof', await run(`return document.querySelectorAll('#proof ol.proof li').length`) > 0);
    check('and the label with its probability', /probability \d+ %/.test(await run(`return document.querySelector('#proof').textContent`)));
  }
  if (screenshot) writeFileSync(screenshot, Buffer.from(await call('GET', `${session}/screenshot`), 'base64'));
  await run(`document.querySelector('.theme').click()`);
  await sleep(300);
  check('goes dark', await run(`return getComputedStyle(document.body).backgroundColor`) === 'rgb(22, 24, 27)');
  if (screenshot) writeFileSync(screenshot.replace(/\.png$/, '-dark.png'), Buffer.from(await call('GET', `${session}/screenshot`), 'base64'));
  await run(`dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}))`);
  check('Escape closes the room', await run(`return document.querySelector('.viewer').hidden`));
  if (screenshot) {
    await run('scrollTo(0, 0)');
    await sleep(200);
    writeFileSync(screenshot.replace(/\.png$/, '-top.png'), Buffer.from(await call('GET', `${session}/screenshot`), 'base64'));
    await run(`document.querySelector('#classes').scrollIntoView()`);
    await sleep(200);
    writeFileSync(screenshot.replace(/\.png$/, '-plots.png'), Buffer.from(await call('GET', `${session}/screenshot`), 'base64'));
  }
  const log = (await call('POST', `${session}/se/log`, {type: 'browser'})).filter((e) => e.level === 'SEVERE');
  for (const entry of log) console.log(`     ${entry.message}`);
  check('the console has no error', log.length === 0);
  await call('DELETE', session);
} catch (error) {
  check(error.message, false);
} finally {
  driver.kill();
}
process.exit(checks.every(Boolean) && checks.length > 8 ? 0 : 1);
