// node front_test.mjs report.html [program]: the page of a front in a browser. With WORTH set, also how fast it is.
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {execFileSync} from 'node:child_process';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {assert, atThreeWidths, colourOf, launch, open, pixels, pixelsWith, ringError} from './session.mjs';

const [file, program] = process.argv.slice(2);
const browser = await launch();
const selected = (page) => page.evaluate(() => Number(document.documentElement.dataset.selected));
const waitFor = (page, row) => page.waitForFunction((each) => document.documentElement.dataset.selected === String(each), row);
try {
  await atThreeWidths(browser, file, async (page, said) => {
    assert.ok(pixelsWith(await pixels(page, '#front-plot'), await colourOf(page, '--c1')) > 200, `no design is seen at ${said}`);
    assert.ok(pixelsWith(await pixels(page, '#front-plot'), await colourOf(page, '--c2')) > 30, `no selection is seen at ${said}`);
    assert.ok(pixelsWith(await pixels(page, '#parallel-plot'), await colourOf(page, '--c2')) > 200,
      `the selection is not seen in the parallel coordinates at ${said}`);
    assert.ok(pixelsWith(await pixels(page, '#selection-response-plot'), await colourOf(page, '--c1')) > 200,
      `the response is not seen at ${said}`);
    const error = await ringError(page);
    assert.ok(error < 2.5, `the ring is ${error} px beside the selected design at ${said}`);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than the screen at ${said}`);
  });

  const {page, complaints, close} = await open(browser, file);
  const views = () => page.evaluate(() => ({
    text: document.getElementById('selection-text').textContent,
    variables: document.getElementById('selection-variables').textContent,
    margins: document.getElementById('selection-margins').textContent,
    poses: document.getElementById('selection-poses').textContent,
    response: document.getElementById('selection-response-text').textContent,
  }));
  // By the keyboard: the slider goes to its ends and on by one, and every view follows.
  await page.locator('#pick').focus();
  await page.keyboard.press('Home');
  await waitFor(page, 0);
  const before = await views();
  await page.keyboard.press('ArrowRight');
  await waitFor(page, 1);
  await page.keyboard.press('End');
  const count = Number(await page.locator('#pick').getAttribute('max'));
  await waitFor(page, count - 1);
  const after = await views();
  for (const view of Object.keys(before)) assert.notEqual(after[view], before[view], `the ${view} does not follow the selection`);

  // By the mouse: a click on the mark of the first design selects it.
  const at = await page.evaluate(() => {
    const view = window.coilwright.views.front;
    const front = window.coilwright.read('front-data');
    const box = view.container().querySelector('svg, canvas').getBoundingClientRect();
    const [left, top] = view.origin();
    const padding = view.padding();
    return [box.left + padding.left + left + view.scale('x')(front.columns[front.objectives[0]][0]),
      box.top + padding.top + top + view.scale('y')(front.columns[front.objectives[1]][0])];
  });
  await page.evaluate((y) => window.scrollBy(0, y - 400), at[1]);
  const moved = await page.evaluate(() => window.scrollY);
  await page.mouse.click(at[0], at[1] - moved);
  await waitFor(page, 0);
  assert.deepEqual((await views()).variables, before.variables);

  // What is told of the selection is what front.csv has: the numbers of the page's data, row by row.
  const told = await page.evaluate(() => {
    const front = window.coilwright.read('front-data');
    return front.objectives.map((name) => [name, front.columns[name][0]]);
  });
  for (const [name, value] of told) {
    assert.ok(before.text.includes(`${name} ${Number(value.toPrecision(5))}`), `${name} is not told of the first design`);
  }

  // The file that is saved is an actuator that gives the objectives of its row.
  if (program) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#save').click()]);
    const folder = mkdtempSync(join(tmpdir(), 'coilwright-saved-'));
    const saved = join(folder, 'actuator.json');
    writeFileSync(saved, readFileSync(await download.path()));
    const evaluated = JSON.parse(execFileSync(program, ['evaluate', saved, '--json']));
    rmSync(folder, {recursive: true});
    for (const [name, value] of told) assert.equal(evaluated[name], value, `the saved design has another ${name}`);
  }
  assert.deepEqual(complaints, []);
  assert.equal(await selected(page), 0);
  await close();
} finally {
  await browser.close();
}
console.log('the views of a front follow the selection by mouse and keyboard, and the saved file gives its numbers');
