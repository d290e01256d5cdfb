// node diagnosis_test.mjs report.html: the page of a diagnosis in a browser.
import {assert, colourOf, columnsWith, launch, open, pixels, pixelsWith} from './session.mjs';

const file = process.argv[2];
const browser = await launch();
try {
  for (const [width, scheme] of [[1440, 'light'], [390, 'dark']]) {
    const {page, complaints, close} = await open(browser, file, {viewport: {width, height: 900}, colorScheme: scheme});
    const said = `${width} px, ${scheme}`;
    // Where models agree, and where samples lie, one covers the other.
    const run = await pixels(page, '#run-1-plot');
    assert.ok(pixelsWith(run, await colourOf(page, '--c1')) > 30, `what was measured is not seen at ${said}`);
    assert.ok(columnsWith(run, await colourOf(page, '--c2')) > 0.3, `the declared model is not seen at ${said}`);
    const left = await pixels(page, '#residual-1-plot');
    assert.ok(columnsWith(left, await colourOf(page, '--c2')) > 0.5, `the declared model leaves nothing to be seen at ${said}`);
    const lines = await pixels(page, '#spectrum-1-plot');
    assert.ok(pixelsWith(lines, await colourOf(page, '--c2')) > 60, `no spectrum is seen at ${said}`);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than the screen at ${said}`);
    assert.deepEqual(complaints, [], said);
    await close();
  }
} finally {
  await browser.close();
}
console.log('the page of a diagnosis shows what was measured, each model and what it leaves over');
