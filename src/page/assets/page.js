// Draws the figures of a report. Every number is in the page; nothing is asked of any other place.
(() => {
  'use strict';

  // Colours by name, so that light, dark and print change them without drawing anew; a canvas needs them as they are now.
  const byName = (name) => `var(${name})`;
  const asTheyAre = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  // Vega's own way to evaluate expressions would need leave to run any text as a program; this one does not.
  const embed = (element, spec, {renderer = 'svg'} = {}) =>
    vegaEmbed(element, spec, {
      mode: 'vega-lite', ast: true, renderer, actions: false, defaultStyle: false,
      tooltip: {disableDefaultStyle: true}, config: coilwrightTheme(renderer === 'svg' ? byName : asTheyAre),
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
    // How much room a legend takes shows once it is laid out: only the second layout leaves it.
    await view.resize().runAsync();
    window.coilwright.views[script.dataset.figure] = view;
  };

  document.addEventListener('DOMContentLoaded', async () => {
    await Promise.all([...document.querySelectorAll('script.spec')].map(show));
    for (const part of window.coilwright.parts) await part();
    document.documentElement.dataset.ready = 'yes';
  });
})();
