// The page of `coilwright bench` in a real browser: node bench_test.mjs PROGRAM FINGER.json FRONT DIAGNOSIS
// [PICTURE.png], with folders of pareto and of diagnose (of init dataset). The picture is that of the README. Prints how long after a movement its answer is drawn.
import {execFileSync, spawn} from 'node:child_process';
import {createInterface} from 'node:readline';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {assert, launch} from './session.mjs';

const [program, finger, front, diagnosis, picture] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'bench-'));
const children = [];
const serve = async (...words) => {
  const child = spawn(program, ['bench', ...words, '--no-browser'], {stdio: ['ignore', 'pipe', 'inherit']});
  children.push(child);
  const lines = [];
  for await (const line of createInterface({input: child.stdout})) if (lines.push(line) === 3) break;
  return {child, address: lines[1].trim(), end: (how = 'SIGINT') => new Promise((done) => { child.on('exit', done); child.kill(how); })};
};
const shown = (page, changes) => page.waitForFunction((all) => document.documentElement.dataset.shown === all, changes.join(' '), {timeout: 60000});
const open = async (browser, address, options = {}) => {
  const context = await browser.newContext({viewport: {width: 1440, height: 900}, acceptDownloads: true, ...options});
  const page = await context.newPage();
  const complaints = [];
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => { if (!/^(data:|blob:)/.test(request.url()) && !request.url().startsWith(new URL(address).origin)) complaints.push(`asked for ${request.url()}`); });
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'yes', undefined, {timeout: 60000});
  return {page, complaints, close: () => context.close()};
};
const numbers = (page) => page.evaluate(() => {
  const {values, evaluation} = globalThis.bench.answer;
  return {values, evaluation};
});
const evaluated = (changes) => {
  const current = changes.find((each) => each.startsWith('current_A=')).split('=')[1];
  const words = changes.filter((each) => !each.startsWith('current_A=')).flatMap((each) => ['--set', each]);
  const out = JSON.parse(execFileSync(program, ['evaluate', finger, ...words, '--current-A', current, '--json'], {encoding: 'utf8'}));
  delete out.assumptions;
  return out;
};
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

