// Builds the page from its data.
import { element, section, percent, words } from './format.js';
import { inflate, readCurves, readLoops } from './data.js';
import { Capacity } from './capacity.js';
import { WallView } from './wall.js';
import { cycles, fragility, modes, histograms, running, sensitivity } from './statistics.js';
import { table, provenance } from './tables.js';

const note = (text) => element('p', { class: 'note' }, text);

function overview(data) {
    const list = (title, lines) => element('div', {}, element('h3', {}, title), element('ul', {}, ...lines.map((l) => element('li', {}, l))));
    section('overview', 'Overview', list('What was run', data.overview.run), list('What came out', data.overview.found), list('How sure', data.overview.sure), table(data.tables.results));
}

async function curvesAndWall(data) {
    const left = element('div', { class: 'curves' });
    const right = element('div', { class: 'view', id: 'wall' });
    section('curves', 'Capacity curves and walls', element('div', { class: 'pair wide' }, left, right),
        note(`Click a curve to see its wall. Bands: ${percent(data)} interval of the mean, of five walls or more; means end where fewer than nine tenths of their walls go on.${data.loops ? ' The push goes to and fro: curves are backbones, the wall shown has its loops below.' : ''}`),
        note(data.films.note));
    let view = null;
    const curves = await readCurves(data.curves);
    const loops = data.loops ? await readLoops(data.loops) : null;
    const capacity = new Capacity(data, curves, loops, left, async (w) => {
        await view?.open(w);
        if (view && matchMedia('(max-width: 900px)').matches) right.scrollIntoView();
    });
    if (!data.films.films.length) return;
    view = new WallView(data, right, capacity);
    await view.open(data.films.films[0].wall);
}

function statistics(data) {
    const add = (id, ...names) => document.getElementById(id).append(...names.map((name) => table(data.tables[name])));
    if (data.loops) {
        cycles(data, section('cycles', 'Cycles', note('Mean equivalent viscous damping of the walls that closed a cycle, against the amplitude of the cycle.')));
        add('cycles', 'cycles');
    }
    fragility(data, section('fragility', 'Fragility', note('Probability that a wall has reached a limit state: shares of the modes times the law fitted to each mode.')));
    add('fragility', 'performance_limits', 'law_parameters');
    modes(data, section('modes', 'Failure modes'));
    add('modes', 'modes', 'means_by_mode', 'equal_modes', 'mode_thresholds');
    section('assumed', 'Assumptions', note('What the walls of this study were taken to be, beside what the page found out about them.'));
    add('assumed', 'choices', 'materials', 'wall_and_loads');
    const inputs = section('inputs', 'Inputs', note('Values drawn for all walls, and the distribution they were drawn from, cut at what is physically possible.'));
    if (data.histograms.length) histograms(data, inputs);
    else inputs.append(element('p', {}, 'Nothing was random.'));
    running(data, section('running', 'Running means', note('How far the mean of the first walls is from the prescribed mean; of the peak force, from the mean of all.')));
    sensitivity(data, section('sensitivity', 'Sensitivity', note(`How strongly a response rises (blue, right) or falls (orange, left) with each input; lines: ${percent(data)} intervals. Ultimate displacement: of the walls in which it was observed.`)));
    if (data.inputs.length) add('sensitivity', 'inputs');
}

async function start() {
    const text = (id) => document.getElementById(id).textContent;
    const data = JSON.parse(new TextDecoder().decode(await inflate(text('data'))));
    data.films = JSON.parse(text('films'));
    overview(data);
    await curvesAndWall(data);
    statistics(data);
    section('walls', 'All walls', table(data.tables.walls));
    provenance(data, section('provenance', 'Provenance'));
    document.documentElement.dataset.ready = 'yes';
}

start().catch((error) => {
    document.getElementById('main').append(element('p', { role: 'alert' }, `This page could not be drawn: ${error.message}`));
    throw error;
});
