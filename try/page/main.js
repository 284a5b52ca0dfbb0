// The page: controls, a push beside it, what came out.
import { drawChart } from './chart.js';
import { openEngine } from './engine.js';
import { kControls, kExamples, kGroups, kScatter, linkOf, manyText, placeOf, studyText, usualValues, valuesOfLink } from './study.js';
import { colour, drawWall } from './wall_picture.js';

const $ = (id) => document.getElementById(id);
const kFrames = 90;
const kMany = 50;

let module;
let engine;
let keys = new Map();
let values = usualValues();
let scatter = Object.fromEntries(kScatter.map((s) => [s.key, s.cov]));
let look = null; // of the wall as it stands
let run = null; // {scene, frames, curve, result, worker}: of the last push
let many = null; // {walls, workers, texts}
let shown = 0; // frame of `run`
let playing = 0;

function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (key in made && typeof value !== 'string') made[key] = value;
        else made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
}

const digits = (x, n = 3) => (x === null || x === undefined ? '–' : Number(x.toPrecision(n)).toString());
const fixed = (x, n) => (x === null || x === undefined ? '–' : x.toFixed(n));

/* ---- pictures ---- */

const kScales = [1, 2, 3, 5, 10, 20, 50];

function scaleOf() {
    const chosen = Number($('scale').value);
    if (chosen > 0 || look === null) return chosen || 1;
    const most = (0.12 * Math.min(look.length, look.load_height)) / (1e-3 * look.farthest_mm);
    return kScales.filter((s) => s <= most).at(-1) ?? 1;
}

function showWall() {
    if (look === null) return;
    const frame = run?.frames[shown] ?? null;
    const scene = frame ? run.scene : look;
    const scale = scaleOf();
    drawWall($('wall'), scene, frame, { scale, farthest: frame || run ? 1e-3 * look.farthest_mm : 0, direction: look.direction, load: `${digits(look.stress_MPa)} MPa` });
    $('moment').textContent = frame ? `${fixed(frame.mm, 1)} mm, ${fixed(frame.kN, 1)} kN${scale > 1 ? `; drawn ${scale} times larger` : ''}` : 'before the push';
}

let chart = null;
function showCurve(at = null) {
    const turn = look?.direction < 0 ? -1 : 1;
    const curve = run?.result?.curve ? { x: run.result.curve.displacement_mm, y: run.result.curve.force_kN } : (run?.curve ?? { x: [], y: [] });
    const x = curve.x.map((v) => turn * v);
    const y = curve.y.map((v) => turn * v);
    const summary = run?.result?.summary;
    const dots = [];
    const levels = [];
    if (summary) {
        const u = summary.ultimate_displacement_mm;
        if (summary.peak_force_kN !== null) dots.push({ x: summary.peak_displacement_mm, y: summary.peak_force_kN, text: `peak ${fixed(summary.peak_force_kN, 1)} kN`, colour: colour('--accent') });
        if (u !== null && !summary.ultimate_censored) dots.push({ x: u, y: 0.8 * summary.peak_force_kN, text: `80 %: ${fixed(u, 1)} mm`, colour: colour('--crack') });
        const checks = summary.hand_checks;
        if (checks.rigid_rocking_limit_kN !== null) levels.push({ y: checks.rigid_rocking_limit_kN, text: 'rigid rocking' });
        if (checks.sliding_limit_kN !== null) levels.push({ y: checks.sliding_limit_kN, text: 'sliding' });
    }
    const frame = run?.frames[shown];
    if (run?.result && at === null && frame && (playing || shown < run.frames.length - 1)) dots.push({ x: turn * frame.mm, y: turn * frame.kN, colour: colour('--ink') });
    if (at !== null) dots.push({ ...at, colour: colour('--ink') });
    const most = Math.max(run === null ? 50 : 1, ...y, ...levels.filter((l) => l.y < 2 * Math.max(...y)).map((l) => l.y));
    chart = drawChart($('curve'), {
        x: { title: 'displacement of the top [mm]', most: look?.farthest_mm ?? 30 },
        y: { title: 'force [kN]', most: 1.05 * most },
        lines: [{ x, y, colour: colour('--accent'), width: 2.4 }],
        levels,
        dots,
    });
    chart.curve = { x, y };
    $('hint').hidden = run !== null;
}

function showAll() {
    showWall();
    showCurve();
    showMany();
}

/* ---- the wall as it is asked for ---- */

