// How every figure looks, on a page and in a file of its own: a configuration of Vega-Lite. `colour` gives a colour of
// page.css by its name, "--ink".
(() => {
  'use strict';

  const colours = ['--c1', '--c2', '--c3', '--c4', '--c5', '--c6', '--c7', '--c8'];

  globalThis.coilwrightTheme = (colour) => ({
    background: null,
    font: 'system-ui, sans-serif',
    view: {stroke: colour('--grid')},
    axis: {
      labelColor: colour('--ink'), titleColor: colour('--ink'), gridColor: colour('--grid'), domainColor: colour('--soft'),
      tickColor: colour('--soft'), labelFontSize: 12, titleFontSize: 12, titleFontWeight: 'normal', gridOpacity: 0.7,
    },
    title: {color: colour('--ink'), anchor: 'start', fontSize: 12, fontWeight: 'normal'},
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
      design: {color: colour('--c1'), strokeWidth: 1, opacity: 0.3},
      'selected-line': {color: colour('--c2'), strokeWidth: 3},
      end: {color: colour('--soft'), fontSize: 10},
      'level-name': {color: colour('--level'), fontSize: 11, dx: -4, dy: -3},
    },
    mark: {color: colour('--c1')},
    point: {tooltip: true, opacity: 1},
    bar: {tooltip: true},
  });
})();
