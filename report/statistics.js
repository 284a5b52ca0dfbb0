// Fragility, modes, inputs, running means, sensitivity.
import { element, choice, fixed, figures, percent, words, levelColour, colours } from './format.js';
import { chart, key, drawIntervals, dashOf } from './chart.js';
import { folded } from './tables.js';

const plot = () => element('div', { class: 'plot' });

/** Values of one list at all of x, by steps or straight lines; null outside. */
function resample(x, from, values, stepped) {
    return x.map((v) => {
        let i = from.findLastIndex((f) => f <= v);
        if (i < 0 || (i === from.length - 1 && v > from[i])) return null;
        if (stepped || i === from.length - 1) return values[Math.min(i, values.length - 1)];
        return values[i] + ((v - from[i]) / (from[i + 1] - from[i])) * (values[i + 1] - values[i]);
    });
}

export function fragility(data, host) {
    const states = data.fragility.filter((s) => s.curves.length);
    if (!states.length) return host.append(element('p', {}, 'No wall has reached a limit state, or is known to have reached none.'));
    const where = plot();
    const legend = element('div', {});
    const chosen = { state: 0, level: 'all' };
    let drawn;
    const show = () => {
        drawn?.remove();
        const state = states[chosen.state];
        const one = state.curves.filter((c) => c.level === chosen.level);
        const curves = chosen.level === 'all' ? state.curves : one;
        const x = [0, ...(curves[0]?.drift ?? [])];
        const series = curves.flatMap((c) => fragilitySeries(data, c, x, chosen.level !== 'all'));
        drawn = chart(where, { label: `Probability that ${state.name} is reached, against drift, ${chosen.level === 'all' ? 'all stresses' : data.levels[chosen.level].name}`, x, series, xLabel: 'drift [%]', yLabel: 'share of walls past the limit state', yRange: [0, 1], height: 360, tip: (i) => tipText(series, x, i) });
        const without = curves.filter((c) => !c.fitted && !c.limit).map((c) => data.levels[c.level].name);
        const limits = curves.filter((c) => c.limit).map((c) => ` ${data.levels[c.level].name}: ${c.limit}.`);
        const none = series.length || limits.length ? '' : ' No wall is known to have reached it.';
        const steps = without.length ? ` No law is fitted to ${without.join(', ')}: the steps are the observed shares.${none}` : '';
        legend.replaceChildren(key(series), element('p', { class: 'note' }, `${state.name}: ${state.rule}.${steps}${limits.join('')}`));
    };
    const set = (name) => (value) => ((chosen[name] = value), show());
    host.append(
        choice('Limit state', states.map((s, i) => ({ value: i, text: s.name })), 0, set('state')).row,
        choice('Stress', everyLevel(data), 'all', set('level')).row,
        where, legend);
    show();
}

function fragilitySeries(data, c, x, alone) {
    const colour = levelColour(c.level);
    const name = data.levels[c.level].name;
    const fitted = () => ({ label: alone ? `${name}: fitted, with ${percent(data)} band` : `${name}, ${percent(data)} band`, colour, dash: alone ? [] : dashOf(c.level), width: 2.5, data: [0, ...c.least], band: [[0, ...c.lower], [0, ...c.upper]], faint: !alone });
    const series = c.fitted ? [fitted()] : [];
    if (!alone && c.fitted) return series;
    if (c.fitted && c.most.some((p, i) => p > c.least[i] + 1e-4)) series.push({ label: 'the most it may be: some modes have no fit', colour, dash: [3, 3], width: 1.5, data: [0, ...c.most] });
    if (c.steps.length) {
        const last = c.steps.at(-1)[1];
        const at = [0, ...c.steps.map((s) => s[0]), last === 1 ? x.at(-1) : c.known_to]; // all down: for good
        const p = [0, ...c.steps.map((s) => s[1]), last];
        series.push({ label: `${alone ? '' : `${name}: `}observed share of the walls (Kaplan-Meier)`, colour: alone ? '#222222' : colour, dash: alone ? [] : dashOf(c.level), width: 1.2, data: resample(x, at, p, true) });
    }
    else if (!c.fitted && !c.limit && c.known_to > 0) series.push({ label: `${name}: no wall has reached it`, colour, dash: dashOf(c.level), width: 1.2, data: resample(x, [0, c.known_to], [0, 0], true) });
    return series;
}

function tipText(series, x, i) {
    return [`drift ${fixed(x[i], 2)} %`, ...series.filter((s) => s.label && s.data[i] !== null).map((s) => `${s.label}: ${fixed(s.data[i], 2)}`)].join('\n');
}

