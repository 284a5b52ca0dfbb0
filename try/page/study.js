// The controls of the page and the study file that they make. Units, ranges, words and meanings come from the program's key table.

/** The wall of configs/wall.ini. `slider`: the part of the range that is usual. */
export const kGroups = [
    {
        title: 'Wall',
        keys: [
            { key: 'wall.length', label: 'Length', value: '1.00', slider: [0.4, 3, 0.1] },
            { key: 'wall.courses', label: 'Courses', value: '10', slider: [2, 20, 1] },
            { key: 'wall.course_height', label: 'Height of a course', value: '0.10', slider: [0.05, 0.4, 0.01] },
            { key: 'wall.unit_length', label: 'Length of a stone', value: '0.20', slider: [0.1, 0.8, 0.02] },
            { key: 'wall.thickness', label: 'Thickness', value: '0.20', slider: [0.1, 1, 0.02] },
            { key: 'wall.bond', label: 'Bond', value: 'running', words: ['running', 'stack', 'english', 'flemish', 'header'] },
            { key: 'wall.base', label: 'Base', value: 'fixed' },
        ],
    },
    {
        title: 'Load',
        keys: [
            { key: 'load.vertical_stress', label: 'Vertical stress', value: '0.50', slider: [0.05, 1.5, 0.05] },
            { key: 'load.max_displacement', label: 'Push as far as', value: '30', slider: [5, 60, 1] },
            { key: 'direction', label: 'Direction', value: 'right', words: ['right', 'left'], meaning: 'which way the top is pushed; the toe of configs/wall.ini is held at the right' },
            { key: 'beam.rotation', label: 'Top may turn', value: 'free' },
            { key: 'load.top', label: 'Vertical load', value: 'dead' },
        ],
    },
    {
        title: 'Joints',
        keys: [
            { key: 'joint.friction_angle', label: 'Friction angle', value: '31.8', slider: [15, 45, 0.2] },
            { key: 'joint.wall_modulus', label: 'Modulus of the wall', value: '768', slider: [200, 3000, 4] },
            { key: 'joint.compressive_strength', label: 'Compressive strength', value: '' },
        ],
    },
    {
        title: 'Stones',
        keys: [
            { key: 'wall.unit_cracks', label: 'Stones may crack', value: 'yes' },
            { key: 'unit.tensile_strength', label: 'Tensile strength', value: '3.7', slider: [0.5, 10, 0.1] },
            { key: 'unit.fracture_energy', label: 'Fracture energy', value: '110', slider: [10, 300, 5] },
            { key: 'stone.young_modulus', label: 'Young’s modulus', value: '15.5', slider: [2, 60, 0.5] },
            { key: 'stone.density', label: 'Density', value: '2300', slider: [1500, 3000, 50] },
        ],
    },
    {
        title: 'Computation',
        keys: [
            { key: 'solver.kinematics', label: 'Displacements', value: 'small' },
            { key: 'solver.fidelity', label: 'Detail', value: 'standard', words: ['simple', 'standard', 'zones'] },
        ],
    },
];

/** Written as in configs/wall.ini, and not shown. */
const kOthers = {
    'wall.toe': 'held',
    'stone.poisson_ratio': '0.2',
    'unit.stiffness_ratio': '10',
    'unit.friction_angle': '35 deg',
    'beam.height': '0.10 m',
    'beam.young_modulus': '30 GPa',
    'beam.density': '7500 kg/m3',
};
/** Of stones that may crack. */
const kOfCracks = ['unit.tensile_strength', 'unit.fracture_energy', 'unit.stiffness_ratio', 'unit.friction_angle'];

export const kControls = kGroups.flatMap((group) => group.keys);
export const usualValues = () => Object.fromEntries([...kControls.map((c) => [c.key, c.value]), ['more', '']]);

export const kExamples = [
    { name: 'Wall of the paper', values: {} },
    { name: 'Light load: it rocks', values: { 'load.vertical_stress': '0.15', 'joint.wall_modulus': '558' } },
    { name: 'It slides', values: { 'wall.length': '2.00', 'joint.friction_angle': '20', 'wall.base': 'joint', 'load.vertical_stress': '0.20', 'joint.wall_modulus': '590' } },
    { name: 'Slender pier', values: { 'wall.length': '0.60', 'load.vertical_stress': '0.30', 'joint.wall_modulus': '650', 'solver.kinematics': 'finite', 'load.max_displacement': '60' } },
    { name: 'Weak stones', values: { 'load.vertical_stress': '1.00', 'joint.wall_modulus': '1057', 'unit.tensile_strength': '1.5' } },
];

