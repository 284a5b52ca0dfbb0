// The section "What if" has a slider for each input, and says what the surrogates of the study predict for such a wall.
import { element, choice, fixed, figures, percent, words, colours } from './format.js';
import { modeProbabilities, outside, predicted } from './surrogate.js';

const withUnit = (text, unit) => (unit === '-' ? text : `${text} ${unit}`);
const short = (key) => words(key).split(': ').at(-1);

/** "a", "a and b", "a, b and c" */
const joinedWords = (list) => (list.length < 2 ? list.join('') : `${list.slice(0, -1).join(', ')} and ${list.at(-1)}`);

/** The interval of a prediction over the range of the walls learned from. */
function intervalPicture({ mean, lower, upper }, [least, most]) {
    const [low, high] = [Math.min(least, lower), Math.max(most, upper)];
    const at = (v) => 2 + (96 * (v - low)) / (high - low || 1);
    return element('svg', { viewBox: '0 0 100 10', preserveAspectRatio: 'none', 'aria-hidden': 'true', class: 'range' },
        element('rect', { x: at(least), y: 4, width: at(most) - at(least), height: 2, fill: '#c4c4c4' }),
        element('rect', { x: at(lower), y: 2, width: Math.max(0.5, at(upper) - at(lower)), height: 6, fill: colours.rocking, opacity: 0.35 }),
        element('line', { x1: at(mean), x2: at(mean), y1: 0, y2: 10, stroke: '#222', 'stroke-width': 2, 'vector-effect': 'non-scaling-stroke' }));
}

class WhatIf {
    constructor(data, host) {
        const w = data.whatif;
        Object.assign(this, { data, w, level: 0, place: w.inputs.map((i) => i.start) });
        this.families = w.inputs.map((i) => i.coordinate);
        this.answers = element('div', { class: 'answers' });
        this.spoken = element('p', { class: 'asked', role: 'status' });
        const sliders = element('div', { class: 'controls asking' }, ...w.inputs.map((input, k) => this.slider(input, k)),
            element('div', { class: 'choice' }, element('button', { type: 'button', onclick: () => this.reset() }, 'Median of each input')));
        const stress = choice('Stress', data.levels.map((l, i) => ({ value: i, text: l.name })), 0, (level) => ((this.level = level), this.show(), this.say()));
        host.append(stress.row, element('div', { class: 'pair' }, sliders, this.answers), this.spoken);
        this.reset();
    }

    slider(input, k) {
        const id = `ask-${k}`;
        const range = element('input', {
            type: 'range', id, min: 0, max: input.values.length - 1, step: 1,
            oninput: () => ((this.place[k] = Number(range.value)), this.show()), onchange: () => this.say(),
        });
        const output = element('output', { for: id });
        this.sliders = [...(this.sliders ?? []), { range, output }];
        return element('div', { class: 'slider ask' }, element('label', { for: id }, words(input.key)), output, range);
    }

    reset() {
        this.place = this.w.inputs.map((i) => i.start);
        this.show();
        this.say();
    }

    value(k) {
        return this.w.inputs[k].values[this.place[k]];
    }

    show() {
        const { inputs } = this.w;
        this.sliders.forEach(({ range, output }, k) => {
            range.value = this.place[k];
            output.textContent = withUnit(figures(this.value(k)), inputs[k].unit);
            range.setAttribute('aria-valuetext', output.textContent);
        });
        this.c = inputs.map((input, k) => input.coordinates[this.place[k]]);
        this.answers.replaceChildren(...this.w.responses.map((r) => this.response(r)), this.modes(this.w.modes[this.level]));
    }

    /** A response with its doubt: number, interval, error on walls left out, and in words when it is not to be trusted. */
    response(r) {
        const level = r.levels[this.level];
        const block = element('div', { class: 'answer' }, element('h3', {}, r.name));
        if (!level.better) {
            block.append(element('p', { class: 'note' }, `Not predicted. ${level.doubts.join(' ')}`), ...this.leftOut(level));
            return block;
        }
        const { mean, lower, upper } = this.interval(r);
        const number = (v) => fixed(v, r.decimals);
        const { rmse, q2 } = level[level.better].error;
        const kind = level.better === 'chaos' ? 'polynomial chaos' : 'Gaussian process';
        block.append(
            element('p', { class: 'number' }, element('strong', {}, withUnit(number(mean), r.unit)), ` ${percent({ confidence: this.w.share })} of such walls: ${number(lower)} to ${withUnit(number(upper), r.unit)}`),
            intervalPicture({ mean, lower, upper }, level.range),
            element('p', { class: 'note' }, `Error on walls left out: ${withUnit(number(rmse), r.unit)}, Q2 ${fixed(q2, 2)}. Learned from ${level.walls} walls by a ${kind}.`),
            ...this.doubts(level).map((d) => element('p', { class: 'warning' }, d)),
            ...this.leftOut(level));
        return block;
    }

