// node three_test.mjs report.html: the page of a front of three objectives and several configurations in a browser.
import {assert, atThreeWidths, launch, ringError} from './session.mjs';

const file = process.argv[2];
const browser = await launch();
try {
  await atThreeWidths(browser, file, async (page, said) => {
    const plot = await page.locator('#front-plot svg').boundingBox();
    const designs = await page.locator('#front-plot .role-frame > g > path.background').first().boundingBox();
    assert.ok(designs.height > 0.55 * plot.height, `legends leave the designs ${designs.height} of ${plot.height} px at ${said}`);
    const error = await ringError(page);
    assert.ok(error < 2.5, `the ring is ${error} px beside the selected design at ${said}`);
  });
} finally {
  await browser.close();
}
console.log('the designs of a front of three objectives have room, and the ring is about the selected one, at three widths');
