// The linked views of a front: what is selected in one is shown in all.
(() => {
  'use strict';

  const {embed, read, parts, views} = window.coilwright;
  const byId = (id) => document.getElementById(id);

  const shown = (value) => {
    if (value === null) return '-';
    return typeof value === 'number' ? String(Number(value.toPrecision(6))) : value;
  };

  // A table of names and values, made of elements: nothing in it is read as HTML.
  const table = (caption, rows, mark) => {
    const out = document.createElement('table');
    out.createCaption().textContent = caption;
    for (const [name, value] of rows) {
      const row = out.insertRow();
      const head = document.createElement('th');
      head.scope = 'row';
      head.textContent = name;
      row.append(head);
      const cell = row.insertCell();
      cell.className = 'number';
      cell.textContent = mark ? mark(value) : shown(value);
    }
    return out;
  };

  const replace = (view, name, rows) => view.change(name, vega.changeset().remove(() => true).insert(rows)).runAsync();

  parts.push(async () => {
    const front = read('front-data');
    if (!front || !byId('pick')) return;
    const landmarks = read('front-landmarks') ?? [];
    const pictures = read('front-pictures');
    const actuators = read('front-actuators');
    const pick = byId('pick');
    const count = Number(pick.max);
    const pictured = new Map((pictures?.rows ?? []).map((row, i) => [row, i]));
    const value = (name, row) => front.columns[name][row];
    const lines = JSON.parse(document.querySelector('script.spec[data-figure="parallel"]')?.textContent ?? 'null');
    const coordinates = lines ? coordinatesOf(lines, front) : null;
    let response = null;
    let row = 0;

    // What a line of the parallel coordinates is made of, for any row: those of the picture are a choice of them.
    function coordinatesOf(spec, all) {
      return spec.datasets.ends.map(({axis}) => {
        const column = all.columns[axis];
        const numbers = column.every((each) => typeof each === 'number');
        const values = numbers ? column : column.map((each) => [...new Set(column)].sort().indexOf(each));
        const [least, most] = values.reduce(([a, b], each) => [Math.min(a, each), Math.max(b, each)], [Infinity, -Infinity]);
        return {axis, share: (at) => (values[at] - least) / (most - least)};
      });
    }

    const showPicture = async () => {
      const at = pictured.get(row);
      const poses = byId('selection-poses');
      poses.replaceChildren();
      byId('selection-response').hidden = at === undefined;
      if (at === undefined) return;
      for (const pose of pictures.poses[at]) {
        const figure = document.createElement('figure');
        const title = document.createElement('h3');
        title.textContent = pose.title;
        const caption = document.createElement('figcaption');
        caption.textContent = pose.description;
        const drawn = new DOMParser().parseFromString(pose.svg, 'image/svg+xml').documentElement;
        figure.append(title, document.importNode(drawn, true), caption);
        poses.append(figure);
      }
      const angles = pictures.angle_deg[at];
      const step = pictures.duration_s / (pictures.samples - 1);
      const motion = angles.map((angle, i) => ({time: i * step, angle}));
      if (response) {
        await replace(response, 'motion', motion);
      } else {
        const spec = {
          width: 'container', height: 240, datasets: {motion}, data: {name: 'motion'}, mark: {type: 'line', strokeWidth: 2},
          autosize: {type: 'fit', contains: 'padding'},
          encoding: {
            x: {field: 'time', type: 'quantitative', title: 'time, s'},
            y: {field: 'angle', type: 'quantitative', title: 'bending angle, deg', scale: {zero: false}},
          },
        };
        response = (await embed(byId('selection-response-plot'), spec)).view;
      }
      const said = `From ${shown(angles[0])} deg at rest to ${shown(angles.at(-1))} deg after ${shown(pictures.duration_s)} s; `
        + `at most ${shown(Math.max(...angles))} deg.`;
      byId('selection-response-text').textContent = said;
      byId('selection-response-plot').setAttribute('aria-label', said);
    };

    // A ring over the picture: twenty thousand marks need not be drawn anew for it.
    const marker = document.createElement('div');
    marker.className = 'marker';
    views.front.container().append(marker);
    // Where the scales begin in the picture: its origin is told without its padding.
    const corner = () => {
      const [left, top] = views.front.origin();
      const padding = views.front.padding();
      return [left + padding.left, top + padding.top];
    };
    const placeOf = (at) => {
      const [left, top] = corner();
      const picture = views.front.container().querySelector('svg, canvas');
      const box = picture.getBoundingClientRect();
      const frame = views.front.container().getBoundingClientRect();
      const [x, y] = front.objectives.map((name) => value(name, at));
      return [box.left - frame.left + left + views.front.scale('x')(x), box.top - frame.top + top + views.front.scale('y')(y)];
    };
    const placeMarker = () => {
      const [left, top] = placeOf(row);
      marker.style.left = `${left}px`;
      marker.style.top = `${top}px`;
    };
    // A legend or a scroll bar that is laid out later moves the picture under the ring.
    const follow = () => requestAnimationFrame(placeMarker);
    for (const signal of ['width', 'height']) views.front.addSignalListener(signal, follow);
    new ResizeObserver(follow).observe(views.front.container());
    window.addEventListener('resize', () => setTimeout(placeMarker, 300));

    const select = async (next) => {
      row = Math.min(Math.max(next, 0), count - 1);
      pick.value = row + 1;
      byId('pick-text').textContent = row + 1;
      const objectives = front.objectives.map((name) => `${name} ${shown(value(name, row))}`).join(', ');
      pick.setAttribute('aria-valuetext', `design ${row + 1} of ${count}: ${objectives}`);
      byId('selection-text').textContent = `Design ${row + 1} of ${count}: ${objectives}.`
        + (pictures && !pictured.has(row) ? ' It is not among those that were drawn and simulated.' : '');
      const pairs = (names) => names.map((name) => [name, value(name, row)]);
      byId('selection-variables').replaceChildren(
        table('Objectives and variables', pairs([...new Set([...front.objectives, ...front.variables])])));
      byId('selection-margins').replaceChildren(
        table('Margins to the limits', pairs(front.margins), (each) => shown(each)));
      byId('selection-quantities').replaceChildren(table('Quantities', pairs(front.quantities)));
      placeMarker();
      const changes = [];
      if (coordinates) {
        changes.push(replace(views.parallel, 'selected',
          [{row, axis: coordinates.map(({axis}) => axis), share: coordinates.map(({share}) => share(row))}]));
      }
      await Promise.all(changes);
      await showPicture();
      document.documentElement.dataset.selected = row;
    };

    const fileOf = () => {
      const whole = actuators.whole[row];
      if (whole !== undefined) return whole ? `${whole.join('\n')}\n` : null;
      const text = [...actuators.lines];
      actuators.places.forEach((place, i) => { text[place] = actuators.texts[row][i]; });
      return `${text.join('\n')}\n`;
    };

    const save = byId('save');
    save.hidden = !actuators;
    save.addEventListener('click', () => {
      const text = fileOf();
      if (!text) return;
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([text], {type: 'application/json'}));
      link.download = `actuator_${row + 1}.json`;
      link.click();
      URL.revokeObjectURL(link.href);
    });

    for (const {name, row: target} of landmarks) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = name;
      button.addEventListener('click', () => select(target));
      byId('landmarks').append(button);
    }
    pick.addEventListener('input', () => select(Number(pick.value) - 1));

    // The design whose mark is nearest to the click, wherever that is: on a phone nobody meets a mark.
    views.front.addEventListener('click', (event) => {
      const [left, top] = corner();
      const box = views.front.container().querySelector('svg, canvas').getBoundingClientRect();
      const [x, y] = [views.front.scale('x'), views.front.scale('y')];
      const at = [event.clientX - box.left - left, event.clientY - box.top - top];
      const [first, second] = front.objectives.map((name) => front.columns[name]);
      let nearest = 0;
      let least = Infinity;
      for (let i = 0; i < count; ++i) {
        const distance = Math.hypot(x(first[i]) - at[0], y(second[i]) - at[1]);
        if (distance < least) [nearest, least] = [i, distance];
      }
      select(nearest);
    });
    if (landmarks.length === 0 || !landmarks.some(({name}) => name.startsWith('middle'))) await select(0);
    else await select(landmarks.find(({name}) => name.startsWith('middle')).row);
  });
})();
