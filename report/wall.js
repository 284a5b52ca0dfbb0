// The wall itself, deformed, from preload to end.
import { element, choice, fixed } from './format.js';
import { readFilm } from './data.js';
import { wallName, wallText } from './capacity.js';

const kStones = ['#e9e2d3', '#e2d9c6', '#efe9dd'];
// The colours are those of wall.svg (app/output/picture/wall_marks.hpp).
const kMarks = { opening: '#6aa5d6', slip: '#e08214', cracks: '#c8102e', crushing: '#5e2a84' };
const kThreshold = 1e-4; // openings and slips up to this are not marked [m]
const kSeconds = 6; // of a film

/** Blocks and faces as SVG, in millimetres, z upwards. */
class Drawing {
    constructor(geometry, height) {
        this.geometry = geometry;
        const xs = geometry.blocks.flatMap((b) => [b[0], b[2]]);
        const zs = geometry.blocks.flatMap((b) => [b[1], b[3]]);
        this.size = { x0: Math.min(...xs), x1: Math.max(...xs), z1: Math.max(...zs), height };
        this.k = this.size.z1 / 1.1; // marks and arrow grow with the wall
        const m = 0.17 * this.size.z1;
        const box = [this.size.x0 - 1.25 * m, -this.size.z1 - 1.3 * m, this.size.x1 - this.size.x0 + 2.75 * m, this.size.z1 + 1.7 * m].map((v) => v * 1e3);
        this.svg = element('svg', { viewBox: box.join(' '), role: 'img', class: 'wall' });
        const group = (c) => this.svg.appendChild(element('g', { class: c }));
        this.ghosts = group('ghosts');
        for (const b of geometry.blocks) {
            if (b[6]) this.ghosts.append(element('polygon', { points: b[6].map(([x, z]) => `${(x * 1e3).toFixed(1)},${(-z * 1e3).toFixed(1)}`).join(' ') }));
            else this.ghosts.append(element('rect', { x: b[0] * 1e3, y: -b[3] * 1e3, width: (b[2] - b[0]) * 1e3, height: (b[3] - b[1]) * 1e3 }));
        }
        this.svg.append(element('line', { class: 'ground', x1: box[0], x2: box[0] + box[2], y1: 0, y2: 0 }));
        // Gaps lie below the stones: what these leave free is the opening, without overlaps.
        const gaps = group('gaps');
        this.gaps = geometry.faces.map(([kind]) => {
            const colour = kMarks[kind === 'crack' ? 'cracks' : 'opening'];
            return gaps.appendChild(element('polygon', { fill: colour, stroke: colour })); // its border closes hairlines
        });
        // Below the stones, so that half of this line is left around what stands free.
        const outlines = group('outlines');
        this.outlines = geometry.blocks.map(() => outlines.appendChild(element('polygon')));
        const stones = group('stones');
        this.blocks = geometry.blocks.map((b) => stones.appendChild(element('polygon', { fill: b[4] === 0 ? '#c9ccd1' : kStones[b[5] % 3] })));
        // Joints in full, cracks that may open in a unit as a trace: the bond is read off the joints.
        const joints = group('joints');
        this.joints = geometry.faces.map(([kind]) => joints.appendChild(element('line', { class: kind === 'crack' ? 'within' : 'between' })));
        const marks = group('marks');
        this.faces = geometry.faces.map((_, i) => ({ gap: this.gaps[i], line: marks.appendChild(element('line')) }));
        // Squares at the ends of faces where stone crushes; each picture has its own.
        this.crushed = group('crushed');
        this.arrow = this.svg.appendChild(element('path', { class: 'load', 'stroke-width': 7 * this.k }));
        this.load = this.svg.appendChild(element('text', { class: 'load', 'text-anchor': 'start', 'font-size': 42 * this.k }));
        // The beam, or without one the block at the left edge that is nearest to the height of the load.
        const beam = geometry.blocks.findIndex((b) => b[4] === 0);
        const far = (b) => Math.abs(b[0] - this.size.x0) + Math.abs((b[1] + b[3]) / 2 - height);
        this.loaded = beam >= 0 ? beam : geometry.blocks.reduce((best, b, i) => (far(b) < far(geometry.blocks[best]) ? i : best), 0);
        const crack = { n: 0 };
        this.crackOf = geometry.faces.map((f) => (f[0] === 'crack' ? crack.n++ : -1));
    }

