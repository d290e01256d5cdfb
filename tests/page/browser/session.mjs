// A real browser that opens one page, and everything that goes wrong in it.
import {chromium} from 'playwright-core';
import {strict as assert} from 'node:assert';
import {pathToFileURL} from 'node:url';

const flags = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

export const launch = () => chromium.launch({executablePath: process.env.CHROMIUM, args: flags});

// Opens a page without a network and waits until it is drawn. `complaints` has every error and every request.
export const open = async (browser, file, options = {}) => {
  const context = await browser.newContext({viewport: {width: 1440, height: 900}, offline: true, acceptDownloads: true, ...options});
  const page = await context.newPage();
  const complaints = [];
  const address = pathToFileURL(file).href;
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => complaints.push(`thrown: ${error.message}`));
  page.on('request', (request) => {
    if (request.url() !== address && !/^(data|blob):/.test(request.url())) complaints.push(`asked for ${request.url()}`);
  });
  const start = Date.now();
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'yes', undefined, {timeout: 60000});
  return {page, complaints, milliseconds: Date.now() - start, close: () => context.close()};
};

// The pixels of an element as a person sees them: width, height and functions colour(x, y), which is [r, g, b], and
// isNear(x, y, colour), which makes no array for each of a million pixels.
export const pixels = async (page, selector) => {
  const target = page.locator(selector).first();
  await target.scrollIntoViewIfNeeded();
  const png = (await target.screenshot()).toString('base64');
  const blank = await page.context().newPage();
  const {width, height, bytes} = await blank.evaluate(async (text) => {
    const image = new Image();
    image.src = `data:image/png;base64,${text}`;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const {data} = context.getImageData(0, 0, image.width, image.height);
    let out = '';
    const part = 1 << 14;
    for (let at = 0; at < data.length; at += part) out += String.fromCharCode(...data.subarray(at, at + part));
    return {width: image.width, height: image.height, bytes: btoa(out)};
  }, png);
  await blank.close();
  const data = Buffer.from(bytes, 'base64');
  return {
    width,
    height,
    colour: (x, y) => [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)],
    isNear: (x, y, colour) => {
      const at = 4 * (y * width + x);
      return Math.abs(data[at] - colour[0]) <= 40 && Math.abs(data[at + 1] - colour[1]) <= 40 &&
        Math.abs(data[at + 2] - colour[2]) <= 40;
    },
  };
};

// A colour of the page's style as [r, g, b].
export const colourOf = (page, name) => page.evaluate((each) => {
  const text = getComputedStyle(document.documentElement).getPropertyValue(each).trim();
  return [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
}, name);

// Share of the columns in the middle of a picture in which a colour is seen: about 1 for a line from side to side.
export const columnsWith = (picture, colour, from = 0.15, to = 0.9) => {
  let found = 0;
  const [first, last] = [Math.round(from * picture.width), Math.round(to * picture.width)];
  for (let x = first; x < last; ++x) {
    for (let y = 0; y < picture.height; ++y) {
      if (!picture.isNear(x, y, colour)) continue;
      ++found;
      break;
    }
  }
  return found / (last - first);
};

// How many pixels have a colour.
export const pixelsWith = (picture, colour) => {
  let found = 0;
  for (let x = 0; x < picture.width; ++x) {
    for (let y = 0; y < picture.height; ++y) found += picture.isNear(x, y, colour) ? 1 : 0;
  }
  return found;
};

// The same of any colour that is no grey: bars of every group, however full.
export const pixelsWithColour = (picture) => {
  let found = 0;
  for (let x = 0; x < picture.width; ++x) {
    for (let y = 0; y < picture.height; ++y) {
      const colour = picture.colour(x, y);
      found += Math.max(...colour) - Math.min(...colour) > 40 ? 1 : 0;
    }
  }
  return found;
};

// How far the ring about the selected design is from the mark of that design, px.
export const ringError = (page) => page.evaluate(() => {
  const centre = (element) => {
    const box = element.getBoundingClientRect();
    return [box.left + box.width / 2, box.top + box.height / 2];
  };
  const row = Number(document.documentElement.dataset.selected);
  const mark = document.querySelectorAll('#front-plot .designs_marks path')[row];
  const [[x, y], [left, top]] = [centre(mark), centre(document.querySelector('#front-plot .marker'))];
  return Math.hypot(x - left, y - top);
});

// A page at three widths, light and dark: each without a message or a request, whatever `check(page, said)` looks at.
export const atThreeWidths = async (browser, file, check) => {
  for (const [width, scheme] of [[1440, 'light'], [768, 'dark'], [390, 'light']]) {
    const {page, complaints, close} = await open(browser, file, {viewport: {width, height: 900}, colorScheme: scheme});
    const said = `${width} px, ${scheme}`;
    await check(page, said);
    assert.deepEqual(complaints, [], said);
    await close();
  }
};

export {assert};