function complain(message, keyed = null) {
    for (const field of document.querySelectorAll('.field.bad')) {
        field.classList.remove('bad');
        field.querySelector('.said')?.remove();
        field.querySelector('input, select, textarea').removeAttribute('aria-invalid');
    }
    $('trouble').hidden = message === null;
    $('trouble').textContent = message ?? '';
    const field = keyed && document.querySelector(`.field[data-key="${CSS.escape(keyed)}"]`);
    if (!field) return;
    field.classList.add('bad');
    field.querySelector('input, select, textarea').setAttribute('aria-invalid', 'true');
    field.append(element('p', { class: 'said' }, placeOf(message).words));
    field.closest('details').open = true;
}

function changed() {
    endPush();
    run = null;
    $('answers').hidden = true;
    for (const id of ['csv', 'svg-curve', 'svg-wall', 'play', 'scrubber']) $(id).hidden = true;
    $('status').textContent = '';
    const seen = engine.look(studyText(values, keys));
    if (seen.ended) reopen();
    if (seen.error) {
        const { key } = placeOf(seen.error);
        complain(seen.error, key === 'load.targets' ? 'load.max_displacement' : key);
    } else {
        complain(null);
        look = seen;
        $('status').textContent = seen.notes.trim().split('\n')[0].replace(/^note: /, '');
    }
    $('push').disabled = Boolean(seen.error);
    $('push-many').disabled = Boolean(seen.error);
    const link = linkOf(values);
    try {
        history.replaceState(null, '', link || location.pathname);
    } catch {
        // a page from a folder may not be allowed to change its address
    }
    for (const chip of $('examples').children) chip.setAttribute('aria-pressed', String(chip.dataset.link === link));
    showWall();
    showCurve();
}

let late = 0;
function changedSoon() {
    clearTimeout(late);
    late = setTimeout(changed, 120);
}

async function reopen() {
    engine = await openEngine(module);
}

/* ---- one push ---- */

function startWorker(job, onMessage) {
    const source = URL.createObjectURL(new Blob([$('worker').textContent], { type: 'text/javascript' }));
    const worker = new Worker(source);
    worker.onmessage = ({ data }) => onMessage(data, worker);
    worker.onerror = (event) => onMessage({ kind: 'done', value: { error: event.message || 'the worker did not start' } }, worker);
    worker.postMessage({ module, ...job });
    return worker;
}

function endPush() {
    run?.worker?.terminate();
    if (run) run.worker = null;
    playing = 0;
    $('play').textContent = 'Play';
    $('stop').hidden = $('progress').hidden = true;
    $('push').hidden = false;
}

function push() {
    clearTimeout(late);
    changed();
    if ($('push').disabled) return;
    const mine = { scene: null, frames: [], curve: { x: [0], y: [0] }, result: null, worker: null };
    run = mine;
    shown = 0;
    const begin = performance.now();
    $('push').hidden = true;
    $('stop').hidden = $('progress').hidden = false;
    $('progress').value = 0;
    $('stop').focus({ preventScroll: true });
    let drawing = false;
    const soon = () => {
        if (drawing) return;
        drawing = true;
        requestAnimationFrame(() => {
            drawing = false;
            if (run !== mine) return;
            showWall();
            showCurve();
        });
    };
    mine.worker = startWorker({ job: 'push', study: studyText(values, keys), frames: kFrames }, ({ kind, value }, worker) => {
        if (run !== mine) return;
        if (kind === 'progress') {
            $('progress').value = value.done;
            $('status').textContent = `${fixed(value.kN, 1)} kN at ${fixed(value.mm, 1)} mm`;
            if (value.mm !== mine.curve.x.at(-1)) {
                mine.curve.x.push(value.mm);
                mine.curve.y.push(value.kN);
            }
            soon();
        } else if (kind === 'begin') {
            mine.scene = value;
        } else if (kind === 'again') {
            mine.frames = [];
            mine.scene ??= null;
            mine.curve = { x: [0], y: [0] };
            shown = 0;
        } else if (kind === 'frame') {
            mine.frames.push(value);
            shown = mine.frames.length - 1;
            soon();
        } else if (kind === 'done') {
            worker.terminate();
            mine.worker = null;
            finish(mine, value, (performance.now() - begin) / 1e3);
        }
    });
}