    /** Displacement of a point of a block [m]. */
    moved(film, block, x, z, t) {
        if (block < 0) return [0, 0];
        const b = this.geometry.blocks[block];
        const xi = (2 * x - b[0] - b[2]) / (b[2] - b[0]);
        const zeta = (2 * z - b[1] - b[3]) / (b[3] - b[1]);
        const u = (k) => film.motion(block, k, t) + xi * film.motion(block, k + 2, t) + zeta * film.motion(block, k + 4, t);
        return [u(0), u(1)];
    }

    /** What the two sides of a face do at its two ends. */
    state(film, i, t) {
        const [kind, , a, b, x0, z0, x1, z1, ...normal] = this.geometry.faces[i];
        const [nx, nz] = normal.length ? normal : Math.abs(z1 - z0) < Math.abs(x1 - x0) ? [0, 1] : [1, 0];
        const ends = [[x0, z0], [x1, z1]].map(([x, z]) => {
            const ua = this.moved(film, a, x, z, t);
            const ub = this.moved(film, b, x, z, t);
            const d = [ub[0] - ua[0], ub[1] - ua[1]];
            return { x, z, ua, ub, opening: d[0] * nx + d[1] * nz, slip: d[0] * nz - d[1] * nx };
        });
        const slip = Math.max(...ends.map((e) => Math.abs(e.slip)));
        return { kind, ends, opening: Math.max(...ends.map((e) => e.opening)), slip, closed: Math.min(...ends.map((e) => e.opening)) <= kThreshold, damage: this.crackOf[i] < 0 ? 0 : film.damage(this.crackOf[i], t) };
    }

    /** Largest opening and slip at frame t of a film [m]. */
    largest(film, t) {
        const states = this.geometry.faces.map((f, i) => this.state(film, i, t));
        const most = (k) => Math.max(2 * kThreshold, ...states.map((s) => (k === 'opening' || s.closed ? s[k] : 0)));
        return { opening: most('opening'), slip: most('slip') };
    }

    draw(film, t, scale, shown, largest, force) {
        const px = (x, z, u) => `${((x + scale * u[0]) * 1e3).toFixed(1)},${(-(z + scale * u[1]) * 1e3).toFixed(1)}`;
        this.geometry.blocks.forEach((b, i) => {
            const corner = (x, z) => px(x, z, this.moved(film, i, x, z, t));
            const corners = b[6] ?? [[b[0], b[1]], [b[2], b[1]], [b[2], b[3]], [b[0], b[3]]];
            const points = corners.map(([x, z]) => corner(x, z)).join(' ');
            this.blocks[i].setAttribute('points', points);
            this.outlines[i].setAttribute('points', points);
        });
        this.faces.forEach((f, i) => {
            const state = this.state(film, i, t);
            this.drawJoint(this.joints[i], state, px);
            this.drawFace(f, state, px, shown, largest);
        });
        this.drawCrushing(film, t, px, shown);
        this.drawLoad(film, t, scale, force);
    }

    drawCrushing(film, t, px, shown) {
        const squares = [];
        const side = 20 * this.k;
        if (film.crushes && (shown === 'all' || shown === 'cracks'))
            this.geometry.faces.forEach((f, i) => {
                for (const half of [0, 1]) {
                    const lost = film.crushing(i, half, t);
                    if (lost <= 0) continue;
                    const [x, z] = half ? [f[6], f[7]] : [f[4], f[5]];
                    const [cx, cy] = px(x, z, this.moved(film, f[3] >= 0 ? f[3] : f[2], x, z, t)).split(',').map(Number);
                    squares.push(element('rect', { x: cx - side / 2, y: cy - side / 2, width: side, height: side, fill: kMarks.crushing, 'fill-opacity': (0.25 + 0.75 * lost).toFixed(2), stroke: kMarks.crushing, 'stroke-width': 2 * this.k }));
                }
            });
        this.crushed.replaceChildren(...squares);
    }

