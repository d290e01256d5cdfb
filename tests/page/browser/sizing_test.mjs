// node sizing_test.mjs report.html: the page of a sizing in a browser.
import {assert, atThreeWidths, colourOf, columnsWith, launch, open, pixels, pixelsWith, pixelsWithColour} from './session.mjs';

const file = process.argv[2];
const browser = await launch();
try {
  await atThreeWidths(browser, file, async (page, said) => {
    // Not that elements are there, but that they are to be seen: a line from side to side, bars, symbols.
    const first = await colourOf(page, '--c1');
    assert.ok(columnsWith(await pixels(page, '#response-plot'), first) > 0.9, `the bending angle is not seen at ${said}`);
    assert.ok(columnsWith(await pixels(page, '#torque-plot'), first) > 0.9, `the torque is not seen at ${said}`);
    assert.ok(columnsWith(await pixels(page, '#temperature-plot'), await colourOf(page, '--c4')) > 0.5, `no temperature is seen at ${said}`);
    // A limit in the way has hardly a bar; the others have.
    const margins = await pixels(page, '#margins-plot');
    assert.ok(pixelsWithColour(margins) > 500, `no margin is seen at ${said}`);
    for (const pose of ['rest', 'bent', 'peak']) {
      const picture = await pixels(page, `#pose-${pose} svg`);
      const magnet = await colourOf(page, '--magnet');
      assert.ok(pixelsWith(picture, magnet) > 200, `the magnet of pose ${pose} is not seen at ${said}`);
    }
    assert.ok(await page.locator('#section img').evaluate((image) => image.naturalWidth > 100), 'no drawing with dimensions');
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than the screen at ${said}`);
  });

  // Without a mouse, and without eyes.
  const {page, complaints, close} = await open(browser, file);
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.closest('nav') !== null), true, 'the first stop is not the navigation');
  await page.locator('#response summary').focus();
  await page.keyboard.press('Enter');
  assert.ok(await page.locator('#response details table').isVisible(), 'the table behind a plot does not open by the keyboard');
  const untold = await page.evaluate(() => [...document.querySelectorAll('figure')].filter((figure) => {
    const picture = figure.querySelector('[role="img"], [role="graphics-document"], img');
    return !figure.querySelector('h3') || !(picture?.getAttribute('aria-label') || picture?.alt);
  }).map((figure) => figure.id));
  assert.deepEqual(untold, [], 'figures without a heading or a text');
  const levels = await page.evaluate(() => [...document.querySelectorAll('h1, h2, h3')].map((each) => Number(each.tagName[1])));
  assert.ok(levels[0] === 1 && levels.every((level, i) => i === 0 || level - levels[i - 1] <= 1), 'a level of headings is skipped');
  assert.deepEqual(complaints, []);
  await close();
} finally {
  await browser.close();
}
console.log('the page of a sizing is seen at three widths, light and dark, and reached by the keyboard');