/** Scatter of the paper, Table 5. */
export const kScatter = [
    { key: 'joint.friction_angle', label: 'Friction angle', law: 'normal', cov: '0.20' },
    { key: 'joint.stiffness_factor', label: 'Stiffness of the joints', law: 'normal', cov: '0.25', mean: '1' },
    { key: 'unit.tensile_strength', label: 'Tensile strength', law: 'lognormal', cov: '0.30' },
    { key: 'unit.stiffness_factor', label: 'Stiffness of the cracks', law: 'normal', cov: '0.25', mean: '1', ofCracks: true },
];

/** `section.key = value` lines that the user adds. */
function extraLines(text) {
    return text
        .split('\n')
        .map((line) => line.split('#')[0].trim())
        .filter((line) => line !== '')
        .map((line) => {
            const [name, ...rest] = line.split('=');
            return [name.trim(), rest.join('=').trim()];
        });
}

function keysOf(values, keys) {
    const all = new Map(Object.entries(kOthers));
    for (const { key } of kControls) {
        const value = String(values[key] ?? '').trim();
        if (value === '' || key === 'direction') continue;
        const unit = keys.get(key)?.unit ?? '';
        const bare = /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/i.test(value);
        all.set(key, bare && unit !== '' ? `${value} ${unit}` : value);
    }
    if (values.direction === 'left') {
        all.set('load.targets', `-${all.get('load.max_displacement')}`);
        all.delete('load.max_displacement');
    }
    if (all.get('wall.unit_cracks') === 'no') for (const key of kOfCracks) all.delete(key);
    return all;
}

function written(all, head) {
    const sections = new Map();
    for (const [name, value] of all) {
        const dot = name.indexOf('.');
        const section = dot < 0 ? name : name.slice(0, dot);
        if (!sections.has(section)) sections.set(section, []);
        sections.get(section).push(`${name.slice(dot + 1).padEnd(20)} = ${value}`);
    }
    return [...head.map((line) => `# ${line}`), ...[...sections].flatMap(([section, lines]) => ['', `[${section}]`, ...lines])].join('\n') + '\n';
}

const kHead = ['Written by the page of Drystone. Run it with: drystone push study.ini'];

/** The study file of one wall. @param keys of the program, by name */
export function studyText(values, keys) {
    const all = keysOf(values, keys);
    for (const [name, value] of extraLines(values.more)) all.set(name, value);
    return written(all, kHead);
}

/** The same wall with scatter. @param scatter coefficients of variation by key; 0: none */
export function manyText(values, keys, scatter, samples) {
    const all = keysOf(values, keys);
    for (const { key, law, mean, ofCracks } of kScatter) {
        const cracks = key.startsWith('unit.') && all.get('wall.unit_cracks') === 'no';
        const cov = String(scatter[key] ?? '').trim();
        if (cracks || (ofCracks && all.get('wall.unit_cracks') === 'no') || cov === '' || Number(cov) === 0) continue;
        all.set(key, `${law}(mean ${mean ?? all.get(key)}, cov ${cov})`);
    }
    all.set('load.stop_below', '0.70');
    all.set('solver.fidelity', 'simple');
    all.set('uq.design', 'lhs_centred');
    all.set('uq.samples', String(samples));
    all.set('uq.seed', '1');
    all.set('uq.spatial', 'none');
    for (const [name, value] of extraLines(values.more)) all.set(name, value);
    return written(all, ['Written by the page of Drystone. Run it with: drystone study study.ini --report']);
}

/** Only what differs from the usual wall. */
export function linkOf(values) {
    const usual = usualValues();
    const parts = Object.keys(usual)
        .filter((key) => String(values[key]) !== usual[key])
        .map((key) => `${key}=${encodeURIComponent(values[key])}`);
    return parts.length === 0 ? '' : `#${parts.join('&')}`;
}

export function valuesOfLink(hash) {
    const values = usualValues();
    for (const part of hash.replace(/^#/, '').split('&')) {
        const equals = part.indexOf('=');
        const key = part.slice(0, equals);
        if (equals < 0 || !(key in values)) continue;
        try {
            values[key] = decodeURIComponent(part.slice(equals + 1));
        } catch {
            // a damaged link: the usual value stays
        }
    }
    return values;
}

/** "study.ini:12: joint.friction_angle: ..." as its key and its words. */
export function placeOf(message) {
    const [, key, words] = message.match(/^(?:study\.ini(?::\d+)?|drystone): (?:\[?([a-z_.]+)\]?: )?(.*)$/s) ?? [null, undefined, message];
    return { key, words };
}