    /** The middle between both sides; of an open joint the edges of the stones are seen. */
    drawJoint(line, s, px) {
        line.setAttribute('visibility', s.opening > kThreshold ? 'hidden' : 'visible');
        s.ends.forEach((e, j) => {
            const [x, y] = px(e.x, e.z, [(e.ua[0] + e.ub[0]) / 2, (e.ua[1] + e.ub[1]) / 2]).split(',');
            line.setAttribute(`x${j + 1}`, x);
            line.setAttribute(`y${j + 1}`, y);
        });
    }

    drawFace(face, s, px, shown, largest) {
        const wants = (k) => shown === 'all' || shown === k;
        const crack = s.kind === 'crack';
        const open = wants(crack ? 'cracks' : 'opening') && s.opening > kThreshold;
        face.gap.setAttribute('visibility', open ? 'visible' : 'hidden');
        if (open) {
            const [p, q] = s.ends;
            face.gap.setAttribute('points', [px(p.x, p.z, p.ua), px(q.x, q.z, q.ua), px(q.x, q.z, q.ub), px(p.x, p.z, p.ub)].join(' '));
        }
        const what = crack && wants('cracks') && s.damage > 0.004 ? 'cracks' : !crack && wants('slip') && s.slip > kThreshold && s.closed ? 'slip' : null;
        face.line.setAttribute('visibility', what ? 'visible' : 'hidden');
        if (!what) return;
        const share = what === 'cracks' ? s.damage : Math.min(1, s.slip / largest.slip);
        const ends = s.ends.map((e) => px(e.x, e.z, [(e.ua[0] + e.ub[0]) / 2, (e.ua[1] + e.ub[1]) / 2]).split(','));
        ['x1', 'y1'].forEach((k, j) => face.line.setAttribute(k, ends[0][j]));
        ['x2', 'y2'].forEach((k, j) => face.line.setAttribute(k, ends[1][j]));
        face.line.setAttribute('stroke', kMarks[what]);
        face.line.setAttribute('stroke-width', (this.k * (what === 'cracks' ? 8 : 4 + 10 * share)).toFixed(1));
        face.line.setAttribute('stroke-dasharray', what === 'cracks' && s.damage < 0.999 ? `${14 * this.k} ${8 * this.k}` : 'none');
    }

    drawLoad(film, t, scale, force) {
        const beam = this.loaded;
        const b = this.geometry.blocks[beam];
        // Where the force is not known the arrow points to where the beam has gone.
        const left = force ? force.value < 0 : this.moved(film, beam, b[0], b[3], t)[0] < 0;
        const side = left ? b[2] : b[0];
        const way = left ? -1 : 1;
        const u = this.moved(film, beam, side, b[3], t);
        const tip = [(side + scale * u[0]) * 1e3 - way * 12 * this.k, -(this.size.height + scale * u[1]) * 1e3];
        const length = way * this.k * (60 + 90 * (force?.share ?? 0));
        this.arrow.setAttribute('d', `M${tip[0] - length} ${tip[1]}H${tip[0] - way * 30 * this.k}M${tip[0]} ${tip[1]}l${-way * 34 * this.k} ${-16 * this.k}v${32 * this.k}z`);
        this.load.textContent = force ? `${fixed(force.value)} kN` : '';
        this.load.setAttribute('x', tip[0] - length);
        this.load.setAttribute('text-anchor', left ? 'end' : 'start');
        this.load.setAttribute('y', tip[1] - 28 * this.k);
    }
}

/** The frame at which a wall is farthest out, the last of equals: of a push one way its end. */
function farthest(film) {
    let best = film.frames - 1;
    for (let t = best; t >= 0; --t) if (Math.abs(film.displacement(t)) > Math.abs(film.displacement(best)) * (1 + 1e-6)) best = t;
    return best;
}

