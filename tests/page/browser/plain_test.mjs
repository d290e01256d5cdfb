// node plain_test.mjs report.html: a page without linked views, by what every page must do. Each chart is to be seen, at
// three widths, light and dark, and has a text and a heading.
import {assert, atThreeWidths, launch, pixels, pixelsWithColour} from './session.mjs';

const file = process.argv[2];
const browser = await launch();
let charts = 0;
try {
  await atThreeWidths(browser, file, async (page, said) => {
    const ids = await page.evaluate(() => [...document.querySelectorAll('script.spec')].map((each) => each.dataset.figure));
    assert.ok(ids.length > 0, 'a page without a chart');
    charts = ids.length;
    for (const id of ids) {
      const picture = await pixels(page, `#${id}-plot`);
      const seen = pixelsWithColour(picture);
      assert.ok(seen > 60, `nothing is seen in ${id} at ${said}: ${seen} pixels`);
    }
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than the screen at ${said}`);
    const untold = await page.evaluate(() => [...document.querySelectorAll('figure')].filter((figure) => {
      const picture = figure.querySelector('[role="img"], [role="graphics-document"], img');
      return !figure.querySelector('h3') || !(picture?.getAttribute('aria-label') || picture?.alt);
    }).map((figure) => figure.id));
    assert.deepEqual(untold, [], 'figures without a heading or a text');
  });
} finally {
  await browser.close();
}
console.log(`${charts} charts are seen at three widths, light and dark`);
