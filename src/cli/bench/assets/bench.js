// The page of `coilwright bench`: knobs to the left, what the design does to the right. Every number comes from the server.
(() => {
  'use strict';

  const at = (id) => document.getElementById(id);
  const base = location.pathname;
  const page = `${Math.random()}`;  // by which the server knows which of this page's questions is the newest
  let about;                        // of the bench: its knobs and quantities
  let start, answer, startCurves, curves;  // answers of the server: of the first design and of the present one
  const knobs = new Map();          // by name: what is known of it, its range and its elements
  let state = {changes: {}, ranges: {}, limits: [], aim: null, vary: null};
  const past = [], future = [];

  // ---- words and numbers -------------------------------------------------------------------------------------------
  const escape = (text) => String(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  const short = (value) => value === null || value === undefined ? 'none' : typeof value === 'number'
    ? (Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-4) ? value.toExponential(3) : String(Number(value.toPrecision(5))))
    : String(value);
  const nice = (width) => {
    const ten = 10 ** Math.floor(Math.log10(width));
    return ten * [1, 2, 5, 10].find((each) => each * ten >= width * 0.999);
  };
  const round = (value, step) => Number((Math.round(value / step) * step).toPrecision(10));
  const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);

  // ---- the server --------------------------------------------------------------------------------------------------
  class Refusal extends Error {
    constructor(status, text) { super(text); this.status = status; }
  }
  const gone = (why) => {
    at('gone').hidden = !why;
    at('gone').textContent = why ?? '';
  };
  const ask = async (path, question, {signal, kind = 'json'} = {}) => {
    let reply;
    try {
      reply = await fetch(base + path, question ? {method: 'POST', signal, headers: {'Content-Type': 'application/json'},
        body: JSON.stringify({page, ...question})} : {signal});
    } catch (error) {
      if (error.name !== 'AbortError')
        gone('The server of this bench is gone. Start it again as before; with the same --port and --token-file this page finds it.');
      throw error;
    }
    if (reply.status === 403) gone('Another bench answers here now. Open the address that it printed, with the part of this address behind #.');
    else gone(null);
    if (!reply.ok) throw new Refusal(reply.status, (await reply.json()).error);
    return kind === 'json' ? reply.json() : reply.text();
  };
  const listed = () => Object.entries(state.changes).map(([name, value]) => `${name}=${value}`);
  const study = () => {
    const variables = {};
    for (const [name, one] of knobs) {
      if (!varied(name) || !(name in answer.values)) continue;
      if (one.words) { variables[name] = {values: one.words}; continue; }
      const value = answer.values[name], [low, high] = range(one);
      variables[name] = {lower: Math.min(low, value), upper: Math.max(high, value)};
      const steps = (value - variables[name].lower) / (one.given?.step || 1);
      if (!one.whole && one.given?.step && Math.abs(steps - Math.round(steps)) < 1e-6) variables[name].step = one.given.step;
    }
    const constraints = [];
    const add = (limit) => {
      const side = 'at_most' in limit ? 'at_most' : 'at_least';
      if (!constraints.some((each) => each.quantity === limit.quantity && side in each))
        constraints.push({quantity: limit.quantity, [side]: limit[side]});
    };
    state.limits.forEach(add);
    answer.evaluation.part_limits.filter((each) => !each.conditional).forEach(add);
    return {variables, objectives: [{[aim()[0]]: aim()[1]}], constraints};
  };

  // ---- state: what is changed, in the address, and back and forth -------------------------------------------------
  const aim = () => state.aim ?? about.aim;
  const varied = (name) => (state.vary ?? about.vary).includes(name);
  const write = () => {
    const words = new URLSearchParams();
    for (const [name, value] of Object.entries(state.changes)) words.append(name, value);
    for (const [name, ends] of Object.entries(state.ranges)) words.append('range', [name, ...ends].join(':'));
    if (!same(state.limits, about.limits)) words.append('limits', JSON.stringify(state.limits));
    if (state.aim) words.append('aim', state.aim.join(':'));
    if (state.vary) words.append('vary', state.vary.join(':'));
    history.replaceState(null, '', `${base}${`${words}` === '' ? '' : `#${words}`}`);
  };
  const read = () => {
    const out = {changes: {}, ranges: {}, limits: about.limits, aim: null, vary: null};
    for (const [name, value] of new URLSearchParams(location.hash.slice(1))) {
      const parts = value.split(':');
      if (name === 'range') out.ranges[parts[0]] = parts.slice(1, 3).map(Number);
      else if (name === 'limits') try { out.limits = JSON.parse(value); } catch { /* an address cut short */ }
      else if (name === 'aim') out.aim = parts;
      else if (name === 'vary') out.vary = parts;
      else out.changes[name] = value;
    }
    return out;
  };
  const keep = () => {  // a step to come back to
    const now = JSON.stringify(state);
    if (past.at(-1) !== now) { past.push(now); future.length = 0; }
    write();
    tools();
  };
  const tools = () => {
    at('undo').disabled = past.length < 2;
    at('redo').disabled = future.length === 0;
    at('reset').disabled = Object.keys(state.changes).length === 0;
  };
  const go = (text) => { state = JSON.parse(text); write(); tools(); refresh(); };
  const undo = () => { if (past.length > 1) { future.push(past.pop()); go(past.at(-1)); } };
  const redo = () => { if (future.length) { past.push(future.pop()); go(past.at(-1)); } };
  const set = (name, value, final = true) => {
    if (String(value) === String(start.values[name] ?? '')) delete state.changes[name];
    else state.changes[name] = String(value);
    if (final) keep();
    refresh();
  };
  const load = (changes) => {
    state.changes = {};
    for (const change of changes) {
      const [name, value] = [change.slice(0, change.indexOf('=')), change.slice(change.indexOf('=') + 1)];
      if (knobs.has(name) && value !== String(start.values[name] ?? '')) state.changes[name] = value;
    }
    keep();
    refresh();
  };

  // ---- asking: one question at a time, then the newest --------------------------------------------------------------
  let wanted = 0, shown = 0, busy = false, moved = 0, rest = null;
  // Where the design is refused, or the server gone, what stands to the right is of an earlier one.
  const ofEarlier = (is) => {
    document.body.classList.toggle('earlier', is);
    for (const id of ['get-actuator', 'get-study', 'get-report', ...Object.keys(kinds)]) at(id).disabled = is || document.documentElement.dataset.work === 'running' && id in kinds;
    if (is && at('state')) at('state').textContent = 'figures of an earlier design';
  };
  const refresh = () => {
    ++wanted;
    moved = performance.now();
    rest?.abort();
    mark();
    if (!busy) pump();
  };
  const pump = async () => {
    busy = true;
    while (shown !== wanted) {
      const mine = wanted, when = moved;
      try {
        if (about.further.diagnosis) {
          drawRecord(await ask('api/record', {changes: listed(), channel: Number(at('channel').value)}));
          bench.recordMilliseconds.push(performance.now() - when);
        }
        answer = await ask('api/evaluate', {changes: listed()});
        start ??= answer;
        at('refused').hidden = true;
        ofEarlier(false);
        draw();
        bench.milliseconds.push(performance.now() - when);
      } catch (error) {
        if (error instanceof Refusal && error.status === 422) {
          at('refused').hidden = false;
          at('refused').textContent = error.message;
          ofEarlier(true);
        } else if (!(error instanceof Refusal)) {
          ofEarlier(true);
          break;  // the server is gone: it is asked again when it is back
        }
      }
      shown = mine;
    }
    busy = false;
    document.documentElement.dataset.shown = at('refused').hidden ? listed().join(' ') : 'refused';
    if (shown === wanted && at('refused').hidden) askCurves();
  };
  const askCurves = async () => {
    rest = new AbortController();
    const when = moved;
    at('plot-angle').classList.add('stale');
    at('plot-force').classList.add('stale');
    try {
      if (about.further.diagnosis) drawErrors(await ask('api/errors', {changes: listed()}, {signal: rest.signal}));
      curves = await ask('api/curves', {changes: listed()}, {signal: rest.signal});
    } catch { return; }
    startCurves ??= Object.keys(state.changes).length === 0 ? curves : undefined;
    drawCurves();
    bench.curveMilliseconds.push(performance.now() - when);
    document.documentElement.dataset.curves = listed().join(' ');
  };

  // ---- knobs -------------------------------------------------------------------------------------------------------
  const range = (one) => {
    if (state.ranges[one.name]) return state.ranges[one.name];
    if (one.given && 'lower' in one.given) return [one.given.lower, one.given.upper];
    const value = start.values[one.name] ?? 0, least = one.lower ?? -Infinity, most = one.upper ?? Infinity;
    if (most - least <= 10 * Math.max(Math.abs(value), 0.1)) return [least, most];
    let ends = value === 0 ? [0, 10] : [value / 2, 2 * value].sort((a, b) => a - b);
    if (one.name === 'current_A') ends = [0, nice(Math.max(2 * value, 1.5 * start.evaluation.current_limit_A))];
    ends = [Math.min(ends[0], one.interval?.[0] ?? ends[0]), Math.max(ends[1], one.interval?.[1] ?? ends[1])];
    const step = one.whole ? 1 : nice((ends[1] - ends[0]) / 150);
    return [Math.max(least, one.whole ? Math.floor(ends[0]) : round(ends[0], step)), Math.min(most, one.whole ? Math.ceil(ends[1]) : round(ends[1], step))];
  };
  const stepOf = (one) => {
    const [lower, upper] = range(one);
    return one.whole ? 1 : one.given?.step || nice(Math.max(upper - lower, 1e-9) / 200);
  };
  const complain = (one, text) => {
    const place = one.row.querySelector('[role="alert"]');
    place.hidden = !text;
    place.textContent = text;
  };
  const makeKnob = (one) => {
    const row = document.createElement('div');
    row.className = 'knob';
    const id = `knob-${one.name}`, name = escape(one.name.replace(/_/g, '_\u200b'));
    const field = one.words
      ? `<select class="value" id="${id}">${one.words.map((word) => `<option>${escape(word)}</option>`).join('')}</select>`
      : `<input class="value" id="${id}" inputmode="decimal" aria-describedby="${id}-help">`;
    row.innerHTML = `<input type="checkbox" class="vary" title="vary in a search" aria-label="vary ${escape(one.name)} in a search">
      <label for="${id}">${name}</label>${field}<button type="button" class="back" title="back to where it started" aria-label="${escape(one.name)} back to where it started">↺</button>
      ${one.words ? '' : `<div class="slide"><input type="number" step="any" class="low" aria-label="lower end of ${escape(one.name)}">
      <input type="range" aria-label="${escape(one.name)}"><input type="number" step="any" class="high" aria-label="upper end of ${escape(one.name)}">${one.interval ? '<svg class="interval" viewBox="0 0 100 1" preserveAspectRatio="none" aria-hidden="true"><rect height="1"/></svg>' : ''}</div>`}
      ${one.interval ? `<p class="surely">95 %: ${one.interval.map((end) => end === null ? 'open' : short(end)).join(' to ')}</p>` : ''}
      <p class="help" id="${id}-help">${escape(one.meaning)}${one.range ? ` Allowed: ${escape(one.range)}.` : ''} <span class="was"></span></p><p class="wrong bad" role="alert" hidden></p>`;
    const find = (selector) => row.querySelector(selector);
    one.row = row;
    one.field = find('.value');
    one.slider = find('input[type="range"]');
    one.low = find('.low');
    one.high = find('.high');
    one.box = find('.vary');
    one.field.addEventListener('change', () => {
      const text = one.field.value.trim(), number = Number(text.replace(',', '.'));
      const is = one.words || text === '' || Number.isFinite(number);
      complain(one, is ? '' : `${one.name} must be a number; got ${text}.`);
      if (!is) return;
      if (text !== '') set(one.name, one.words ? text : text.replace(',', '.')); else { delete state.changes[one.name]; keep(); refresh(); }
    });
    find('.back').addEventListener('click', () => { delete state.changes[one.name]; keep(); refresh(); one.field.focus(); });
    one.box.addEventListener('change', () => {
      const now = new Set(state.vary ?? about.vary);
      if (one.box.checked) now.add(one.name); else now.delete(one.name);
      state.vary = [...now];
      keep();
      mark();
    });
    if (one.slider) {
      const value = () => round(Number(one.slider.value), stepOf(one));
      one.slider.addEventListener('input', () => set(one.name, value(), false));
      one.slider.addEventListener('change', () => set(one.name, value()));
      const ends = () => {
        const value = Number(state.changes[one.name] ?? answer.values[one.name]), known = Number.isFinite(value);
        const lower = Math.min(Number(one.low.value), known ? value : Infinity), upper = Math.max(Number(one.high.value), known ? value : -Infinity);
        const is = one.low.value !== '' && one.high.value !== '' && lower < upper && lower >= (one.lower ?? -Infinity) && upper <= (one.upper ?? Infinity);
        if (is) state.ranges[one.name] = [lower, upper];
        complain(one, is ? '' : `The ends must be numbers, the lower one first${one.range ? `, each ${one.range}` : ''}.`);
        keep();
        mark();
      };
      one.low.addEventListener('change', ends);
      one.high.addEventListener('change', ends);
    }
    return row;
  };
  const makeKnobs = () => {
    const order = ['operating point', 'surroundings', 'row', 'coil', 'magnet', 'body'];
    const all = about.knobs.map((each) => each.group);
    const groups = [...new Set([...about.further.diagnosis ? all.filter((each) => each.startsWith('effect')) : [], ...order, ...all])];
    for (const group of groups) {
      const those = about.knobs.filter((each) => each.group === group);
      if (!those.length) continue;
      const box = document.createElement('details');
      box.open = order.includes(group) && group !== 'surroundings' || group.startsWith('effect');
      box.innerHTML = `<summary>${escape(group.replace(/_/g, ' '))}</summary>`;
      for (const one of those) {
        knobs.set(one.name, one);
        one.given = about.further.study?.variables[one.name];
        one.interval = about.further.diagnosis?.intervals[one.name];
        box.append(makeKnob(one));
      }
      at('knobs').append(box);
    }
    at('knobs').addEventListener('submit', (event) => event.preventDefault());
    const tell = (event) => { const help = event.target.closest('.knob')?.querySelector('.help'); if (help) at('meaning').innerHTML = help.innerHTML; };
    for (const of of ['focusin', 'pointerover']) at('knobs').addEventListener(of, tell);
    at('knobs').append(at('meaning'));
    at('all').addEventListener('change', mark);
  };
  // The knobs as the state has them, before the server has answered.
  const mark = () => {
    for (const [name, one] of knobs) {
      const known = answer ?? start;
      const optional = one.group === 'operating point' || one.group === 'row';
      one.row.hidden = !(at('all').checked || optional || name in known.values || name in state.changes);
      const value = state.changes[name] ?? known.values[name] ?? '';
      const changed = name in state.changes || (start && String(start.values[name] ?? '') !== String(value));
      one.row.classList.toggle('changed', changed);
      one.box.checked = varied(name);
      one.row.querySelector('.was').textContent = changed ? `At first ${short(start.values[name])}.` : '';
      if (document.activeElement !== one.field || one.words) {
        if (one.words && value !== '' && ![...one.field.options].some((each) => each.value === value)) one.field.add(new Option(value));
        one.field.value = value;
      }
      if (!one.slider) continue;
      let [lower, upper] = range(one);
      if (value !== '') [lower, upper] = [Math.min(lower, Number(value)), Math.max(upper, Number(value))];
      [one.slider.min, one.slider.max, one.slider.step] = [lower, upper, 'any'];
      if (one.interval) {
        const [from, to] = one.interval.map((end, i) => Math.max(0, Math.min(100, 100 * ((end ?? [lower, upper][i]) - lower) / (upper - lower))));
        const mark = one.row.querySelector('.interval rect');
        mark.setAttribute('x', Math.min(from, 99));
        mark.setAttribute('width', Math.max(1, to - from));
      }
      if (document.activeElement !== one.slider || Number(one.slider.value) !== Number(value)) one.slider.value = value === '' ? lower : value;
      if (document.activeElement !== one.low) one.low.value = lower;
      if (document.activeElement !== one.high) one.high.value = upper;
    }
    const names = [...knobs.keys()].filter((name) => varied(name) && name in (answer ?? start).values);
    at('varied').textContent = `by ${names.length} numbers: ${names.join(', ') || 'none is ticked'}`;
  };

  // ---- what the design does ----------------------------------------------------------------------------------------
  const meaning = (name) => about.quantities.find((each) => each.name === name)?.meaning ?? '';
  const limitRows = () => {
    const wished = state.limits.map((each, index) => ({...each, index, value: answer.evaluation[each.quantity]}));
    return [...wished, ...answer.evaluation.part_limits].map((each) => {
      const most = 'at_most' in each, limit = most ? each.at_most : each.at_least;
      const scale = Math.abs(limit) || 1;
      const margin = each.value === null || each.value === undefined ? -1 : (most ? limit - each.value : each.value - limit) / scale;
      return {...each, most, limit, margin, broken: each.broken ?? margin < 0};
    });
  };
  const drawLimits = () => {
    at('cautions').innerHTML = answer.cautions.join('');
    at('limits').innerHTML = limitRows().map((each) => {
      const full = Math.max(0, Math.min(1.25, 1 - each.margin)) * 80;
      const why = each.broken ? `<p class="why${each.conditional ? ' mild' : ''}">${escape(each.consequence
        ? `${each.conditional ? 'MIND: ' : 'Beyond it '}${each.consequence}.` : `The limit that you set is not kept: ${each.quantity} is ${short(each.value)}.`)}</p>` : '';
      return `<div class="limit${each.broken ? each.conditional ? ' doubtful' : ' broken' : ''}" title="${escape(meaning(each.quantity))}"><span class="name">${escape(each.quantity.replace(/_/g, '_\u200b'))}
        ${short(each.value)} ${each.most ? '≤' : '≥'} ${short(each.limit)}</span><svg viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true"><rect class="fill" width="${full}" height="10"/><path class="edge" d="M80 0V10"/></svg>
        <span class="margin">${each.broken ? each.conditional ? 'MIND' : 'broken' : `${(100 * each.margin).toFixed(0)} % left`}</span>${each.index === undefined ? '' : `<button data-limit="${each.index}" aria-label="remove the limit of ${escape(each.quantity)}">×</button>`}${why}</div>`;
    }).join('');
  };
  const drawNumbers = () => {
    const names = [...new Set([...about.main, ...state.limits.map((each) => each.quantity), aim()[1], 'mass_g', 'voltage_V', 'cost_USD'])];
    const row = (name, more) => {
      const [now, was] = [answer.evaluation[name], start.evaluation[name]];
      const change = typeof now === 'number' && typeof was === 'number' && was !== 0 && now !== was ? `${now > was ? '+' : ''}${(100 * (now - was) / Math.abs(was)).toPrecision(3)} %` : '';
      return `<tr><td title="${escape(meaning(name))}">${escape(name.replace(/_/g, '_\u200b'))}</td><td>${short(was)}</td><td data-quantity="${name}">${short(now)}</td><td>${change}</td>${more ? `<td>${escape(meaning(name))}</td>` : ''}</tr>`;
    };
    const head = '<tr><th>quantity</th><th>at first</th><th>now</th><th>change</th>';
    at('numbers').innerHTML = `${head}</tr>${names.map((name) => row(name)).join('')}`;
    if (at('quantities').closest('details').open)
      at('quantities').innerHTML = `${head}<th>meaning</th></tr>${about.quantities.map((each) => row(each.name, true)).join('')}`;
    const broken = limitRows().filter((each) => each.broken && !each.conditional).length;
    const minds = limitRows().filter((each) => each.broken && each.conditional).length;
    at('figures').innerHTML = about.main.map((name) => `<div title="${escape(meaning(name))}">${escape(name)} <b>${short(answer.evaluation[name])}</b></div>`).join('') +
      `<div class="${broken ? 'bad' : ''}"><b id="state">${broken ? `${broken} limit${broken > 1 ? 's' : ''} broken` : 'all limits kept'}${minds ? `, ${minds} to mind` : ''}</b></div>`;
  };
  const parsed = (svg) => new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
  const drawSection = () => {
    const [now, was] = [parsed(answer.poses['pose-bent'].svg), parsed(start.poses['pose-bent'].svg)];
    const boxes = [now, was].map((each) => each.getAttribute('viewBox').split(' ').map(Number));
    const left = Math.min(...boxes.map((b) => b[0])), top = Math.min(...boxes.map((b) => b[1]));
    const right = Math.max(...boxes.map((b) => b[0] + b[2])), bottom = Math.max(...boxes.map((b) => b[1] + b[3]));
    now.setAttribute('viewBox', `${left} ${top} ${right - left} ${bottom - top}`);
    if (Object.keys(state.changes).length) {
      const ghost = was.querySelector('g');
      ghost.setAttribute('class', 'ghost');
      now.append(document.adoptNode(ghost));
    }
    at('section').replaceChildren(document.adoptNode(now));
    const slider = at('section'), [lower, upper] = range(knobs.get('current_A'));
    slider.setAttribute('aria-valuemin', lower);
    slider.setAttribute('aria-valuemax', upper);
    slider.setAttribute('aria-valuenow', answer.values.current_A);
    slider.setAttribute('aria-valuetext', answer.poses['pose-bent'].description);
  };

  // Lines over one axis: {x, y, log, lines: [{name, of, x, y}], levels: [{name, value}], here: [x, y]}.
  const widths = new Map();  // of elements, which are laid out anew when one is asked
  const plot = (element, chart) => {
    if (!widths.has(element)) widths.set(element, Math.max(280, element.clientWidth || 400));
    const width = widths.get(element), height = 210, [left, right, top, bottom] = [52, 12, 8, 38];
    const lines = chart.lines.filter((each) => each.x).map((each) => ({...each, points: each.x.map((x, i) => [x, each.y[i]]).filter(([x, y]) => y !== null && (!chart.log || x > 0))}));
    const all = lines.flatMap((each) => each.points);
    if (!all.length) { element.innerHTML = `<p class="soft">${escape(chart.nothing)}</p>`; return; }
    const reach = (values) => [Math.min(...values), Math.max(...values)];
    const scale = chart.log ? Math.log10 : (x) => x;
    let [x0, x1] = reach(all.map((p) => scale(p[0])));
    let [y0, y1] = reach([...all.map((p) => p[1]), ...(chart.levels ?? []).map((each) => each.value), ...(chart.zero ? [0] : [])]);
    if (x1 === x0) x1 = x0 + 1;
    const pad = 0.06 * (y1 - y0 || 1);
    [y0, y1] = [chart.zero && y0 >= 0 ? 0 : y0 - pad, y1 + pad];
    const X = (x) => left + (width - left - right) * (scale(x) - x0) / (x1 - x0);
    const Y = (y) => top + (height - top - bottom) * (y1 - y) / (y1 - y0);
    const ticks = (low, high, count) => {
      const step = nice((high - low) / count), out = [];
      for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) out.push(Number((i * step).toPrecision(8)));
      return out;
    };
    const xs = chart.log ? ticks(x0, x1, 6).filter(Number.isInteger).map((each) => 10 ** each) : ticks(x0, x1, width > 420 ? 7 : 4);
    let out = '';
    for (const x of xs) out += `<path class="grid" d="M${X(x)} ${top}V${height - bottom}"/><text x="${X(x)}" y="${height - bottom + 14}" text-anchor="middle">${chart.log ? x : short(x)}</text>`;
    for (const y of ticks(y0, y1, 5)) out += `<path class="grid" d="M${left} ${Y(y)}H${width - right}"/><text x="${left - 6}" y="${Y(y) + 4}" text-anchor="end">${short(y)}</text>`;
    out += `<path class="axis" d="M${left} ${top}V${height - bottom}H${width - right}"/><text x="${(left + width) / 2}" y="${height - 6}" text-anchor="middle">${escape(chart.x)}</text>`;
    for (const [i, each] of (chart.levels ?? []).entries()) out += `<path class="level" d="M${left} ${Y(each.value)}H${width - right}"/><text class="level-name" x="${width - right - 4}" y="${Y(each.value) - 3}" text-anchor="end" dx="${-90 * i}">${escape(each.name)}</text>`;
    for (const each of lines) out += `<path class="${each.of}" d="${each.points.map(([x, y], i) => `${i && x >= each.points[i - 1][0] ? 'L' : 'M'}${X(x).toFixed(1)} ${Y(y).toFixed(1)}`).join('')}"/>`;  // a bench goes through its angles again and again
    if (chart.dots) for (const [x, y] of lines.at(-1).points) out += `<circle class="dot" cx="${X(x)}" cy="${Y(y)}" r="2.5"/>`;
    if (chart.here && typeof chart.here[1] === 'number') out += `<circle class="here" cx="${X(chart.here[0])}" cy="${Y(chart.here[1])}" r="5"/>`;
    element.innerHTML = `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escape(chart.said)}">${out}</svg><div class="legend">${
      lines.map((each) => `<span><svg viewBox="0 0 24 8"><path class="${each.of}" d="M0 4H24"/></svg>${escape(each.name)}</span>`).join('')}<span>${escape(chart.y)}</span></div>`;
  };
  const moves = () => Object.keys(state.changes).length > 0;
  const drawCurves = () => {
    const one = (id, key, y) => {
      at(id).classList.remove('stale');
      plot(at(id), {x: 'current, A', y, zero: true, dots: true, here: [answer.values.current_A, answer.evaluation[key]], nothing: 'There is no value at any current.',
        said: `${y} over the current; ${short(answer.evaluation[key])} at ${short(answer.values.current_A)} A`,
        lines: [...(moves() && startCurves ? [{name: 'at first', of: 'ghost', x: startCurves.current_A, y: startCurves[key]}] : []), {name: 'now', of: 'now', x: curves.current_A, y: curves[key]}]});
    };
    one('plot-angle', 'steady_angle_deg', 'bending angle, deg');
    one('plot-force', 'grasp_force_N', 'force on the wall, N');
  };
  const draw = () => {
    mark();
    drawLimits();
    drawNumbers();
    drawSection();
    const [now, was] = [answer.response, start.response];
    plot(at('plot-response'), {x: 'time, s', y: 'bending angle, deg', nothing: 'It runs away in heat: there is no motion to show.',
      said: `Bending angle after a step of the current, at most ${short(answer.evaluation.peak_angle_deg)} deg`,
      lines: [...(moves() && was ? [{name: 'at first', of: 'ghost', x: was.time_s, y: was.angle_deg}] : []), {name: 'now', of: 'now', x: now?.time_s, y: now?.angle_deg}]});
    const heat = answer.heating;
    plot(at('plot-heat'), {x: 'time, s', y: 'temperature, degC', log: true, nothing: 'There is nothing to show.',
      said: 'Temperature of the hottest turn and the hottest magnet over time, with their limits',
      levels: [{name: 'enamel', value: heat.coil_limit_degC}, {name: 'magnet', value: heat.magnet_limit_degC}],
      lines: [{name: 'hottest turn', of: 'now', x: heat.time_s, y: heat.coil_degC}, {name: 'hottest magnet', of: 'also', x: heat.time_s, y: heat.magnet_degC}]});
    const options = Object.entries(state.changes).map(([name, value]) => ['operating point'].includes(knobs.get(name)?.group)
      ? `--${name.replace(/_/g, '-')} ${value}` : `--set '${name}=${value}'`);
    if (!('current_A' in state.changes)) options.push(`--current-A ${answer.values.current_A}`);
    at('command').textContent = `coilwright evaluate ${about.further.study ? 'ACTUATOR.json' : about.opened} ${options.join(' ')} --json`;
    bench.answer = answer;
    document.documentElement.dataset.ready = 'yes';
  };

  // ---- the runs of a diagnosis -------------------------------------------------------------------------------------
  let record, errors = [];
  const drawErrors = (those) => {
    bench.errors = errors = those;
    const row = (name, each) => `<tr><td>${escape(name)}, ${escape(each.unit)}</td>${['declared', 'corrected', 'turned'].map((model) => `<td data-model="${model}">${each[model] === undefined ? '…' : short(each[model])}</td>`).join('')}</tr>`;
    at('errors').innerHTML = `<tr><th>rms error</th><th>declared</th><th>corrected</th><th>turned</th></tr>${row('this run', record.rmse)}${
      errors.map((each) => row(`${each.quantity}, all ${each.role} runs`, each)).join('')}`;
  };
  const drawRecord = (those) => {
    bench.record = record = those;
    const line = (name, of, key) => ({name, of, x: record[key] && record.at, y: record[key]});
    plot(at('plot-record'), {x: record.axis.replace('_', ', '), y: record.channel, nothing: 'There is nothing to show.',
      said: `${record.channel} of the run; the error as turned is ${short(record.rmse.turned)} ${record.rmse.unit}`,
      lines: [line('measured', 'measured', 'measured'), line('as declared', 'ghost', 'declared'), line('corrected', 'also', 'corrected'), line('as turned', 'now', 'turned')]});
    at('thinned').textContent = record.every > 1 ? `one sample of ${record.every} is drawn` : '';
    drawErrors(errors.map((each) => ({...each, turned: undefined})));  // those over all runs follow
  };
  const makeRecords = () => {
    const given = about.further.diagnosis;
    if (!given) return;
    at('diagnosed').hidden = false;
    at('verdict').textContent = given.verdict;
    at('channel').innerHTML = given.channels.map((each, i) => `<option value="${i}">${escape(`${each.run}: ${each.channel} (${each.role})`)}</option>`).join('');
    at('channel').addEventListener('change', refresh);
  };

  // ---- designs of a front or a sweep -------------------------------------------------------------------------------
  const designs = {rows: [], columns: [], brushes: {}, chosen: -1};
  const inside = (row) => Object.entries(designs.brushes).every(([name, [low, high]]) => row[name] >= low && row[name] <= high);
  const drawScatter = () => {
    const [x, y] = [at('scatter-x').value, at('scatter-y').value];
    const rows = designs.rows.filter((row) => typeof row[x] === 'number' && typeof row[y] === 'number');
    const width = Math.max(280, at('scatter').clientWidth || 400), height = 260, [left, bottom] = [58, 36];
    const reach = (name) => [Math.min(...rows.map((row) => row[name])), Math.max(...rows.map((row) => row[name]))];
    const [[x0, x1], [y0, y1]] = [reach(x), reach(y)];
    const X = (v) => left + (width - left - 16) * (v - x0) / (x1 - x0 || 1), Y = (v) => 12 + (height - 12 - bottom) * (y1 - v) / (y1 - y0 || 1);
    let out = `<path class="axis" d="M${left} 8V${height - bottom + 6}H${width - 8}"/><text x="${width / 2}" y="${height - 4}" text-anchor="middle">${escape(x)}</text>`;
    for (const [v, anchor] of [[x0, 'start'], [x1, 'end']]) out += `<text x="${X(v)}" y="${height - bottom + 20}" text-anchor="${anchor}">${short(v)}</text>`;
    for (const v of [y0, y1]) out += `<text x="${left - 6}" y="${Y(v) + 4}" text-anchor="end">${short(v)}</text>`;
    for (const row of rows) {
      const chosen = row.number === designs.chosen;
      out += `<circle data-row="${row.number}" class="${chosen ? 'chosen' : inside(row) ? '' : 'out'}" cx="${X(row[x])}" cy="${Y(row[y])}" r="${chosen ? 7 : 5}"/>`;
    }
    at('scatter').innerHTML = `<svg viewBox="0 0 ${width} ${height}" tabindex="0" role="listbox" aria-label="Designs by ${escape(x)} and ${escape(y)}; arrow keys go from one to the next">${out}</svg><div class="legend"><span>${escape(y)} upwards</span></div>`;
    const kept = designs.rows.filter(inside).length;
    at('designs-count').textContent = kept === designs.rows.length ? `${kept} designs` : `${kept} of ${designs.rows.length} designs`;
  };
  const drawParallel = () => {
    const names = designs.columns, width = Math.max(280, at('parallel').clientWidth || 400, 62 * names.length), height = 230;
    const ends = Object.fromEntries(names.map((name) => [name, [Math.min(...designs.rows.map((r) => r[name])), Math.max(...designs.rows.map((r) => r[name]))]]));
    const X = (i) => 34 + (width - 68) * i / Math.max(1, names.length - 1);
    const Y = (name, v) => 30 + (height - 64) * (ends[name][1] - v) / (ends[name][1] - ends[name][0] || 1);
    const line = (row) => `<path class="row ${row.number === designs.chosen ? 'chosen' : inside(row) ? '' : 'out'}" data-row="${row.number}" d="${names.map((name, i) => `${i ? 'L' : 'M'}${X(i).toFixed(1)} ${Y(name, row[name]).toFixed(1)}`).join('')}"/>`;
    const order = [...designs.rows].sort((a, b) => (a.number === designs.chosen) - (b.number === designs.chosen) || inside(a) - inside(b));
    let out = order.map(line).join('');
    names.forEach((name, i) => {
      const brush = designs.brushes[name];
      out += `<path class="axis" d="M${X(i)} 30V${height - 34}"/><text x="${X(i)}" y="${i % 2 ? 10 : 22}" text-anchor="${i === 0 ? 'start' : i === names.length - 1 ? 'end' : 'middle'}" dx="${i === 0 ? -30 : i === names.length - 1 ? 30 : 0}">${escape(name)}</text>
        <text x="${X(i)}" y="${height - 20}" text-anchor="middle">${short(ends[name][0])}</text><text x="${X(i) + 4}" y="38">${short(ends[name][1])}</text>`;
      if (brush) out += `<rect class="brush" x="${X(i) - 7}" width="14" y="${Y(name, brush[1])}" height="${Y(name, brush[0]) - Y(name, brush[1])}"/>`;
      out += `<rect class="grip" data-axis="${escape(name)}" x="${X(i) - 14}" y="24" width="28" height="${height - 52}"/>`;
    });
    at('parallel').className = 'plot wide';
    at('parallel').innerHTML = `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="Each design as a line through its numbers">${out}</svg>`;
    at('parallel').firstChild.style.minWidth = `${width}px`;
    at('parallel').querySelectorAll('.grip').forEach((grip) => grip.addEventListener('pointerdown', (down) => {
      const name = grip.dataset.axis, box = at('parallel').firstChild.getBoundingClientRect(), factor = height / box.height;
      const value = (event) => ends[name][1] - ((event.clientY - box.top) * factor - 30) / (height - 64) * (ends[name][1] - ends[name][0]);
      const from = value(down);
      const move = (event) => { designs.brushes[name] = [from, value(event)].sort((a, b) => a - b); drawScatter(); drawParallel(); };
      const up = (event) => {
        document.removeEventListener('pointermove', move);
        if (Math.abs(event.clientY - down.clientY) < 3) { delete designs.brushes[name]; drawScatter(); drawParallel(); }
      };
      document.addEventListener('pointermove', move);
      document.addEventListener('pointerup', up, {once: true});
    }));
  };
  const choose = (number) => {
    designs.chosen = number;
    const row = designs.rows[number];
    load([...knobs.keys()].filter((name) => designs.loads.includes(name) && row[name] !== null).map((name) => `${name}=${row[name]}`));
    drawScatter();
    drawParallel();
  };
  const makeDesigns = () => {
    const given = about.further.designs;
    if (!given) return;
    at('designs').hidden = false;
    const wanted = about.further.study;
    const names = Object.keys(given).filter((name) => given[name].every((each) => typeof each === 'number'));
    designs.loads = [...Object.keys(wanted.variables), 'current_A'];
    designs.rows = given[Object.keys(given)[0]].map((_, number) => ({number, ...Object.fromEntries(Object.keys(given).map((name) => [name, given[name][number]]))}));
    const aims = wanted.objectives.map((each) => Object.values(each)[0]);
    designs.columns = [...new Set([...aims, ...Object.keys(wanted.variables)])].filter((name) => names.includes(name));
    for (const [id, first] of [['scatter-x', aims[0]], ['scatter-y', aims[1] ?? 'mass_g']]) {
      at(id).innerHTML = names.map((name) => `<option>${escape(name)}</option>`).join('');
      at(id).value = first;
      at(id).addEventListener('change', drawScatter);
    }
    const click = (event) => { const row = event.target.dataset?.row; if (row !== undefined) choose(Number(row)); };
    at('scatter').addEventListener('click', click);
    at('parallel').addEventListener('click', click);
    at('scatter').addEventListener('keydown', (event) => {
      const way = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
      if (!way) return;
      event.preventDefault();
      const sorted = designs.rows.filter(inside).sort((a, b) => a[at('scatter-x').value] - b[at('scatter-x').value]);
      const next = sorted[(sorted.findIndex((row) => row.number === designs.chosen) + way + sorted.length) % sorted.length];
      if (next) { choose(next.number); at('scatter').firstChild.focus(); }
    });
    drawScatter();
    drawParallel();
  };

  // ---- long work ---------------------------------------------------------------------------------------------------
  const kinds = {search: 'search', limiting: 'limits', yield: 'yield'};
  let following = false;
  const showWork = (work) => {
    const runs = work.state === 'running';
    for (const id of Object.keys(kinds)) at(id).disabled = runs || document.body.classList.contains('earlier');
    at('stop').hidden = at('progress').hidden = !runs;
    if (runs && work.of) { at('bar').max = work.of; at('bar').value = work.done; } else at('bar').removeAttribute('value');
    at('progress-text').textContent = runs ? (work.of ? `${work.done} of ${work.of} ${work.kind === 'yield' ? 'builds' : 'designs'}${work.kind === 'limits' ? '; then those around it' : ''}` : 'begins') : '';
    document.documentElement.dataset.work = work.state;
    if (runs || !following) return;
    following = false;
    const result = work.result;
    at('found').innerHTML = `${work.state === 'stopped' ? '<p>Stopped; this was found so far.</p>' : ''}${work.error ? `<p class="bad">${escape(work.error)}</p>` : ''}${result?.html ?? ''}`;
    if (work.kind === 'search' && result?.changes) {
      const take = document.createElement('button');
      take.id = 'take';
      take.textContent = result.feasible ? 'Load this design' : 'Load the design nearest to keeping the limits';
      take.addEventListener('click', () => load([...listed().filter((each) => !result.changes.some((other) => other.split('=')[0] === each.split('=')[0])), ...result.changes]));
      at('found').prepend(take);
      take.focus();
    }
  };
  const watch = async () => {
    try {
      const work = await ask('api/work');
      if (work.state === 'running') following = true;
      showWork(work);
      if (about && shown !== wanted && !busy) pump();
    } catch { /* said in the page; it is asked again */ }
    setTimeout(watch, following ? 300 : 1500);
  };
  const begin = async (kind) => {
    at('found').innerHTML = '';
    try {
      showWork(await ask(`api/${kind}`, {changes: listed(), study: study()}));
      following = true;
    } catch (error) {
      at('found').innerHTML = `<p class="bad">${escape(error.message)}</p>`;
    }
  };
  const save = async (path, name, type) => {
    try {
      const text = await ask(path, {changes: listed(), study: study()}, {kind: 'text'});
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([text], {type}));
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    } catch (error) {
      at('refused').hidden = false;
      at('refused').textContent = error.message;
    }
  };

  // ---- hands -------------------------------------------------------------------------------------------------------
  const listen = () => {
    at('undo').addEventListener('click', undo);
    at('redo').addEventListener('click', redo);
    at('reset').addEventListener('click', () => { state.changes = {}; keep(); refresh(); });
    document.addEventListener('keydown', (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.matches('input:not([type="range"], [type="checkbox"])')) return;
      const back = event.key === 'z' && !event.shiftKey;
      if (back || event.key === 'y' || event.key.toLowerCase() === 'z') { event.preventDefault(); if (back) undo(); else redo(); }
    });
    addEventListener('hashchange', () => { state = read(); keep(); refresh(); });
    document.querySelector('.skip').addEventListener('click', (event) => { event.preventDefault(); at('results').focus(); });
    const current = (change, final) => {
      const one = knobs.get('current_A'), [lower, upper] = range(one);
      set('current_A', round(Math.max(lower, Math.min(upper, change)), stepOf(one)), final);
    };
    const now = () => Number(state.changes.current_A ?? start.values.current_A);
    at('section').addEventListener('pointerdown', (down) => {
      const from = now(), [lower, upper] = range(knobs.get('current_A')), width = at('section').clientWidth;
      const move = (event) => current(from + (event.clientX - down.clientX) / width * (upper - lower), false);
      at('section').setPointerCapture(down.pointerId);
      at('section').addEventListener('pointermove', move);
      const end = () => { at('section').removeEventListener('pointermove', move); keep(); };
      at('section').addEventListener('pointerup', end, {once: true});
      at('section').addEventListener('pointercancel', end, {once: true});
    });
    at('section').addEventListener('keydown', (event) => {
      const way = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10}[event.key];
      if (way) { event.preventDefault(); current(now() + way * stepOf(knobs.get('current_A')), true); }
    });
    at('quantities').closest('details').addEventListener('toggle', drawNumbers);
    at('wish').addEventListener('submit', (event) => {
      event.preventDefault();
      const limit = {quantity: at('wish-quantity').value, [at('wish-side').value]: Number(at('wish-value').value)};
      state.limits = [...state.limits.filter((each) => each.quantity !== limit.quantity || !(at('wish-side').value in each)), limit];
      keep();
      draw();
    });
    at('limits').addEventListener('click', (event) => {
      const index = event.target.dataset.limit;
      if (index === undefined) return;
      state.limits = state.limits.filter((_, i) => i !== Number(index));
      keep();
      draw();
    });
    at('wish-quantity').addEventListener('change', () => { const now = answer.evaluation[at('wish-quantity').value]; at('wish-value').value = typeof now === 'number' ? short(now) : ''; });
    for (const id of ['aim-sense', 'aim-quantity']) at(id).addEventListener('change', () => { state.aim = [at('aim-sense').value, at('aim-quantity').value]; keep(); draw(); });
    for (const [id, kind] of Object.entries(kinds)) at(id).addEventListener('click', () => begin(kind));
    at('stop').addEventListener('click', () => ask('api/stop', {changes: []}).catch(() => {}));
    at('get-actuator').addEventListener('click', () => save('api/actuator', 'actuator.json', 'application/json'));
    at('get-study').addEventListener('click', () => save('api/study', 'study.json', 'application/json'));
    at('get-report').addEventListener('click', () => save('api/report', 'report.html', 'text/html'));
    let width = innerWidth;
    addEventListener('resize', () => { if (innerWidth !== width) { width = innerWidth; widths.clear(); draw(); if (curves) drawCurves(); if (record) drawRecord(record); if (about.further.designs) { drawScatter(); drawParallel(); } } });
  };

  const bench = {milliseconds: [], recordMilliseconds: [], curveMilliseconds: [], set, load, answer: null};
  globalThis.bench = bench;
  const open = async () => {
    about = await ask('api/bench');
    const wanted = about.further.study;
    about.limits = wanted?.constraints ?? [];
    about.aim = Object.entries(wanted?.objectives[0] ?? {maximise: 'peak_bending_speed_deg_s'})[0];
    about.vary = wanted ? Object.keys(wanted.variables) : ['current_A', 'turns_radial', 'turns_axial', 'wire_gauge_AWG', 'magnet_radius_mm', 'magnet_length_mm', 'gap_mm', 'bottom_layer_mm'];
    at('title').textContent = `Bench of ${about.name || about.opened}`;
    document.title = `${about.name || about.opened}: bench`;
    at('made').textContent = `${about.opened}, by ${about.made_by}`;
    at('get-report').hidden = !about.has_report;
    for (const id of ['wish-quantity', 'aim-quantity']) at(id).innerHTML = about.quantities.map((each) => `<option>${escape(each.name)}</option>`).join('');
    start = answer = await ask('api/evaluate', {changes: []});
    makeKnobs();
    state = read();
    past.push(JSON.stringify({...state, changes: {}}));
    if (moves()) past.push(JSON.stringify(state));
    [at('aim-sense').value, at('aim-quantity').value] = aim();
    at('wish-quantity').value = 'mass_g';
    at('wish-value').value = Math.ceil(start.evaluation.mass_g);
    listen();
    tools();
    makeDesigns();
    makeRecords();
    if (moves()) ask('api/curves', {changes: []}).then((those) => { startCurves = those; refresh(); }, refresh);
    else refresh();
    watch();
  };
  open().catch((error) => gone(`The bench cannot be shown: ${error.message}`));
})();
