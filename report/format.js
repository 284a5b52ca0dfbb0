// Text and elements.

/** A number with `digits` places, or a dash where there is none. */
export const fixed = (x, digits = 1) => (x === null || x === undefined || !Number.isFinite(x) ? '–' : x.toFixed(digits));

/** A number with about four figures, for axes and lists. */
export const figures = (x) => (x === null || !Number.isFinite(x) ? '–' : String(Number(x.toPrecision(4))));

/** "joint.friction_angle" as words. */
export const words = (key) => key.replaceAll('_', ' ').replace('.', ': ');

/** An element; text goes in as text, never as HTML. `attributes` named on... are listeners. */
export function element(name, attributes = {}, ...children) {
    const svg = /^(svg|g|path|line|polygon|polyline|circle|rect|text|title)$/.test(name) && attributes.xmlns !== 'html';
    const e = svg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (key.startsWith('on')) e.addEventListener(key.slice(2), value);
        else if (value === true) e.setAttribute(key, '');
        else if (value !== false && value !== null) e.setAttribute(key, value);
    }
    e.append(...children.filter((c) => c !== null));
    return e;
}

/** A row of buttons of which one is pressed. */
export function choice(label, options, chosen, changed) {
    const row = element('div', { class: 'choice', role: 'group', 'aria-label': label });
    const buttons = options.map((option) =>
        element('button', { type: 'button', 'aria-pressed': String(option.value === chosen), onclick: () => set(option.value) }, option.text),
    );
    function set(value) {
        buttons.forEach((b, i) => b.setAttribute('aria-pressed', String(options[i].value === value)));
        changed(value);
    }
    row.append(element('span', { class: 'label' }, label), ...buttons);
    return { row, set };
}

/** A section of the page, with its place in the contents. */
export function section(id, title, ...children) {
    document.getElementById('contents').append(element('a', { href: `#${id}` }, title));
    const s = element('section', { id, 'aria-labelledby': `${id}-title` }, element('h2', { id: `${id}-title` }, title), ...children);
    document.getElementById('main').append(s);
    return s;
}

/** Okabe and Ito (2008): told apart with every kind of colour vision. */
export const colours = {
    rocking: '#0072B2',
    sliding: '#009E73',
    mixed: '#D55E00',
    failed: '#767676',
    all: '#222222',
    levels: ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#806600', '#56B4E9', '#222222', '#7F3C8D', '#8C564B', '#7F7F7F', '#6B8E23', '#F2666C'],
};
export const levelColour = (i) => colours.levels[i % colours.levels.length];
export const dashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [10, 3, 2, 3, 2, 3], [14, 6], [1, 2]];

/** "95 %": of the intervals of this page. */
export function percent(data) {
    return `${figures(100 * data.confidence)} %`;
}
