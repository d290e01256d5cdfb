// node figures.cjs FOLDER: draws every FOLDER/NAME.vl.json as FOLDER/NAME.svg. Vega and Vega-Lite lie in node_modules beside
// this file, theme.js and page.css, whose light colours it takes.
'use strict';

const {readdirSync, readFileSync, writeFileSync} = require('node:fs');
const {join} = require('node:path');
const vega = require('vega');
const vegaLite = require('vega-lite');
require('./theme.js');

const light = Object.fromEntries([...readFileSync(join(__dirname, 'page.css'), 'utf8').split('}')[0]
  .matchAll(/(--[a-z0-9]+):\s*(#[0-9a-f]{6})/g)].map((match) => [match[1], match[2]]));
const config = {...coilwrightTheme((name) => light[name]), background: '#ffffff', font: 'sans-serif'};

// A page gives labels the room that its width leaves. A file has no container to ask: it is as wide as whole labels need.
const widthOf = (spec) => {
  const axis = spec.encoding?.y?.axis;
  if (!axis?.labelLimit) return 640;
  axis.labelLimit = 420;
  return 860;
};

const draw = async (folder, file) => {
  const spec = JSON.parse(readFileSync(join(folder, file), 'utf8'));
  spec.width = widthOf(spec);
  const view = new vega.View(vega.parse(vegaLite.compile(spec, {config}).spec), {renderer: 'none'});
  // How high the legend is shows once it is laid out: only the second layout leaves room for all of its rows.
  await view.runAsync();
  await view.resize().runAsync();
  writeFileSync(join(folder, file.replace(/\.vl\.json$/, '.svg')), await view.toSVG());
  view.finalize();
};

const [folder] = process.argv.slice(2);
Promise.all(readdirSync(folder).filter((file) => file.endsWith('.vl.json')).map((file) => draw(folder, file))).catch((error) => {
  console.error(error.message);
  process.exitCode = 1;
});