export class WallView {
    /** capacity: where curve and place are marked; null without curves. */
    constructor(data, host, capacity) {
        Object.assign(this, { data, capacity, t: 0, scale: 5, shown: 'all', film: null, playing: false });
        this.films = data.films.films;
        this.byWall = new Map(this.films.map((f) => [f.wall, f]));
        this.drawings = new Map(); // of each layout of the stones
        this.figure = element('figure', {}, (this.caption = element('figcaption', {})));
        this.show(0);
        this.still = matchMedia('(prefers-reduced-motion: reduce)');
        host.append(this.figure, this.controls(), this.legend());
    }

    controls() {
        const slider = (label, attributes, input) => {
            const range = element('input', { type: 'range', ...attributes, oninput: () => input(Number(range.value)) });
            return { range, row: element('label', { class: 'slider' }, element('span', {}, label), range) };
        };
        this.picker = element('select', { id: 'wall-choice', onchange: () => this.open(Number(this.picker.value)) });
        this.data.levels.forEach((level, l) => {
            const walls = this.films.map((f) => f.wall).filter((w) => this.data.walls[w]?.level === l);
            const options = walls.map((w) => element('option', { value: w }, `${wallName(this.data, w)}, ${this.data.walls[w].mode}`));
            this.picker.append(element('optgroup', { label: level.name }, ...options));
        });
        this.button = element('button', { type: 'button', class: 'play', onclick: () => this.play(!this.playing) }, 'Play');
        this.place = slider('Push', { min: 0, max: 1, step: 0.001, value: 0, id: 'push' }, (t) => (this.play(false), this.go(t * (this.film.frames - 1))));
        this.zoom = slider('Magnified', { min: 0, max: 1, step: 0.01, id: 'magnification' }, (v) => ((this.scale = 100 ** v), this.draw()));
        this.factor = element('output', { for: 'magnification' });
        this.zoom.row.append(this.factor);
        const colour = choice('Show', ['all', 'opening', 'slip', 'cracks'].map((v) => ({ value: v, text: v })), 'all', (v) => ((this.shown = v), this.draw()));
        return element('div', { class: 'controls' },
            element('label', { class: 'pick', for: 'wall-choice' }, element('span', {}, 'Wall'), this.picker),
            element('div', { class: 'push' }, this.button, this.place.row),
            this.zoom.row, colour.row);
    }

    legend() {
        this.keys = element('ul', { class: 'key' });
        return this.keys;
    }

    /** Puts the drawing of a layout into the figure. */
    show(geometry) {
        const known = this.drawings.get(geometry) ?? new Drawing(this.data.films.geometries[geometry], this.data.height);
        this.drawings.set(geometry, known);
        this.drawing?.svg.remove();
        this.drawing = known;
        this.figure.prepend(known.svg);
    }

    /** The same sample under another stress, or else the first wall of it that can be shown; null: none. */
    counterpart(level) {
        const sample = this.data.walls[this.wall]?.sample;
        const there = this.films.map((f) => f.wall).filter((w) => this.data.walls[w].level === level);
        return there.find((w) => this.data.walls[w].sample === sample) ?? there[0] ?? null;
    }

    async open(wall) {
        const stored = this.byWall.get(wall);
        this.play(false);
        this.wall = wall;
        if (!stored) return this.without(wall);
        const film = await readFilm(stored, this.data.films.geometries[stored.geometry]);
        if (this.wall !== wall) return; // another was chosen meanwhile
        this.film = film;
        this.show(stored.geometry);
        this.enable(true);
        this.picker.value = String(wall);
        const out = farthest(this.film);
        this.largest = this.drawing.largest(this.film, out);
        const end = Math.max(1e-6, ...[...this.drawing.blocks.keys()].map((b) => Math.hypot(this.film.motion(b, 0, out), this.film.motion(b, 1, out))));
        this.scale = Math.max(1, Math.min(100, Math.floor((0.16 * this.drawing.size.z1) / end)));
        this.zoom.range.value = Math.log(this.scale) / Math.log(100);
        this.describe();
        this.go(out);
    }

