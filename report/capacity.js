// Capacity curves: all walls of a stress, or the means of all stresses.
import { element, choice, fixed, figures, percent, words, colours, levelColour } from './format.js';
import { chart, key, overlay, placeTip, dashOf } from './chart.js';
import { Loop } from './loop.js';

const kFewest = 5; // walls of a mean with an interval: that of fewer hides the chart
const modeDash = (mode) => (({ rocking: [], sliding: [2, 3] })[mode] ?? [7, 4]);

export function wallName(data, w) {
    return `${data.levels[data.walls[w].level].name}, sample ${data.walls[w].sample}`;
}

/** What a wall was and did, in lines. */
export function wallText(data, w) {
    const wall = data.walls[w];
    const ultimate = { observed: `ultimate at ${fixed(wall.ultimate_displacement_mm)} mm`, censored: `no ultimate up to ${fixed(wall.ultimate_displacement_mm)} mm`, none: 'no ultimate' };
    const lines = [
        wallName(data, w),
        wall.mode === 'failed' ? `failed: ${wall.reason}` : `${wall.mode}, peak ${fixed(wall.peak_force_kN)} kN, ${ultimate[wall.reading]}`,
        ...data.inputs.map((input, i) => `${input.count > 1 ? 'mean ' : ''}${words(input.key)} ${figures(wall.inputs[i])} ${input.unit === '-' ? '' : input.unit}`),
    ];
    return lines.join('\n');
}

function pointsOf(u, x, forces) {
    const points = [];
    forces.forEach((f, i) => f !== null && points.push(`${u.valToPos(x[i], 'x').toFixed(1)},${u.valToPos(f, 'y').toFixed(1)}`));
    return points.join(' ');
}

export class Capacity {
    /** told: wall(w), a wall was clicked; stress(level), a stress was chosen of which no wall is shown. loops: of a push to and fro, whose walls have a force only along their way; else null. */
    constructor(data, curves, loops, host, told) {
        Object.assign(this, { data, curves, loops, told, level: 0, wall: null, at: null, drawn: null });
        const options = [...data.levels.map((l, i) => ({ value: i, text: l.name })), { value: 'means', text: 'means' }];
        this.picker = choice('Stress', options, 0, (level) => this.show(level));
        this.plot = element('div', { class: 'plot', tabindex: 0, role: 'group', 'aria-label': 'Capacity curves. Arrow keys go from wall to wall by peak force, Enter chooses one.' });
        this.legend = element('div', {});
        this.spoken = element('p', { class: 'spoken', 'aria-live': 'polite' });
        host.append(this.picker.row, this.plot, this.legend, this.spoken);
        this.drawPaper(host);
        this.loop = loops ? new Loop(data, loops, host) : null;
        this.plot.addEventListener('keydown', (e) => this.key(e));
        this.show(0);
    }

    show(level) {
        this.level = level;
        this.drawn?.remove();
        this.hovered = null;
        if (level === 'means') this.drawMeans();
        else this.drawWalls(level);
        this.refresh();
        if (this.wall !== null && level !== 'means' && this.data.walls[this.wall].level !== level) this.told.stress(level);
    }

    /** Walls of the level by peak force. */
    members() {
        const walls = this.data.walls.map((wall, w) => w).filter((w) => this.data.walls[w].level === this.level && this.curves.counts[w] > 1);
        return walls.sort((a, b) => this.data.walls[a].peak_force_kN - this.data.walls[b].peak_force_kN);
    }

    drawWalls(level) {
        const walls = this.members();
        const mode = (w) => this.data.walls[w].mode;
        const thin = (m) => Math.max(0.08, Math.min(0.6, 35 / walls.filter((w) => mode(w) === m).length));
        const alpha = { rocking: thin('rocking'), sliding: thin('sliding'), mixed: thin('mixed'), failed: thin('failed') };
        const series = walls.map((w) => ({ data: this.curves.forces(w), colour: colours[mode(w)], width: 1, alpha: alpha[mode(w)] }));
        const means = this.data.means.filter((m) => m.level === level && m.mode !== 'all');
        for (const m of means) series.push({ ...this.meanSeries(m, colours[m.mode], modeDash(m.mode), `mean of ${m.walls} ${m.mode} walls`), halo: walls.length > 1 });
        this.walls = walls;
        this.drawn = this.plotChart(series, `Force against displacement of ${walls.length} walls under ${this.data.levels[level].name}`);
        const keys = ['rocking', 'sliding', 'mixed', 'failed'].filter((mode) => walls.some((w) => this.data.walls[w].mode === mode));
        this.legend.replaceChildren(key([...keys.map((m) => ({ label: `${m} wall`, colour: colours[m], width: 1 })), ...series.filter((s) => s.label)]),
            element('p', { class: 'note' }, walls.length ? '' : 'No wall under this stress gave a curve.'));
        this.watch();
    }

    /** Means of each stress and mode. */
    meansOfAll() {
        const shown = this.data.means.filter((m) => m.mode !== 'all' && m.walls >= 2);
        return shown.map((m) =>
            this.meanSeries(m, levelColour(m.level), modeDash(m.mode), `${this.data.levels[m.level].name}, ${m.walls} ${m.mode}`),
        );
    }

    /** All stresses, for paper alone: there nobody chooses one. */
    drawPaper(host) {
        const series = this.meansOfAll();
        if (!series.length || this.data.levels.length < 2) return;
        const plot = element('div', { class: 'plot' });
        host.append(element('div', { class: 'paper', 'aria-hidden': 'true' }, element('h3', {}, 'Means under all stresses'), plot, key(series)));
        this.plotOn(plot, series, 'Mean force against displacement of each stress and mode');
    }