    leftOut(level) {
        return level.left_out ? [element('details', { class: 'about' }, element('summary', {}, 'Walls left out'), element('p', { class: 'note' }, level.left_out))] : [];
    }

    /** Neither force nor drift is below 0. */
    interval(r) {
        const { mean, sd } = predicted(r.levels[this.level], this.families, this.c);
        const half = this.w.factor * sd;
        return { mean: Math.max(0, mean), lower: Math.max(0, mean - half), upper: Math.max(0, mean + half) };
    }

    /** Sentences on why a prediction is not to be trusted. */
    doubts(level) {
        const { inputs } = this.w;
        const beyond = outside(level, inputs.map((_, k) => this.value(k))).map((k) =>
            `${short(inputs[k].key)} (learned between ${figures(level.learned_between.least[k])} and ${withUnit(figures(level.learned_between.most[k]), inputs[k].unit)})`);
        return [...level.doubts, ...(beyond.length ? [`Outside the walls learned from: ${joinedWords(beyond)}.`] : [])].map((d) => `Not to be trusted. ${d}`);
    }

    modes(m) {
        const block = element('div', { class: 'answer' }, element('h3', {}, 'failure mode'));
        if (m.none) {
            block.append(element('p', { class: 'note' }, m.none));
            return block;
        }
        const p = modeProbabilities(m, this.c);
        let from = 0;
        const parts = p.map(({ value }, k) => {
            const part = element('rect', { x: 100 * from, y: 0, width: 100 * value, height: 10, fill: colours[m.names[k]] });
            from += value;
            return part;
        });
        block.append(
            element('p', { class: 'number' }, ...p.flatMap((_, k) => [k ? ', ' : '', `${m.names[k]} `, element('strong', {}, this.share(p[k]))])),
            element('svg', { viewBox: '0 0 100 10', preserveAspectRatio: 'none', 'aria-hidden': 'true', class: 'range' }, ...parts),
            element('p', { class: 'note' }, `Brackets: ${percent({ confidence: this.w.share })} intervals. The likeliest mode is that of ${fixed(100 * m.error.right, 0)} % of walls left out (Brier skill ${fixed(m.error.skill, 2)}). Learned from ${m.walls} walls by a multinomial logit.`),
            ...m.doubts.map((d) => element('p', { class: 'warning' }, `Not to be trusted. ${d}`)));
        return block;
    }

    /** "83 % [70, 91]": by the normal law on the logit. */
    share({ value, sd }) {
        const logistic = (v) => 100 / (1 + Math.exp(-v));
        if (!(sd > 0) || value <= 0 || value >= 1) return `${fixed(100 * value, 0)} %`;
        const logit = Math.log(value / (1 - value));
        const half = (this.w.factor * sd) / (value * (1 - value));
        return `${fixed(100 * value, 0)} % [${fixed(logistic(logit - half), 0)}, ${fixed(logistic(logit + half), 0)}]`;
    }

    /** The question in words: for those who hear the page, and on paper. */
    say() {
        const { inputs, responses } = this.w;
        const asked = inputs.map((input, k) => `${short(input.key)} ${withUnit(figures(this.value(k)), input.unit)}`);
        const told = responses.filter((r) => r.levels[this.level].better).map((r) => {
            const { mean, lower, upper } = this.interval(r);
            return `${r.name} ${withUnit(fixed(mean, r.decimals), r.unit)}, ${fixed(lower, r.decimals)} to ${fixed(upper, r.decimals)}${this.doubts(r.levels[this.level]).length ? ', not to be trusted' : ''}`;
        });
        this.spoken.textContent = `${this.data.levels[this.level].name}, ${joinedWords(asked)}: ${told.join('; ') || 'not predicted'}.`;
    }
}

export function whatif(data, host) {
    if (data.whatif.none) host.append(element('p', {}, data.whatif.none));
    else new WhatIf(data, host);
}