function finish(mine, result, seconds) {
    endPush();
    $('push').focus({ preventScroll: true });
    document.documentElement.dataset.seconds = seconds.toFixed(2);
    document.documentElement.dataset.bytes = String(result.bytes ?? 0);
    if (result.error) {
        $('status').textContent = '';
        complain(result.error, placeOf(result.error).key);
        return;
    }
    mine.result = result;
    shown = Math.max(0, mine.frames.length - 1);
    $('status').textContent = `computed in ${seconds.toFixed(1)} s`;
    answers(result);
    const moves = mine.frames.length > 1;
    $('play').hidden = $('scrubber').hidden = !moves;
    $('scrub').max = String(mine.frames.length - 1);
    $('scrub').value = String(shown);
    showWall();
    showCurve();
}

function answers({ summary, limits }) {
    const failed = summary.peak_force_kN === null;
    const tiles = [
        ['Peak force', failed ? '–' : fixed(summary.peak_force_kN, 2), 'kN'],
        ['at', fixed(summary.peak_displacement_mm, 1), 'mm'],
        ['Down to 80 % at', summary.ultimate_displacement_mm === null ? '–' : (summary.ultimate_censored ? '> ' : '') + fixed(summary.ultimate_displacement_mm, 1), 'mm'],
        ['Mode', summary.mode ?? summary.outcome, ''],
        ['Cracked stones', String(summary.mechanism.cracked_units), ''],
        ['Stiffness', fixed(summary.secant_stiffness_kN_per_mm, 1), 'kN/mm'],
        ['Solver error', summary.solver_error_percent === null ? '–' : digits(summary.solver_error_percent, 2), '%'],
    ];
    $('tiles').replaceChildren(...tiles.map(([name, value, unit]) => element('div', {}, element('dt', {}, name), element('dd', {}, value, ' ', element('small', {}, unit)))));
    const head = element('tr', {}, ...['Limit state', 'mm', 'drift %', ''].map((t) => element('th', { scope: 'col' }, t)));
    const rows = limits.map((l) => {
        const known = l.reading !== 'not defined';
        const mark = l.reading === 'censored' ? '> ' : '';
        return element('tr', { title: l.rule }, element('td', {}, l.name), element('td', {}, known ? mark + fixed(l.displacement_mm, 2) : '–'), element('td', {}, known ? mark + fixed(l.drift_percent, 3) : '–'), element('td', { class: 'note' }, l.reason));
    });
    $('limits').replaceChildren(element('thead', {}, head), element('tbody', {}, ...rows));
    const c = summary.hand_checks;
    const checks = [
        ['Vertical load on the top', c.vertical_load_kN, 'kN'],
        ['Weight of what can turn', c.wall_weight_kN, 'kN'],
        ['Rocking as a rigid body', c.rigid_rocking_limit_kN, 'kN'],
        ['Sliding (Coulomb)', c.sliding_limit_kN, 'kN'],
        ['Largest compression at the toe', c.toe_stress_MPa, 'MPa'],
        ['Energy balance misses', summary.energy_residual === null ? null : 100 * summary.energy_residual, '%'],
    ];
    $('checks').replaceChildren(...checks.flatMap(([name, value, unit]) => [element('dt', {}, name), element('dd', {}, value === null ? 'no closed form' : `${digits(value)} ${unit}`)]));
    const remarks = [...c.remarks, ...(summary.no_reading ? [summary.no_reading] : [])];
    $('remarks').replaceChildren(...remarks.map((r) => element('li', {}, r)));
    $('answers').hidden = false;
    for (const id of ['csv', 'svg-curve', 'svg-wall']) $(id).hidden = !run.result['capacity.csv'];
}

/* ---- many walls ---- */

function endMany() {
    for (const worker of many?.workers ?? []) worker.terminate();
    if (many) many.workers = [];
    $('stop-many').hidden = $('progress-many').hidden = true;
    $('push-many').hidden = false;
}

function pushMany() {
    endMany();
    const study = manyText(values, keys, scatter, kMany);
    const seen = engine.look(study);
    if (seen.error) {
        $('status-many').textContent = seen.error;
        return;
    }
    const team = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, 16));
    const begin = performance.now();
    const mine = { walls: [], workers: [], left: team, farthest: seen.farthest_mm, direction: seen.direction };
    many = mine;
    $('push-many').hidden = $('csv-many').hidden = true;
    $('stop-many').hidden = $('progress-many').hidden = $('many-pictures').hidden = false;
    $('progress-many').value = 0;
    for (let i = 0; i < team; ++i)
        mine.workers.push(
            startWorker({ job: 'walls', study, first: i, step: team }, ({ kind, value }, worker) => {
                if (many !== mine) return;
                if (kind === 'wall') {
                    mine.walls.push(value);
                    $('progress-many').value = mine.walls.length / kMany;
                    $('status-many').textContent = `${mine.walls.length} of ${kMany} walls`;
                    offerLimits();
                    showMany();
                } else if (kind === 'done') {
                    worker.terminate();
                    if (value.error) {
                        endMany();
                        $('status-many').textContent = value.error;
                    } else if (--mine.left === 0) {
                        endMany();
                        const seconds = (performance.now() - begin) / 1e3;
                        $('csv-many').hidden = false;
                        document.documentElement.dataset.manySeconds = seconds.toFixed(1);
                        $('status-many').textContent = `${mine.walls.length} walls in ${seconds.toFixed(0)} s on ${team} ${team > 1 ? 'cores' : 'core'}`;
                        showMany();
                    }
                }
            }),
        );
}