const browser = await launch();
try {
  const words = [finger, '--current-A', '0.8', '--token-file', join(folder, 'token')];
  let server = await serve(...words);
  const port = new URL(server.address).port;
  const {page, complaints, close} = await open(browser, server.address);

  // Ten knobs, by field, slider, list and keyboard: each number is that of evaluate.
  const moves = [['gap_mm', '1.15'], ['turns_axial', '27'], ['turns_radial', '14'], ['magnet_length_mm', '7.5'], ['magnet_radius_mm', '9.5'],
    ['bottom_layer_mm', '2.2'], ['wire_gauge_AWG', '27'], ['coil_inner_radius_mm', '2.8'], ['magnet_grade', 'N45SH']];
  const changes = [];
  for (const [name, value] of moves) {
    const field = page.locator(`[id="knob-${name}"]`);
    if (name === 'magnet_grade') await field.selectOption(value);
    else { await field.fill(value); await field.press('Enter'); }
    changes.push(`${name}=${value}`);
    await shown(page, changes);
  }
  await page.locator('#section').focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
  const current = await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('current_A'));
  assert.ok(Number(current) > 0.8);
  changes.push(`current_A=${current}`);
  await shown(page, changes);
  assert.deepEqual((await numbers(page)).evaluation, evaluated(changes));
  // What only may break a limit is told apart from what does.
  const doubted = (await numbers(page)).evaluation.part_limits.filter((each) => each.broken && each.conditional);
  assert.ok(doubted.length > 0);
  assert.deepEqual(await page.locator('.limit.doubtful .margin').allTextContents(), doubted.map(() => 'MIND'));
  const table = await page.locator('[data-quantity="mass_g"]').textContent();
  assert.equal(Number(table), Number((await numbers(page)).evaluation.mass_g.toPrecision(5)));
  for (const change of changes) assert.equal(await page.locator('.knob.changed', {has: page.locator(`[id="knob-${change.split('=')[0]}"]`)}).count(), 1, change);

  // Back and forth, a bookmark, and a number that cannot be.
  await page.click('#undo');
  assert.ok(!(await page.evaluate(() => location.hash)).includes(`current_A=${current}`));
  await page.click('#redo');
  await shown(page, changes);
  const bookmark = await page.evaluate(() => location.href);
  const second = await open(browser, bookmark);
  await shown(second.page, changes);
  assert.deepEqual((await numbers(second.page)).evaluation, (await numbers(page)).evaluation);
  await second.close();
  const gap = page.locator('#knob-gap_mm');
  await gap.fill('-1');
  await gap.press('Enter');
  await page.locator('#refused', {hasText: 'gap_mm=-1: must be'}).waitFor();
  // What then stands there is of an earlier design, and says so; nothing is taken away of it.
  assert.equal(await page.locator('#state').textContent(), 'figures of an earlier design');
  for (const id of ['get-actuator', 'get-study', 'search']) assert.ok(await page.locator(`#${id}`).isDisabled(), id);
  await page.click('#undo');
  await shown(page, changes);
  assert.equal(await page.locator('#refused').isVisible(), false);
  assert.match(await page.locator('#state').textContent(), /limits? (broken|kept)|all limits kept/);
  assert.ok(await page.locator('#get-actuator').isEnabled());
  await gap.fill('wide');
  await gap.press('Enter');
  await page.locator('.knob [role="alert"]', {hasText: 'gap_mm must be a number; got wide.'}).waitFor();
  await gap.fill('1,15');
  await gap.press('Enter');
  assert.equal(await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('gap_mm')), '1.15');
  await shown(page, changes);
  // A double click hits the field both times, whatever was in focus before.
  const before = await page.evaluate(() => location.href);
  await page.locator('#knob-turns_axial').focus();
  await page.locator('#knob-wire_gauge_AWG').dblclick();
  assert.equal(await page.evaluate(() => document.activeElement.id), 'knob-wire_gauge_AWG');
  assert.equal(await page.evaluate(() => location.href), before);
  // Numbers that the design leaves open can be stated.
  assert.equal(await page.locator('#knob-filler').isVisible(), false);
  await page.check('#all');
  assert.ok(await page.locator('#knob-filler').isVisible());
  await page.uncheck('#all');
  assert.deepEqual(complaints.filter((each) => !each.includes('422')), []);
  complaints.length = 0;

  // A search is begun and stopped, another one ends and its design is loaded.
  await page.click('#search');
  await page.waitForFunction(() => document.documentElement.dataset.work === 'running');
  await page.click('#stop');
  await page.locator('#found', {hasText: 'Stopped'}).waitFor({timeout: 60000});
  await page.click('#search');
  await page.click('#take', {timeout: 300000});
  await page.waitForFunction((before) => location.href !== before, bookmark);

  // What is taken away.
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#get-actuator')]);
  assert.equal(download.suggestedFilename(), 'actuator.json');

  // The server is gone, and is found again.
  await server.end('SIGKILL');
  await gap.fill('1.05');
  await gap.press('Enter');
  await page.locator('#gone', {hasText: 'is gone'}).waitFor({timeout: 20000});
  server = await serve(...words, '--port', port);
  await page.waitForFunction(() => document.getElementById('gone').hidden, undefined, {timeout: 20000});
  await page.waitForFunction(() => globalThis.bench.answer.values.gap_mm === 1.05, undefined, {timeout: 20000});
  await close();

  // Without sideways scrolling at three widths, light and dark.
  for (const [width, colorScheme] of [[1440, 'light'], [768, 'dark'], [390, 'dark'], [390, 'light']]) {
    const small = await open(browser, server.address, {viewport: {width, height: 900}, colorScheme});
    await small.page.waitForFunction(() => document.documentElement.dataset.curves !== undefined);
    assert.ok(await small.page.evaluate(() => document.documentElement.scrollWidth) <= width, `${width} px`);
    assert.deepEqual(small.complaints, []);
    await small.close();
  }

  if (picture) {
    const drawn = await open(browser, `${server.address}#current_A=0.9&gap_mm=0.8&magnet_length_mm=9`, {viewport: {width: 1280, height: 860}});
    await drawn.page.waitForFunction(() => document.querySelector('#plot-angle .ghost') !== null && !document.querySelector('.stale'));
    await drawn.page.screenshot({path: picture});
    await drawn.close();
  }

  // How long after a movement everything is drawn: the curves over the current come last.
  for (const configuration of ['B', 'D']) {
    const timed = await open(browser, `${server.address}#configuration=${configuration}`);
    await timed.page.waitForFunction(() => globalThis.bench.curveMilliseconds.length > 0, undefined, {timeout: 60000});
    const times = await timed.page.evaluate(async () => {
      const [first, all] = [[], []];
      for (let i = 0; i < 15; ++i) {
        const count = globalThis.bench.curveMilliseconds.length;
        globalThis.bench.set('gap_mm', (1 + 0.01 * i).toFixed(2));
        while (globalThis.bench.curveMilliseconds.length === count) await new Promise((done) => setTimeout(done, 2));
        first.push(globalThis.bench.milliseconds.at(-1));
        all.push(globalThis.bench.curveMilliseconds.at(-1));
      }
      return {first, all};
    });
    console.log(`${configuration}: numbers, limits, section, step and temperatures drawn ${median(times.first).toFixed(0)} ms after a movement, with both curves over the current ${median(times.all).toFixed(0)} ms (medians of 15)`);
    await timed.close();
  }
  await server.end();

  // Of a front a click loads a design.
  const results = await serve(front);
  const designs = await open(browser, results.address);
  await designs.page.locator('#scatter circle').nth(3).click({force: true});
  await designs.page.waitForFunction(() => document.querySelector('#scatter circle.chosen') !== null && globalThis.bench.answer !== null);
  const row = await designs.page.evaluate(() => Number(document.querySelector('#scatter circle.chosen').dataset.row));
  const expected = await designs.page.evaluate(async (number) => (await (await fetch('api/bench')).json()).further.designs.mass_g[number], row);
  await designs.page.waitForFunction((mass) => globalThis.bench.answer.evaluation.mass_g === mass, expected, {timeout: 20000});
  assert.deepEqual(designs.complaints, []);
  await designs.close();
  await results.end();

  // Of a diagnosis: the numbers of its effect move the prediction and its errors, and All back returns to what it found.
  const diagnosed = await serve(diagnosis);
  const replayed = await open(browser, diagnosed.address);
  const sheet = replayed.page;
  const errorsAre = (how) => sheet.waitForFunction((word) => {
    const {record, errors} = globalThis.bench;
    const found = [record?.rmse, ...errors ?? []].map((each) => each && each.turned !== undefined && (each.turned === each.corrected ? 'corrected' : each.turned > each.corrected ? 'worse' : 'better'));
    return found.length > 2 && found.every((each) => each === word);
  }, how, {timeout: 60000});
  await errorsAre('corrected');
  const stated = JSON.parse(readFileSync(join(diagnosis, 'diagnosis.json'), 'utf8'));
  const [effect] = stated.effects;
  const [key] = Object.keys(effect.parameters);
  const knob = sheet.locator('.knob', {has: sheet.locator(`[id="knob-${effect.id}.${key}"]`)});
  const interval = effect.parameters[key].ci95.map((each) => String(Number(each.toPrecision(5))));
  assert.equal(await knob.locator('.surely').textContent(), `95 %: ${interval.join(' to ')}`);
  const placed = await knob.evaluate((row) => {
    const slider = row.querySelector('input[type="range"]'), mark = row.querySelector('.interval rect');
    const share = (Number(slider.value) - Number(slider.min)) / (Number(slider.max) - Number(slider.min));
    return [Number(mark.getAttribute('x')), 100 * share, Number(mark.getAttribute('x')) + Number(mark.getAttribute('width'))];
  });
  assert.ok(placed[0] <= placed[1] && placed[1] <= placed[2] && placed[2] - placed[0] < 50, placed.join());
  await knob.locator('input[type="range"]').focus();
  for (let i = 0; i < 30; ++i) await sheet.keyboard.press('ArrowRight');
  await errorsAre('worse');
  const worst = await sheet.evaluate(() => Number(globalThis.bench.record.rmse.turned.toPrecision(5)));
  assert.equal(Number(await sheet.locator('#errors [data-model="turned"]').first().textContent()), worst);
  assert.equal(await sheet.locator('#plot-record path.measured, #plot-record path.now').count(), 4);  // each with its key
  await sheet.selectOption('#channel', {index: 1});
  await sheet.waitForFunction(() => globalThis.bench.record.rmse.turned !== undefined && document.querySelector('#plot-record svg').getAttribute('aria-label').length > 0);
  await sheet.click('#reset');
  await errorsAre('corrected');
  const moved = await sheet.evaluate(async (name) => {
    const out = [];
    for (let i = 1; i <= 15; ++i) {
      const count = globalThis.bench.recordMilliseconds.length;
      globalThis.bench.set(name, globalThis.bench.answer.values[name] * 1.01);
      while (globalThis.bench.recordMilliseconds.length === count) await new Promise((done) => setTimeout(done, 2));
      out.push(globalThis.bench.recordMilliseconds.at(-1));
    }
    return out;
  }, `${effect.id}.${key}`);
  console.log(`diagnosis: the run drawn ${median(moved).toFixed(0)} ms after a movement (median of 15)`);
  assert.deepEqual(replayed.complaints, []);
  await replayed.close();
  for (const [width, colorScheme] of [[1440, 'dark'], [390, 'light']]) {
    const small = await open(browser, diagnosed.address, {viewport: {width, height: 900}, colorScheme});
    assert.ok(await small.page.evaluate(() => document.documentElement.scrollWidth) <= width, `${width} px`);
    assert.deepEqual(small.complaints, []);
    await small.close();
  }
  await diagnosed.end();
} finally {
  await browser.close();
  for (const child of children) child.kill('SIGKILL');
  rmSync(folder, {recursive: true});
}
