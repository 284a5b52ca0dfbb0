// Builds the page from its data.
import { choice, element, section, percent, words } from './format.js';
import { inflate, readCurves, readLoops } from './data.js';
import { Capacity } from './capacity.js';
import { WallView } from './wall.js';
import { cycles, fragility, modes, histograms, running, sensitivity } from './statistics.js';
import { folded, scrolled, table, provenance } from './tables.js';
import { whatif } from './whatif.js';

const note = (text) => element('p', { class: 'note' }, text);

const about = (...texts) => element('details', { class: 'about' }, element('summary', {}, 'About this table'), ...texts.filter(Boolean).map(note));

/** A table with its columns as rows. */
const turned = ({ head, rows }) => ({ head: [head[0], ...rows.map((r) => r[0])], rows: head.slice(1).map((name, c) => [name, ...rows.map((r) => r[c + 1])]) });

const isPhone = () => matchMedia('(max-width: 500px)').matches;

/** A table of many stresses as that of the one chosen: its place, and the row of buttons above it. */
function oneByOne(answers, title, chosen) {
    const place = element('div', {});
    const draw = (i) => place.replaceChildren(scrolled(turned({ head: answers.head, rows: [answers.rows[i]] }), title));
    const picker = choice('Stress', answers.rows.map((row, i) => ({ value: i, text: `${row[0]} MPa` })), 0, (i) => {
        draw(i);
        chosen(Number(answers.rows[i][0]));
    });
    draw(0);
    return [picker.row, place];
}

/** The answer: a sentence, and the drifts of each stress. A phone, which has no room for all columns, shows one stress or two, and says what is said about them
 *  below its pictures. chosen: is told the stress that a phone chose.
 *  @returns what is said below the pictures */
function overview(data, chosen) {
    const { lead, answers, solver } = data.overview;
    const host = section('overview', 'Overview');
    const title = 'Peak force, mode and drift limits of each stress';
    const said = element('p', { class: 'lead' }, lead);
    const notes = about(answers.note, solver);
    if (!answers.rows.length) return host.append(said, solver ? note(solver) : ''), [];
    if (!isPhone()) return host.append(said, scrolled(answers, title), notes), [];
    host.append(...(answers.rows.length > 2 ? oneByOne(answers, title, chosen) : [scrolled(turned(answers), title)]));
    return [said, notes];
}

/** What stands behind the answer. */
function behind(data) {
    const list = (title, lines) => element('div', {}, element('h3', {}, title), element('ul', {}, ...lines.map((l) => element('li', {}, l))));
    section('about', 'The study', element('div', { class: 'pair' }, list('What was run', data.overview.run), list('How sure', data.overview.sure)), list('What came out', data.overview.found), table(data.tables.results), table(data.tables.solver_error));
}

async function curvesAndWall(data, told, said) {
    const left = element('div', { class: 'curves' });
    const right = element('div', { class: 'view', id: 'wall' });
    section('curves', 'Capacity curves and walls', element('div', { class: 'pair wide' }, left, right), ...said);
    let view = null;
    const curves = await readCurves(data.curves);
    const loops = data.loops ? await readLoops(data.loops) : null;
    const capacity = new Capacity(data, curves, loops, left, {
        wall: async (w) => {
            await view?.open(w);
            if (view && matchMedia('(max-width: 900px)').matches) right.querySelector('figure').scrollIntoView();
        },
        stress: (level) => {
            const w = view?.counterpart(level) ?? null;
            if (w !== null) view.open(w);
        },
    });
    told.stress = (stress) => {
        const level = data.levels.findIndex((l) => Number(l.stress) === stress);
        if (level >= 0) capacity.picker.set(level);
    };
    left.append(data.films.note ? note(data.films.note) : '',
        note(`Bands are ${percent(data)} confidence intervals of the mean of five walls or more; mean curves stop where fewer than 90 % of the walls are still being pushed.${data.loops ? ' The push is cyclic: curves are backbones, the wall shown has its loops below.' : ''}${data.ways ? ` ${data.ways}` : ''}`));
    if (!data.films.films.length) return;
    view = new WallView(data, right, capacity);
    await view.open(data.films.films[0].wall);
}

/** Walls that were never run. */
function asking(data) {
    const host = section('whatif', 'What if');
    if (!data.whatif.none) host.append(note('Walls that were not pushed, by what was learned from those of this study; sliders reach from its least to its most value. How: docs/surrogates.md; drystone surrogate keeps the same in a file.'));
    whatif(data, host);
}

function statistics(data) {
    const add = (id, ...names) => document.getElementById(id).append(...names.map((name) => table(data.tables[name])));
    if (data.loops) {
        cycles(data, section('cycles', 'Cycles', note('Mean equivalent viscous damping of the walls that closed a cycle, against the amplitude of the cycle.')));
        add('cycles', 'cycles');
    }
    fragility(data, section('fragility', 'Fragility', note('Probability that a wall has reached a limit state: shares of the modes times the law fitted to each mode.')));
    add('fragility', 'limits_with_doubt', 'performance_limits', 'forces_with_doubt');
    document.getElementById('fragility').append(folded('For statisticians: the laws and their parameters',
        note('beta: standard deviation of ln(drift), in earthquake engineering the dispersion. AIC: Akaike\'s information criterion, lower is better; it compares laws on the same walls.'), table(data.tables.law_parameters)));
    if (data.tables.pier_limits) {
        section('piers', 'Piers', note('The drift limits of codes are those of piers, numbered from the left, storey by storey: the wall reaches one when its first pier does.'));
        add('piers', 'pier_limits', 'piers', ...(data.tables.spandrels ? ['spandrels'] : []));
    }
    modes(data, section('modes', 'Failure modes'));
    add('modes', 'modes', 'means_by_mode');
    document.getElementById('modes').append(folded('For statisticians: where the modes change',
        note('Firth\'s penalty keeps a logistic regression finite where a stress parts the modes completely.'), table(data.tables.equal_modes), table(data.tables.mode_thresholds)));
    section('assumed', 'Assumptions', note('What the walls of this study were taken to be, beside what the page found out about them.'),
        table(data.tables.choices), folded('Materials', table(data.tables.materials)), folded('Wall and loads', table(data.tables.wall_and_loads)));
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
    const told = {}; // as soon as there are curves
    const said = overview(data, (stress) => told.stress?.(stress));
    await curvesAndWall(data, told, said);
    behind(data);
    asking(data);
    statistics(data);
    section('walls', 'All walls', table(data.tables.walls));
    provenance(data, section('provenance', 'Provenance'));
    document.documentElement.dataset.ready = 'yes';
}

start().catch((error) => {
    document.getElementById('main').append(element('p', { role: 'alert' }, `This page could not be drawn: ${error.message}`));
    throw error;
});
