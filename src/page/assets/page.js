// Draws the figures of a report. Every number is in the page; nothing is asked of any other place.
(() => {
  'use strict';

  const colours = ['--c1', '--c2', '--c3', '--c4', '--c5', '--c6', '--c7', '--c8'];

  // Colours by name, so that light, dark and print change them without drawing anew; a canvas needs them as they are now.
  const byName = (name) => `var(${name})`;
  const asTheyAre = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  const configOf = (colour) => ({
    background: null,
    font: 'system-ui, sans-serif',
    view: {stroke: colour('--grid')},
    axis: {
      labelColor: colour('--ink'), titleColor: colour('--ink'), gridColor: colour('--grid'), domainColor: colour('--soft'),
      tickColor: colour('--soft'), labelFontSize: 12, titleFontSize: 12, titleFontWeight: 'normal', gridOpacity: 0.7,
    },
    axisX: {labelOverlap: true, tickCount: 6},
    legend: {
      labelColor: colour('--ink'), titleColor: colour('--ink'), orient: 'top', direction: 'vertical', labelLimit: 320,
      columns: {expr: 'width > 600 ? 4 : width > 420 ? 2 : 1'}, labelFontSize: 12, symbolSize: 120, symbolStrokeWidth: 2,
    },
    range: {category: colours.map(colour), symbol: ['circle', 'triangle-up', 'square', 'cross', 'diamond', 'triangle-down']},
    style: {
      level: {color: colour('--level'), strokeWidth: 1.2, strokeDash: [6, 4]},
      front: {color: colour('--c1'), stroke: colour('--paper'), strokeWidth: 0.8},
      other: {color: colour('--soft'), opacity: 0.35, filled: false, strokeWidth: 1},
      selected: {color: colour('--c2'), strokeWidth: 3, filled: false, shape: 'circle'},
      design: {color: colour('--c1'), strokeWidth: 1, opacity: 0.3},
      'selected-line': {color: colour('--c2'), strokeWidth: 3},
      end: {color: colour('--soft'), fontSize: 10},
      'level-name': {color: colour('--level'), fontSize: 11, dx: -4, dy: -3},
    },
    mark: {color: colour('--c1')},
    point: {tooltip: true, opacity: 1},
    bar: {tooltip: true},
  });

  // Vega's own way to evaluate expressions would need leave to run any text as a program; this one does not.
  const embed = (element, spec, {renderer = 'svg'} = {}) =>
    vegaEmbed(element, spec, {
      mode: 'vega-lite', ast: true, renderer, actions: false, defaultStyle: false,
      tooltip: {disableDefaultStyle: true}, config: configOf(renderer === 'svg' ? byName : asTheyAre),
    });

  const read = (id) => {
    const element = document.getElementById(id);
    return element ? JSON.parse(element.textContent) : null;
  };

  window.coilwright = {embed, read, parts: [], views: {}, asTheyAre};

  // A picture of many marks is drawn as pixels; all others as shapes, which print sharp and follow the colours.
  const marksOf = (spec) => Math.max(0, ...Object.values(spec.datasets ?? {}).map((rows) => rows.length));
  const show = async (script) => {
    const spec = JSON.parse(script.textContent);
    const element = document.getElementById(`${script.dataset.figure}-plot`);
    const {view} = await embed(element, spec, {renderer: marksOf(spec) > 5000 ? 'canvas' : 'svg'});
    window.coilwright.views[script.dataset.figure] = view;
  };

  document.addEventListener('DOMContentLoaded', async () => {
    await Promise.all([...document.querySelectorAll('script.spec')].map(show));
    for (const part of window.coilwright.parts) await part();
    document.documentElement.dataset.ready = 'yes';
  });
})();