function offerLimits() {
    const first = many.walls.find((w) => w.limits);
    if (!first || $('limit').options.length === first.limits.length) return;
    $('limit').replaceChildren(...first.limits.map((l, i) => element('option', { value: String(i), title: l.rule }, l.name)));
    $('limit-label').hidden = false;
}

function showMany() {
    if (many === null || $('many-pictures').hidden) return;
    const read = many.walls.filter((w) => !w.failed && w.curve);
    const turn = many.direction < 0 ? -1 : 1;
    const lines = read.map((w) => ({ x: w.curve.displacement_mm.map((v) => turn * v), y: w.curve.force_kN.map((v) => turn * v), colour: colour('--accent'), width: 1.1, alpha: 0.55 }));
    drawChart($('many-curves'), { x: { title: 'displacement of the top [mm]', most: many.farthest }, y: { title: 'force [kN]', most: 1.05 * Math.max(1, ...read.map((w) => w.peak_kN)) }, lines });
    const index = Number($('limit').value || 0);
    const limits = read.map((w) => w.limits[index]).filter((l) => l && l.reading !== 'not defined');
    const driftsOf = (holds) => limits.filter(holds).map((l) => l.drift_percent);
    const drifts = { observed: driftsOf((l) => l.reading === 'observed' && !l.capped), censored: driftsOf((l) => l.reading === 'censored'), capped: driftsOf((l) => l.reading === 'observed' && l.capped) };
    const fit = limits.length > 0 ? engine.fit(drifts) : { reason: 'no wall was read yet' };
    const points = fit.points ?? [];
    const most = Math.max(0.1, fit.end ?? 0) * 1.05;
    const steps = { x: [0], y: [0] };
    for (const [at, share] of fit.steps ?? []) {
        steps.x.push(at, at);
        steps.y.push(steps.y.at(-1), share);
    }
    if (fit.end) {
        steps.x.push(fit.end);
        steps.y.push(steps.y.at(-1));
    }
    drawChart($('many-fragility'), {
        x: { title: 'drift [%]', most },
        y: { title: 'share of walls at the limit', most: 1 },
        bands: points.length ? [{ x: points.map((p) => p[0]), low: points.map((p) => p[2]), high: points.map((p) => p[3]), colour: colour('--accent') }] : [],
        lines: [
            { ...steps, colour: colour('--soft'), width: 1.4 },
            { x: points.map((p) => p[0]), y: points.map((p) => p[1]), colour: colour('--accent'), width: 2.6 },
        ],
    });
    const failed = many.walls.length - read.length;
    const name = $('limit').selectedOptions[0]?.textContent ?? '';
    $('fragility-text').textContent = `${name}: ${fit.points ? `median drift ${digits(fit.median_percent)} %, scatter ${digits(fit.dispersion, 2)}; steps: as counted; band: 95 %` : `no law: ${fit.reason ?? fit.error}`}; ${drifts.observed.length + drifts.capped.length} reached it, ${drifts.censored.length} not${failed ? `; ${failed} walls failed` : ''}`;
}

/* ---- what is taken away ---- */

async function copied(text, what) {
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        const area = element('textarea', { class: 'spoken' });
        area.value = text;
        document.body.append(area);
        area.select();
        document.execCommand('copy');
        area.remove();
    }
    document.documentElement.dataset.copied = text;
    $('taken').textContent = `${what} copied`;
    setTimeout(() => ($('taken').textContent = ''), 2500);
}

function download(name, text, type) {
    const link = element('a', { download: name, href: URL.createObjectURL(new Blob([text], { type })) });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    document.documentElement.dataset.downloaded = name;
}