export function cycles(data, host) {
    const where = plot();
    const legend = element('div', {});
    let drawn;
    const show = (mode) => {
        drawn?.remove();
        const lines = data.damping.filter((d) => d.mode === mode);
        const byDrift = (d) => d.drift.map((_, i) => i).sort((a, b) => d.drift[a] - d.drift[b] || a - b);
        const x = [...new Set(lines.flatMap((d) => d.drift))].sort((a, b) => a - b);
        const series = lines.map((d) => {
            const order = byDrift(d);
            const on = (values) => resample(x, order.map((i) => d.drift[i]), order.map((i) => values[i]), false);
            const sure = d.lower.every((v) => v !== null);
            return { label: data.levels[d.level].name, colour: levelColour(d.level), dash: dashOf(d.level), width: 2.5, data: on(d.damping), band: sure ? [on(d.lower), on(d.upper)] : undefined, faint: true };
        });
        const top = Math.max(1, ...lines.flatMap((d) => d.upper.map((v, i) => v ?? d.damping[i])));
        if (x.length) drawn = chart(where, { label: `Equivalent viscous damping against drift, ${mode} walls`, x, series, xLabel: 'drift [%]', yLabel: 'damping [%]', yRange: [0, top * 1.05], height: 320, tip: (i) => tipText(series, x, i) });
        legend.replaceChildren(key(series), element('p', { class: 'note' }, x.length ? `Bands: ${percent(data)} intervals of the mean.` : 'No wall closed a cycle.'));
    };
    const seen = [...new Set(data.damping.map((d) => d.mode))];
    host.append(choice('Walls', seen.map((m) => ({ value: m, text: m })), 'all', show).row, where, legend);
    show('all');
}

export function modes(data, host) {
    const levels = data.modes.levels;
    const model = data.modes.model;
    if (!levels.length) return host.append(element('p', {}, 'No wall gave a result.'));
    const x = [...new Set([...(model?.stress ?? []), ...levels.map((l) => l.stress)])].sort((a, b) => a - b);
    const on = (values) => resample(x, model.stress, values, false);
    const series = [];
    if (model) series.push({ label: `logistic regression, ${percent(data)} band`, colour: colours.rocking, data: on(model.value), band: [on(model.lower), on(model.upper)] });
    series.push({ label: `share of rocking walls, ${percent(data)} interval (${data.modes.either_way} counted either way)`, colour: '#222222', points: true, data: x.map((v) => levels.find((l) => l.stress === v)?.value ?? null) });
    if (levels.some((l) => l.sliding > 0)) series.push({ label: 'share of sliding walls', colour: colours.sliding, points: true, data: x.map((v) => levels.find((l) => l.stress === v)?.sliding ?? null) });
    const where = plot();
    host.append(where, key(series), data.modes.note ? folded(model ? 'How the line was fitted' : 'Why there is no line', element('p', { class: 'note' }, data.modes.note)) : '');
    const [low, high] = [x[0], x.at(-1)];
    const room = (high - low || 1) * 0.06;
    chart(where, {
        label: 'Shares of modes against vertical stress', x, series, xLabel: 'vertical stress [MPa]', yLabel: 'share of walls', yRange: [-0.02, 1.02], xRange: [low - room, high + room], height: 320,
        draw: (u) => drawIntervals(u, levels.map((l) => ({ x: l.stress, lower: l.lower, upper: l.upper })), '#222222'),
        tip: (i) => {
            const l = levels.find((k) => k.stress === x[i]);
            return l ? `${figures(l.stress)} MPa, ${l.walls} walls\nrocking ${fixed(100 * l.value, 0)} % [${fixed(100 * l.lower, 0)}, ${fixed(100 * l.upper, 0)}]${l.sliding > 0 ? `\nsliding ${fixed(100 * l.sliding, 0)} %` : ''}` : `${fixed(x[i], 2)} MPa`;
        },
    });
}

export function histograms(data, host) {
    const grid = element('div', { class: 'small' });
    host.append(grid);
    for (const h of data.histograms) {
        const where = plot();
        const unit = h.unit === '-' ? '' : ` [${h.unit}]`;
        const facts = [`${h.values} values`, h.sampled && `drawn: ${h.sampled}`, h.prescribed && `prescribed: ${h.prescribed}`].filter(Boolean).join('; ');
        grid.append(element('figure', {}, element('h3', {}, words(h.key)), where, element('figcaption', {}, facts)));
        if (!h.edges) continue;
        const tiny = 1e-6 * (h.edges.at(-1) - h.edges[0]);
        const x = [...new Set([...(h.x ?? []), ...h.edges.flatMap((e) => [e - tiny, e + tiny])])].sort((a, b) => a - b);
        const bars = x.map((v) => (v < h.edges[0] || v > h.edges.at(-1) ? 0 : h.density[Math.min(h.density.length - 1, h.edges.findLastIndex((e) => e <= v))]));
        const series = [{ label: 'drawn', colour: '#56B4E9', fill: '#56B4E955', width: 1, data: bars }];
        if (h.x) series.push({ label: 'prescribed', colour: '#D55E00', data: resample(x, h.x, h.pdf, false), spanGaps: true });
        chart(where, { label: `Histogram of ${words(h.key)}; ${facts}`, x, series, xLabel: words(h.key).split(': ').at(-1) + unit, yLabel: 'density', height: 230 });
    }
    host.append(key([{ label: 'drawn', colour: '#56B4E9', band: true }, { label: 'prescribed', colour: '#D55E00' }]));
}