    drawMeans() {
        this.walls = [];
        const series = this.meansOfAll();
        this.drawn = this.plotChart(series, `Mean force against displacement of each stress and mode, with ${percent(this.data)} intervals of the mean`);
        this.legend.replaceChildren(key(series), element('p', { class: 'note' }, series.length ? '' : 'No means: they need two walls of a mode.'));
    }

    /** The mean on the displacements of the chart. */
    meanSeries(m, colour, dash, label) {
        const spread = (values) => this.curves.x.map((x) => interpolate(values, x / (m.step * 1e3)));
        const sure = m.walls >= kFewest;
        return { label: `${label}, ${sure ? percent(this.data) : 'no interval'}`, colour, dash, width: 2.5, data: spread(m.mean), band: sure ? [spread(m.lower), spread(m.upper)] : undefined };
    }

    plotChart(series, label) {
        const drawn = this.plotOn(this.plot, series, label, () => this.refresh());
        this.parts = overlay(drawn.u);
        this.tip = drawn.u.over.querySelector('.tip');
        return drawn;
    }

    plotOn(plot, series, label, draw = () => {}) {
        const lines = series.flatMap((s) => [s.data, s.band?.[1]]).filter((values) => values);
        const top = lines.reduce((most, values) => values.reduce((m, f) => Math.max(m, f ?? 0), most), 1);
        return chart(plot, {
            label, series, x: this.curves.x, height: matchMedia('(max-width: 500px)').matches ? 230 : 400, xLabel: 'displacement [mm]', yLabel: 'horizontal force [kN]',
            yRange: [0, top * 1.05], xRange: [0, this.curves.x.at(-1)],
            draw,
        });
    }

    watch() {
        const { u } = this.drawn;
        u.over.addEventListener('mousemove', (e) => this.hover(this.nearest(u, e)));
        u.over.addEventListener('mouseleave', () => this.hover(null));
        u.over.addEventListener('click', (e) => {
            const w = this.nearest(u, e);
            if (w !== null) this.told.wall(w);
        });
    }

    /** The wall whose curve is nearest to the cursor, within 30 px. */
    nearest(u, event) {
        const box = u.over.getBoundingClientRect();
        const [left, top] = [event.clientX - box.left, event.clientY - box.top];
        const i = u.posToIdx(left);
        let best = null;
        let distance = 30;
        for (const w of this.walls) {
            const f = this.curves.forces(w)[i];
            if (f === null) continue;
            const d = Math.abs(u.valToPos(f, 'y') - top);
            if (d < distance) [best, distance] = [w, d];
        }
        this.pointer = { left, top };
        return best;
    }

    hover(w) {
        this.hovered = w;
        this.refresh();
        if (w === null) return void (this.tip.hidden = true);
        placeTip(this.drawn.u, this.tip, wallText(this.data, w), this.pointer.left, this.pointer.top);
    }

    key(e) {
        if (!this.walls.length) return;
        const here = this.walls.indexOf(this.hovered ?? this.wall);
        const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[e.key];
        if (step) {
            const next = this.walls[(here + step + this.walls.length) % this.walls.length];
            const { u } = this.drawn;
            const peak = this.data.walls[next];
            this.pointer = { left: u.valToPos(peak.peak_displacement_mm ?? 0, 'x'), top: u.valToPos(peak.peak_force_kN ?? 0, 'y') };
            this.hover(next);
            this.spoken.textContent = wallText(this.data, next);
        } else if ((e.key === 'Enter' || e.key === ' ') && this.hovered !== null) this.told.wall(this.hovered);
        else return;
        e.preventDefault();
    }

    /** The wall that is shown, at displacement d [mm] and frame t; null: the page has no film of it. */
    mark(wall, d, t) {
        this.wall = wall;
        this.at = this.loop ? null : d;
        this.loop?.mark(wall, t);
        const level = this.data.walls[wall].level;
        if (this.level !== level && this.level !== 'means') this.picker.set(level);
        else this.refresh();
    }

    /** Of a wall at displacement d [mm], or at a frame of its film where it goes to and fro [kN]. */
    force(wall, d, frame) {
        if (this.loops) return this.loops.at(wall, frame)?.f ?? null;
        const t = d / this.curves.x[1];
        const forces = this.curves.forces(wall);
        // the last point of a curve lies half an interval before its end
        return interpolate(forces, t) ?? forces.findLast((f) => f !== null) ?? null;
    }

    refresh() {
        if (!this.drawn || !this.parts) return;
        const { u } = this.drawn;
        if (!Number.isFinite(u.valToPos(0, 'x'))) return; // a new chart: it calls again when it is drawn
        const line = (w) => (w === null || w === undefined || !this.walls.includes(w) ? '' : pointsOf(u, this.curves.x, this.curves.forces(w)));
        this.parts.hovered.setAttribute('points', line(this.hovered));
        this.parts.chosen.setAttribute('points', line(this.wall));
        const f = this.at !== null && this.wall !== null && this.walls.includes(this.wall) ? this.force(this.wall, this.at) : null;
        this.parts.dot.setAttribute('visibility', f === null ? 'hidden' : 'visible');
        if (f === null) return;
        this.parts.dot.setAttribute('cx', u.valToPos(this.at, 'x'));
        this.parts.dot.setAttribute('cy', u.valToPos(f, 'y'));
    }
}

/** Between entries i and i + 1 of a list; null where one is missing. */
export function interpolate(values, t) {
    const i = Math.max(0, Math.min(values.length - 1, Math.floor(t + 1e-9)));
    if (t > values.length - 1 + 1e-6) return null;
    const a = values[i];
    const b = values[Math.min(values.length - 1, i + 1)];
    if (a === null || a === undefined) return null;
    return b === null || b === undefined ? a : a + (t - i) * (b - a);
}