function manyCsv() {
    const names = many.walls.find((w) => w.limits)?.limits.map((l) => l.name) ?? [];
    const head = ['sample', 'mode', 'peak_kN', ...names.flatMap((n) => [`${n} drift_percent`, `${n} reached`])].map((n) => n.replaceAll(' ', '_')).join(',');
    const rows = [...many.walls].sort((a, b) => a.sample - b.sample).map((w) => [w.sample, w.failed ? 'failed' : w.mode, w.peak_kN ?? '', ...(w.limits ?? []).flatMap((l) => [l.drift_percent ?? '', l.reading])].join(','));
    return [head, ...rows].join('\n') + '\n';
}

/* ---- controls ---- */

const kRotated = { yes: 'yes', no: 'no', free: 'yes', fixed: 'no' };
function wordText(key, word) {
    if (key === 'beam.rotation') return kRotated[word];
    const texts = { 'wall.base': { fixed: 'clamped', joint: 'dry joint' }, 'load.top': { dead: 'follows the top', fixed_line: 'keeps its line', follower: 'turns with it', link: 'along a link' }, 'solver.kinematics': { small: 'small', finite: 'finite' } };
    return texts[key]?.[word] ?? word;
}

function setValue(key, value) {
    values[key] = value;
    const field = document.querySelector(`.field[data-key="${CSS.escape(key)}"]`);
    const [box, slider] = [field.querySelector('input[type=text], select, textarea'), field.querySelector('input[type=range]')];
    if (box.value !== value) box.value = value;
    if (slider) slider.value = value;
}

function field(control) {
    const { key, label, slider } = control;
    const known = keys.get(key);
    const meaning = control.meaning ?? known.meaning;
    const words = control.words ?? (known.kind === 'word' ? known.words : null);
    const id = `k-${key.replace('.', '-')}`;
    const made = element('div', { class: words ? 'field wordy' : 'field', 'data-key': key }, element('label', { for: id, title: meaning }, label));
    if (words) {
        const select = element('select', { id }, ...words.map((w) => element('option', { value: w }, wordText(key, w))));
        select.addEventListener('change', () => {
            values[key] = select.value;
            changed();
        });
        made.append(select);
    } else {
        const box = element('input', { id, type: 'text', inputmode: 'decimal', spellcheck: 'false', 'aria-describedby': `${id}-hint`, placeholder: known.default.split(' ')[0] });
        box.addEventListener('input', () => {
            values[key] = box.value;
            if (range) range.value = box.value;
            changedSoon();
        });
        made.append(element('div', { class: 'box' }, box, element('span', {}, known.unit)));
        const range = slider && element('input', { type: 'range', min: String(slider[0]), max: String(slider[1]), step: String(slider[2]), 'aria-label': `${label}, slider` });
        range?.addEventListener('input', () => {
            values[key] = box.value = Number(range.value).toFixed((String(slider[2]).split('.')[1] ?? '').length);
            changedSoon();
        });
        if (range) made.append(range);
    }
    made.append(element('p', { class: 'hint', id: `${id}-hint` }, `${meaning}.${words ? '' : ` Allowed: ${known.allowed}.`}`));
    return made;
}

function buildControls() {
    const narrow = window.matchMedia('(max-width: 640px)').matches;
    const groups = kGroups.map(({ title, keys: list }, i) => element('details', { open: !narrow || i < 2 ? true : false }, element('summary', {}, title), ...list.map(field)));
    const area = element('textarea', { id: 'more', spellcheck: 'false', placeholder: 'joint.tensile_strength = 0.1 MPa\nsolver.accuracy = 0.5 %' });
    area.addEventListener('input', () => {
        values.more = area.value;
        changedSoon();
    });
    groups.push(element('details', {}, element('summary', {}, 'Any other key'), element('div', { class: 'field', 'data-key': 'more' }, element('p', { class: 'about' }, 'One "section.key = value" a line, as in a study file. They go before the controls.'), area)));
    $('controls').replaceChildren(...groups);
    $('controls').addEventListener('submit', (event) => {
        event.preventDefault();
        push();
    });
    $('controls').append(element('button', { type: 'submit', class: 'spoken', tabindex: '-1' }, 'Push'));
    $('scatter').replaceChildren(
        ...kScatter.map(({ key, label }) => {
            const box = element('input', { type: 'text', inputmode: 'decimal', id: `s-${key}`, value: scatter[key] });
            box.addEventListener('input', () => (scatter[key] = box.value));
            return element('div', { class: 'field' }, element('label', { for: `s-${key}`, title: keys.get(key)?.meaning ?? '' }, label), element('div', { class: 'box' }, box, element('span', {}, 'CoV')));
        }),
    );
    $('examples').replaceChildren(
        ...kExamples.map((example) => {
            const its = { ...usualValues(), ...example.values };
            const chip = element('button', { type: 'button', 'data-link': linkOf(its), 'aria-pressed': 'false' }, example.name);
            chip.addEventListener('click', () => take(its));
            return chip;
        }),
    );
    $('scale').replaceChildren(element('option', { value: '0' }, 'as needed'), ...kScales.map((s) => element('option', { value: String(s) }, `× ${s}`)));
}