/** Of the first walls of one stress. @return the chart, or nothing where there are too few */
function runningChart(data, level, host, height) {
    const lines = data.running.filter((r) => r.level === level);
    if (!lines.length) return null;
    const n = Math.max(...lines.map((r) => r.error.length));
    const x = Array.from({ length: n }, (_, i) => i + 1);
    const padded = (v) => x.map((_, i) => v[i - (n - v.length)] ?? null);
    const series = lines.map((r, i) => ({ label: words(r.key), colour: levelColour(i), dash: dashOf(i), data: padded(r.error) }));
    const peak = lines.find((r) => r.key === 'peak force');
    if (peak) series.unshift({ label: 'peak force: 95 % band of independent samples', colour: '#767676', width: 0, band: [padded(peak.band.map((b) => -b)), padded(peak.band)] });
    const most = Math.max(...series.flatMap((s) => (s.data ?? []).map((v) => Math.abs(v ?? 0))), 1);
    const drawn = chart(host, { label: `Error of the mean after a number of walls, ${data.levels[level].name}`, x, series, xLabel: 'walls', wholeX: true, yLabel: 'error of the mean [%]', height, yRange: [-1.15 * most, 1.15 * most] });
    return { drawn, series };
}

export function running(data, host) {
    if (!data.running.length) return host.append(element('p', {}, 'Too few walls.'));
    const where = element('div', {});
    const legend = element('div', {});
    const levels = [...new Set(data.running.map((r) => r.level))];
    let charts = [];
    const show = (chosen) => {
        charts.forEach((c) => c.drawn.remove());
        const shown = chosen === 'all' ? levels : levels.filter((l) => l === chosen);
        const hosts = shown.map(plot);
        where.className = shown.length > 1 ? 'small' : '';
        where.replaceChildren(...shown.map((l, i) => element('figure', {}, element('h3', {}, data.levels[l].name), hosts[i])));
        charts = shown.map((l, i) => runningChart(data, l, hosts[i], shown.length > 1 ? 240 : 320));
        const keys = new Map(charts.flatMap((c) => c.series).map((s) => [s.label, s]));
        legend.replaceChildren(shown.length ? key([...keys.values()]) : element('p', {}, 'Too few walls.'));
    };
    host.append(choice('Stress', everyLevel(data), 'all', show).row, where, legend);
    show('all');
}

const everyLevel = (data) => [{ value: 'all', text: 'all' }, ...data.levels.map((l, i) => ({ value: i, text: l.name }))];

/** Bars to both sides of zero, longest first, with intervals. */
function tornado(bars, measure) {
    const rows = bars.filter((b) => b[measure]).sort((a, b) => Math.abs(b[measure][0]) - Math.abs(a[measure][0]));
    const at = (v) => 50 + 48 * Math.max(-1, Math.min(1, v));
    return element('table', { class: 'tornado' }, element('tbody', {}, ...rows.map((b) => {
        const [v, low, high] = b[measure];
        const svg = element('svg', { viewBox: '0 0 100 10', preserveAspectRatio: 'none', 'aria-hidden': 'true' },
            element('rect', { x: Math.min(at(0), at(v)), y: 2, width: Math.abs(at(v) - at(0)), height: 6, fill: v < 0 ? colours.mixed : colours.rocking }),
            element('line', { x1: at(low), x2: at(high), y1: 5, y2: 5, stroke: '#222', 'stroke-width': 1.5, 'vector-effect': 'non-scaling-stroke' }),
            element('line', { x1: 50, x2: 50, y1: 0, y2: 10, stroke: '#999', 'stroke-width': 1, 'vector-effect': 'non-scaling-stroke' }));
        return element('tr', {}, element('th', { scope: 'row' }, words(b.key)), element('td', { class: 'bar' }, svg), element('td', {}, `${fixed(v, 2)} [${fixed(low, 2)}, ${fixed(high, 2)}]`));
    })));
}

export function sensitivity(data, host) {
    if (!data.inputs.length) return host.append(element('p', {}, 'Nothing was random.'));
    const where = element('div', { class: 'pair' });
    const state = { level: 'all', measure: 'spearman' };
    const show = () => {
        const parts = data.sensitivity.filter((s) => state.level === 'all' || s.level === state.level);
        where.replaceChildren(...parts.map((s) => element('figure', {},
            element('h3', {}, `${data.levels[s.level].name}: ${s.response}, ${s.walls} ${s.walls === 1 ? 'wall' : 'walls'}`),
            s.bars.length ? tornado(s.bars, state.measure) : element('p', {}, `Too few walls: ${data.inputs.length + 4} are needed.`))));
    };
    host.append(
        choice('Stress', everyLevel(data), 'all', (v) => ((state.level = v), show())).row,
        choice('Measure', [{ value: 'spearman', text: 'rank correlation' }, { value: 'prcc', text: 'partial rank correlation' }], 'spearman', (v) => ((state.measure = v), show())).row,
        where);
    show();
}
