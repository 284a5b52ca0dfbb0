// Tables that can be copied, and where the numbers come from.
import { element } from './format.js';

/** To the clipboard, also where a page from a file may not use it directly. */
async function copy(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        const area = element('textarea', { class: 'aside', 'aria-hidden': 'true' });
        area.value = text;
        document.body.append(area);
        area.select();
        const done = document.execCommand('copy');
        area.remove();
        return done;
    }
}

function copyButtons(forms, name) {
    const said = element('span', { class: 'said', role: 'status' });
    const button = ([label, text]) =>
        element('button', { type: 'button', 'aria-label': `Copy ${name} as ${label}`, onclick: async () => {
            said.textContent = (await copy(text)) ? `copied as ${label}` : 'the browser does not allow copying';
        } }, label);
    return element('div', { class: 'copy' }, element('span', { class: 'label' }, 'Copy as'), ...forms.map(button), said);
}

/** Something that is read when it is asked for, long tables in it without a fold of their own; on paper it is open. */
export function folded(title, ...content) {
    for (const c of content) if (c.tagName === 'DETAILS') c.open = true;
    return element('details', { class: 'folded' }, element('summary', {}, title), ...content);
}

let closed = [];
addEventListener('beforeprint', () => {
    closed = [...document.querySelectorAll('details.about, details.folded')].filter((d) => !d.open);
    for (const d of closed) d.open = true;
});
addEventListener('afterprint', () => closed.forEach((d) => (d.open = false)));

/** head and rows of text, which scrolls sideways under its first column where it is wider than the screen. */
export function scrolled({ head, rows }, title) {
    const kLong = 40; // signs: sentences are broken
    const long = head.map((_, c) => rows.some((row) => row[c].length > kLong));
    const cells = (name, row) => row.map((text, c) => element(name, { ...(name === 'th' ? { scope: 'col' } : {}), ...(long[c] ? { class: 'words' } : {}) }, text));
    const body = element('tbody', {}, ...rows.map((row) => element('tr', {}, ...cells('td', row))));
    return element('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': title }, element('table', {}, element('thead', {}, element('tr', {}, ...cells('th', head))), body));
}

/** What the numbers of a table are: below it, and folded where it is long. */
function captionOf(t) {
    const kShort = 160; // signs: two lines
    const text = element('p', { class: 'note' }, t.caption);
    if (!t.caption || t.caption.length <= kShort) return text;
    return element('details', { class: 'about' }, element('summary', {}, 'About this table'), text);
}

export function table(t) {
    const kFolded = 30; // rows
    const forms = [['text', t.text], ['CSV', t.csv], ['Markdown', t.markdown], ['LaTeX', t.latex]];
    const place = element('div', {});
    const fill = () => place.childElementCount || place.append(scrolled(t, t.title));
    const content = [place, captionOf(t), copyButtons(forms, `the table ${t.title}`)];
    if (t.rows.length <= kFolded) {
        fill();
        return element('div', { id: `table-${t.id}` }, element('h3', {}, t.title), ...content);
    }
    return element('details', { id: `table-${t.id}`, ontoggle: fill }, element('summary', {}, `${t.title}: ${t.rows.length} rows`), ...content);
}

export function provenance(data, host) {
    const p = data.provenance;
    const item = (name, value) => [element('dt', {}, name), element('dd', {}, value)];
    const list = element('dl', {},
        ...item('Page by', `Drystone ${p.version}`),
        ...item('Seed', p.seed),
        ...item('Samples', `${p.design_sizes.join(', then ')} per stress`),
        ...(p.shards > 1 ? item('Shard', `${p.shard} of ${p.shards}`) : []),
        ...p.sessions.flatMap((s, i) => item(`Session ${i + 1}`, `${s.started}, Drystone ${s.version}${s.solver_revision ? `, solver revision ${s.solver_revision},` : ''} on ${s.machine}; ${s.build}; ${s.settings}`)));
    host.append(list, element('details', {}, element('summary', {}, 'Complete study file'), copyButtons([['text', p.configuration]], 'the study file'), element('pre', { tabindex: 0 }, p.configuration)));
}