function take(its) {
    for (const key of Object.keys(values)) setValue(key, its[key]);
    changed();
}

function play() {
    if (playing) {
        playing = 0;
        $('play').textContent = 'Play';
        return;
    }
    if (shown >= run.frames.length - 1) shown = 0;
    const from = shown;
    const begin = performance.now();
    const mine = (playing = Math.random());
    $('play').textContent = 'Pause';
    const step = (now) => {
        if (playing !== mine) return;
        shown = Math.min(run.frames.length - 1, from + Math.floor((now - begin) / 45));
        $('scrub').value = String(shown);
        if (shown >= run.frames.length - 1) {
            playing = 0;
            $('play').textContent = 'Play';
        }
        showWall();
        showCurve();
        if (playing === mine) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
}

function connect() {
    $('push').addEventListener('click', push);
    $('stop').addEventListener('click', () => {
        const at = run?.curve.x.at(-1) ?? 0;
        endPush();
        $('status').textContent = `stopped at ${fixed(at, 1)} mm`;
        $('push').focus({ preventScroll: true });
    });
    $('push-many').addEventListener('click', pushMany);
    $('stop-many').addEventListener('click', () => {
        endMany();
        $('status-many').textContent = `stopped after ${many.walls.length} walls`;
        showMany();
    });
    $('play').addEventListener('click', play);
    $('scrub').addEventListener('input', () => {
        playing = 0;
        $('play').textContent = 'Play';
        shown = Number($('scrub').value);
        showWall();
        showCurve();
    });
    $('scale').addEventListener('change', showWall);
    $('limit').addEventListener('change', showMany);
    $('copy').addEventListener('click', () => copied(studyText(values, keys), 'study.ini'));
    $('copy-many').addEventListener('click', () => copied(manyText(values, keys, scatter, kMany), 'study.ini of 50 walls'));
    $('link').addEventListener('click', () => copied(location.href.split('#')[0] + linkOf(values), 'link'));
    $('csv').addEventListener('click', () => download('capacity.csv', run.result['capacity.csv'], 'text/csv'));
    $('svg-curve').addEventListener('click', () => download('capacity.svg', run.result['capacity.svg'], 'image/svg+xml'));
    $('svg-wall').addEventListener('click', () => download('wall.svg', run.result['wall.svg'], 'image/svg+xml'));
    $('csv-many').addEventListener('click', () => download('walls.csv', manyCsv(), 'text/csv'));
    $('curve').addEventListener('pointermove', (event) => {
        if (!run?.result || !chart) return;
        const x = chart.toX(event.offsetX);
        const i = chart.curve.x.findIndex((v) => v >= x);
        if (i < 0) return;
        showCurve({ x: chart.curve.x[i], y: chart.curve.y[i] });
        $('reading').textContent = `${fixed(chart.curve.y[i], 2)} kN at ${fixed(chart.curve.x[i], 2)} mm`;
    });
    $('curve').addEventListener('pointerleave', () => {
        $('reading').textContent = 'force over displacement of the top';
        showCurve();
    });
    window.addEventListener('hashchange', () => take(valuesOfLink(location.hash)));
    new ResizeObserver(showAll).observe($('wall'));
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', showAll);
}

async function begin() {
    const packed = Uint8Array.from(atob($('module').textContent.trim()), (c) => c.charCodeAt(0));
    const bytes = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
    module = await WebAssembly.compile(bytes);
    engine = await openEngine(module);
    for (const key of engine.keys()) keys.set(key.name, key);
    buildControls();
    connect();
    take(valuesOfLink(location.hash));
    document.documentElement.dataset.first = performance.now().toFixed(0);
    document.documentElement.dataset.ready = 'yes';
}

begin().catch((trouble) => {
    $('trouble').hidden = false;
    $('trouble').textContent = `This browser cannot run the page: ${trouble.message}. It takes Chrome 95, Firefox 113 or Safari 16.4.`;
});