    /** A wall that the page has no room for, or that failed. */
    without(wall) {
        const { level, sample, mode, reason } = this.data.walls[wall];
        const why = mode === 'failed' ? `failed: ${reason}.` : 'is not among the walls drawn on this page.';
        this.film = null;
        this.enable(false);
        this.picker.value = '';
        this.drawing.svg.setAttribute('aria-label', 'No wall is drawn.');
        this.caption.replaceChildren(`${wallName(this.data, wall)} ${why} To push and draw it: `, element('code', {}, `drystone push ${this.data.file} --sample ${sample} --level ${this.data.levels[level].stress}`));
        this.capacity?.mark(wall, null, null);
    }

    enable(on) {
        for (const control of [this.button, this.place.range, this.zoom.range]) control.disabled = !on;
        this.drawing.svg.classList.toggle('absent', !on);
        this.keys.hidden = !on;
    }

    describe() {
        this.drawing.svg.setAttribute('aria-label', `Deformed wall. ${wallText(this.data, this.wall).replaceAll('\n', ', ')}`);
        const item = (k, text) => element('li', {}, element('svg', { width: 28, height: 12, 'aria-hidden': 'true' }, element('rect', { x: 0, y: k === 'opening' ? 0 : 3, width: 28, height: k === 'opening' ? 12 : 6, fill: kMarks[k] })), text);
        const mm = (v) => fixed(v * 1e3, 1);
        this.keys.replaceChildren(
            item('opening', `open joint, up to ${mm(this.largest.opening)} mm; drawn to scale`),
            item('slip', `slip of a closed joint: wider with slip, up to ${mm(this.largest.slip)} mm`),
            item('cracks', 'crack in a unit; dashed: not through'),
            ...(this.film.crushes ? [item('crushing', 'end of a joint or crack where stone crushes; full: crushed through')] : []));
    }

    /** To frame t, between frames too. */
    go(t) {
        this.t = Math.max(0, Math.min(this.film.frames - 1, t));
        this.place.range.value = this.film.frames > 1 ? this.t / (this.film.frames - 1) : 0;
        this.draw();
    }

    draw() {
        if (!this.film) return;
        const d = this.film.displacement(this.t) * 1e3;
        const f = this.capacity?.force(this.wall, d, this.t) ?? null;
        const force = f === null ? null : { value: f, share: Math.min(1, Math.abs(f / (this.data.walls[this.wall].peak_force_kN || 1))) };
        this.drawing.draw(this.film, this.t, this.scale, this.shown, this.largest, force);
        this.factor.textContent = `${fixed(this.scale, this.scale < 10 ? 1 : 0)} times`;
        const drift = fixed(d / (10 * this.data.height), 2);
        this.caption.textContent = `${wallName(this.data, this.wall)}: ${fixed(d, 1)} mm, drift ${drift} %${f === null ? '' : `, ${fixed(f)} kN`}`;
        this.place.range.setAttribute('aria-valuetext', this.caption.textContent);
        this.capacity?.mark(this.wall, d, this.t);
    }

    play(on) {
        this.playing = on && this.film !== null;
        this.button.textContent = this.playing ? 'Pause' : 'Play';
        if (!this.playing) return;
        if (this.t >= this.film.frames - 1) this.go(0);
        const [begin, from] = [performance.now(), this.t];
        const step = (now) => {
            if (!this.playing) return;
            const t = from + ((now - begin) / 1e3) * ((this.film.frames - 1) / kSeconds);
            // without smooth motion where the reader asked for less of it: ten still pictures
            const still = Math.floor((t * 10) / (this.film.frames - 1)) * ((this.film.frames - 1) / 10);
            this.go(this.still.matches ? still : t);
            if (t >= this.film.frames - 1) return this.play(false);
            requestAnimationFrame(step);
        };
        requestAnimationFrame(step);
    }
}
