// node three_test.mjs report.html: the page of a front of three objectives and several configurations in a browser.
import {assert, launch, open, ringError} from './session.mjs';

const file = process.argv[2];
const browser = await launch();
try {
  for (const [width, scheme] of [[1440, 'light'], [768, 'dark'], [390, 'light']]) {
    const {page, complaints, close} = await open(browser, file, {viewport: {width, height: 900}, colorScheme: scheme});
    const said = `${width} px, ${scheme}`;
    const plot = await page.locator('#front-plot svg').boundingBox();
    const designs = await page.locator('#front-plot .role-frame > g > path.background').first().boundingBox();
    assert.ok(designs.height > 0.55 * plot.height, `legends leave the designs ${designs.height} of ${plot.height} px at ${said}`);
    const error = await ringError(page);
    assert.ok(error < 2.5, `the ring is ${error} px beside the selected design at ${said}`);
    assert.deepEqual(complaints, [], said);
    await close();
  }
} finally {
  await browser.close();
}
console.log('the designs of a front of three objectives have room, and the ring is about the selected one, at three widths');
