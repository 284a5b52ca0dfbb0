// node test_page.mjs CHROMIUM FOLDER CLAIM: opens FOLDER/small.html and checks one claim. Exit 1 if it does not hold.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { resolve } from 'node:path';
import { openPage } from './browser.mjs';

const [program, place, claim] = process.argv.slice(2);
const folder = resolve(place);
const claims = {};
const small = `${folder}/small.html`;

async function withPage(options, check, file = small) {
    const page = await openPage(program, options);
    try {
        const seconds = await page.open(file);
        await check(page, seconds);
        assert.deepEqual(page.problems(), [], 'errors and warnings of the console');
        assert.deepEqual(page.requests(), [`file://${file}`], 'requests');
    } finally {
        await page.close();
    }
}

async function openingTime() {
    let time;
    await withPage({}, async (page, seconds) => (time = seconds));
    return time;
}

const outlines = `[...document.querySelectorAll('.wall .stones polygon')].map((p) => p.getAttribute('points')).join(' ')`;
const caption = `document.querySelector('.view figcaption').textContent`;
const data = `(async () => {
    const bytes = Uint8Array.from(atob(document.getElementById('data').textContent), (c) => c.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'))).text();
})()`;
const sections = `[...document.querySelectorAll('section')].map((s) => s.id)`;
const kSections = ['overview', 'curves', 'about', 'whatif', 'fragility', 'modes', 'assumed', 'inputs', 'running', 'sensitivity', 'walls', 'provenance'];
const visibleText = `document.body.innerText + [...document.querySelectorAll('svg *')].flatMap((e) => [...e.attributes].map((a) => a.value)).join(' ')`;
const kNoNumber = /\b(NaN|Infinity|undefined|null|inf|nan)\b/;
const press = (selector) => `document.querySelector(${JSON.stringify(selector)}).click()`;
const button = (within, text) => `[...document.querySelectorAll('${within} button')].find((b) => b.textContent === '${text}')`;

claims['opens within two seconds without error and without network'] = () =>
    withPage({}, async (page, first) => {
        let seconds = first; // the quickest counts: the machine may have other things to do
        for (let again = 0; again < 4 && seconds >= 2; ++again) seconds = await openingTime();
        assert.ok(seconds < 2, `${seconds} s`);
        assert.deepEqual(await page.evaluate(sections), kSections);
        assert.equal(await page.evaluate(`document.querySelector('[role=alert]')`), null);
    });

claims['no number on the page is NaN or infinite and no value is undefined'] = () =>
    withPage({}, async (page) => {
        assert.doesNotMatch(await page.evaluate(visibleText), kNoNumber);
        assert.doesNotMatch(await page.evaluate(data), /NaN|Infinity/);
    });

claims['a click on a curve shows its wall'] = () =>
    withPage({}, async (page) => {
        const before = await page.evaluate(caption);
        await page.evaluate(`document.querySelector('.curves .u-over').scrollIntoView({ block: 'center', behavior: 'instant' })`);
        await page.drawn();
        const [x, y, w, h] = await page.evaluate(`(() => { const b = document.querySelector('.curves .u-over').getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()`);
        assert.ok(w > 200);
        let hovered = '';
        for (let t = 0.05; t < 0.98 && !/sample [1-9]/.test(hovered); t += 0.03) {
            await page.move(x + 0.7 * w, y + t * h);
            hovered = await page.evaluate(`(() => { const t = document.querySelector('.curves .tip'); return t.hidden ? '' : t.textContent; })()`);
            if (/sample [1-9]/.test(hovered)) await page.click(x + 0.7 * w, y + t * h);
        }
        assert.match(hovered, /friction angle [0-9.]+ deg/);
        await page.until(`${caption} !== ${JSON.stringify(before)}`);
        const shown = await page.evaluate(caption);
        assert.ok(shown.startsWith(hovered.split('\n')[0]), `${shown} after ${hovered}`);
        assert.ok((await page.evaluate(`document.querySelector('.overlay .chosen').getAttribute('points')`)).length > 100);
    });

claims['the push can be scrubbed from rest to its end'] = () =>
    withPage({}, async (page) => {
        const at = async (v) => {
            await page.evaluate(`(() => { const r = document.getElementById('push'); r.value = ${v}; r.dispatchEvent(new Event('input')); })()`);
            return { text: await page.evaluate(caption), shape: await page.evaluate(outlines) };
        };
        const [rest, middle, end] = [await at(0), await at(0.5), await at(1)];
        assert.match(rest.text, /: 0\.0 mm, drift 0\.00 %/);
        assert.match(middle.text, /: 3\.0 mm/);
        assert.match(end.text, /: 6\.0 mm, drift 1\.20 %, [1-9]/);
        assert.notEqual(rest.shape, middle.shape);
        assert.notEqual(middle.shape, end.shape);
    });

claims['play runs the film to its end and pause holds it'] = () =>
    withPage({}, async (page) => {
        await page.evaluate(press('.play'));
        await page.until(`document.querySelector('.play').textContent === 'Pause'`);
        const begun = await page.evaluate(caption);
        await page.until(`${caption} !== ${JSON.stringify(begun)}`);
        const running = await page.evaluate(caption);
        await page.until(`${caption} !== ${JSON.stringify(running)}`);
        assert.equal(await page.evaluate(`document.querySelector('.play').textContent`), 'Pause');
        await page.evaluate(press('.play'));
        const held = await page.evaluate(caption);
        await page.sleep(400);
        assert.equal(await page.evaluate(caption), held);
        await page.evaluate(press('.play'));
        await page.until(`document.querySelector('.play').textContent === 'Play'`);
        assert.match(await page.evaluate(caption), /: 6\.0 mm/);
    });

claims['where less motion is asked for play shows still pictures'] = () =>
    withPage({ reducedMotion: true }, async (page) => {
        await page.evaluate(`window.seen = new Set(); new MutationObserver(() => seen.add(${caption})).observe(document.querySelector('.view figcaption'), { childList: true, characterData: true, subtree: true })`);
        await page.evaluate(press('.play'));
        await page.until(`document.querySelector('.play').textContent === 'Play'`);
        const seen = await page.evaluate(`seen.size`);
        assert.ok(seen >= 5 && seen <= 13, `${seen} pictures`);
    });

claims['the answer stands first, with a picture on the first screen, on a desk and on a phone'] = async () => {
    for (const screen of [{ width: 1400, height: 900 }, { width: 390, height: 844, mobile: true }])
        await withPage(screen, async (page) => {
            const top = (selector) => page.evaluate(`document.querySelector('${selector}').getBoundingClientRect().top`);
            const [answer, picture] = [await top('#overview table'), await top('svg.wall')];
            assert.ok(answer < picture && picture < 0.75 * screen.height, `answer at ${answer}, picture at ${picture} of ${screen.height} px`);
            const parts = await page.evaluate(`['svg.wall', '.curves .u-over'].map((s) => { const b = document.querySelector(s).getBoundingClientRect(); return (${screen.height} - b.top) / b.height; })`);
            assert.ok(parts.every((share) => share > 0.5), `shares of wall and curves on the screen: ${parts}`);
            const heads = await page.evaluate(`[...document.querySelectorAll('#overview th, #overview td:first-child')].map((h) => h.textContent)`);
            for (const head of ['how it fails', 'ntc SLC drift [%]', 'paper ultimate drift [%]', 'how sure']) assert.ok(heads.includes(head), `${heads}`);
        });
};

claims['a phone shows all of the answer for one stress without scrolling to the side'] = () =>
    withPage({ width: 390, height: 844, mobile: true }, async (page) => {
        const far = await page.evaluate(`Math.max(...[...document.querySelectorAll('#overview td')].map((c) => c.getBoundingClientRect().right))`);
        assert.ok(far <= 390, `a cell ends at ${far} px`);
        const rows = await page.evaluate(`[...document.querySelectorAll('#overview tbody tr')].map((r) => r.firstChild.textContent)`);
        assert.ok(rows.includes('how it fails') && rows.includes('ntc SLC drift [%]'), `${rows}`);
        assert.ok((await page.evaluate(`document.querySelector('svg.wall').getBoundingClientRect().top`)) < 0.75 * 844);
    }, `${folder}/one_stress.html`);

claims['a phone shows one of many stresses, whose table, wall and curves change together'] = () =>
    withPage({ width: 390, height: 844, mobile: true }, async (page) => {
        const far = await page.evaluate(`Math.max(...[...document.querySelectorAll('#overview td')].map((c) => c.getBoundingClientRect().right))`);
        assert.ok(far <= 390, `a cell ends at ${far} px`);
        const peak = `[...document.querySelectorAll('#overview tbody tr')].find((r) => r.firstChild.textContent === 'peak [kN]').lastChild.textContent`;
        const before = await page.evaluate(peak);
        await page.evaluate(`${button('#overview', '1 MPa')}.click()`);
        assert.notEqual(await page.evaluate(peak), before);
        await page.until(`${caption}.startsWith('1.00 MPa, sample 0:')`);
        assert.equal(await page.evaluate(`${button('#curves .curves', '1.00 MPa')}.getAttribute('aria-pressed')`), 'true');
        for (const part of ['svg.wall', '.curves .u-over']) assert.ok((await page.evaluate(`document.querySelector('${part}').getBoundingClientRect().bottom`)) <= 844, part);
    }, `${folder}/three_stresses.html`);

claims['walls with openings have a section on piers, and it is said which push a curve is of'] = () =>
    withPage({}, async (page) => {
        const rows = await page.evaluate(`[...document.querySelectorAll('#table-pier_limits tbody tr, #table-piers tbody tr')].map((r) => r.textContent)`);
        const spandrels = await page.evaluate(`[...document.querySelectorAll('#table-spandrels tbody tr')].map((r) => r.textContent)`);
        assert.equal(spandrels.length, 2 * 2, spandrels.join('; ')); // of each stress and direction
        assert.ok(rows.length >= 4 + 2 && rows.some((r) => r.includes('ntc SLC') && /pier [12]|fall of the force|not reached/.test(r)), rows.join('; '));
        assert.match(await page.evaluate(`document.getElementById('curves').textContent`), /single walls: pushed to the right; means and tables: the direction in which a wall carries less/);
    }, `${folder}/piers.html`);

claims['what a table says stands before what is said about it'] = () =>
    withPage({}, async (page) => {
        const order = await page.evaluate(`[...document.querySelectorAll('[id^=table-]')].map((t) => {
            const [rows, caption] = [t.querySelector('.scroll'), t.querySelector('.note')];
            return !rows || !caption || (rows.compareDocumentPosition(caption) & Node.DOCUMENT_POSITION_FOLLOWING) > 0;
        })`);
        assert.ok(order.length >= 8 && order.every(Boolean), `${order}`);
    });

claims['the wall shown is always one of the stress that is chosen, and its curve is marked'] = () =>
    withPage({}, async (page) => {
        for (const stress of ['1.00 MPa', '0.50 MPa']) {
            await page.evaluate(`${button('#curves .curves', stress)}.click()`);
            await page.until(`${caption}.startsWith('${stress}, sample 0:')`);
            assert.ok((await page.evaluate(`document.querySelector('.overlay .chosen').getAttribute('points')`)).length > 100);
        }
    });

claims['gaps of joints lie below the stones, in one colour'] = () =>
    withPage({}, async (page) => {
        const groups = await page.evaluate(`[...document.querySelector('svg.wall').children].map((g) => g.getAttribute('class'))`);
        assert.ok(groups.indexOf('gaps') >= 0 && groups.indexOf('gaps') < groups.indexOf('stones'), `${groups}`);
        const looks = await page.evaluate(`[...new Set([...document.querySelectorAll('.wall .gaps polygon')].filter((p) => p.getAttribute('visibility') === 'visible').map((p) => [p.getAttribute('fill'), p.getAttribute('stroke'), getComputedStyle(p).fillOpacity].join(' ')))]`);
        assert.ok(looks.length >= 1 && looks.every((l) => /^#(6aa5d6 #6aa5d6|c8102e #c8102e) 1$/.test(l)), `${looks}`);
    });

claims['the loops of a wall fill their chart'] = () =>
    withPage({}, async (page) => {
        const [loop, chart] = await page.evaluate(`(() => {
            const host = [...document.querySelectorAll('.curves h3')].find((h) => h.textContent.startsWith('Hysteresis')).nextElementSibling;
            const y = host.querySelector('.overlay .hovered').getAttribute('points').split(' ').map((p) => Number(p.split(',')[1]));
            return [Math.max(...y) - Math.min(...y), host.querySelector('.u-over').clientHeight];
        })()`);
        assert.ok(loop > 0.75 * chart && loop < chart, `${loop} of ${chart} px`);
    }, `${folder}/cyclic.html`);

claims['fingers find targets of 44 px'] = () =>
    withPage({ width: 390, height: 844, mobile: true }, async (page) => {
        const small = await page.evaluate(`[...document.querySelectorAll('button, select, summary, nav a, input')].filter((e) => e.checkVisibility()).map((e) => [e.textContent.slice(0, 20), e.getBoundingClientRect().height]).filter(([, h]) => h < 43.5)`);
        assert.deepEqual(small, []);
    });

claims['magnification and joint colours change the picture'] = () =>
    withPage({}, async (page) => {
        const before = await page.evaluate(outlines);
        await page.evaluate(`(() => { const r = document.getElementById('magnification'); r.value = 0; r.dispatchEvent(new Event('input')); })()`);
        assert.notEqual(await page.evaluate(outlines), before);
        assert.equal(await page.evaluate(`document.querySelector('.slider output').textContent`), '1.0 times');
        const marks = `document.querySelectorAll('.wall :is(.marks, .gaps) [visibility=visible]').length`;
        const all = await page.evaluate(marks);
        await page.evaluate(`${button('.controls', 'cracks')}.click()`);
        assert.ok((await page.evaluate(marks)) < all);
    });

claims['stone that crushes is marked, and named, where there is any'] = async () => {
    const squares = `document.querySelectorAll('.wall .crushed rect').length`;
    const named = `[...document.querySelectorAll('.key')].some((k) => k.textContent.includes('stone crushes'))`;
    await withPage({}, async (page) => {
        assert.equal(await page.evaluate(squares), 0);
        assert.equal(await page.evaluate(named), false);
    });
    await withPage({}, async (page) => {
        await page.until(`${squares} > 0`);
        assert.equal(await page.evaluate(named), true);
        await page.evaluate(`(() => { const r = document.getElementById('push'); r.value = 0; r.dispatchEvent(new Event('input')); })()`);
        assert.equal(await page.evaluate(squares), 0); // nothing is crushed before the push
    }, `${folder}/crushing.html`);
};

claims['the keyboard walks from curve to curve and opens one'] = () =>
    withPage({}, async (page) => {
        await page.evaluate(`document.querySelector('.curves .plot').focus()`);
        await page.press('ArrowRight');
        await page.press('ArrowRight');
        const spoken = await page.evaluate(`document.querySelector('.spoken').textContent`);
        assert.match(spoken, /sample \d+\n(rocking|sliding|mixed), peak [0-9.]+ kN/);
        await page.press('Enter');
        await page.until(`${caption}.startsWith(${JSON.stringify(spoken.split('\n')[0])})`);
    });

claims['tables are copied in four forms'] = () =>
    withPage({}, async (page) => {
        await page.evaluate(`navigator.clipboard.writeText = (t) => { window.copied = t; return Promise.resolve(); }`);
        const copied = async (form) => {
            await page.evaluate(`${button('#table-results', form)}.click()`);
            await page.until(`document.querySelector('#table-results .said').textContent === 'copied as ${form}'`);
            return page.evaluate('copied');
        };
        assert.match(await copied('CSV'), /^stress \[MPa\],walls,failed,/);
        assert.match(await copied('Markdown'), /\| *stress \[MPa\] \|/);
        assert.match(await copied('LaTeX'), /\\begin\{table\}/);
        assert.match(await copied('text'), /0\.5 +12 +0 /);
    });

claims['charts of all stresses and of each can be chosen'] = () =>
    withPage({}, async (page) => {
        for (const id of ['curves', 'fragility', 'running', 'sensitivity'])
            for (const b of await page.evaluate(`[...document.querySelectorAll('#${id} .choice button')].map((b, i) => i)`)) await page.evaluate(`document.querySelectorAll('#${id} .choice button')[${b}].click()`);
        assert.equal(await page.evaluate(`document.querySelectorAll('#curves > .pair > .curves > .plot .u-wrap').length`), 1);
        assert.equal(await page.evaluate(`document.querySelector('.paper').clientHeight`), 0); // for paper alone
    });

claims['running means and sensitivities of all stresses stand side by side, or one alone'] = () =>
    withPage({}, async (page) => {
        const names = (id) => page.evaluate(`[...document.querySelectorAll('#${id} figure h3')].map((h) => h.textContent)`);
        assert.deepEqual(await names('running'), ['0.50 MPa', '1.00 MPa']);
        assert.equal(await page.evaluate(`document.querySelectorAll('#running .u-wrap').length`), 2);
        assert.deepEqual((await names('sensitivity')).map((n) => n.split(',')[0]),
            ['0.50 MPa: peak force', '0.50 MPa: ultimate displacement', '1.00 MPa: peak force', '1.00 MPa: ultimate displacement']);
        await page.evaluate(`${button('#running', '1.00 MPa')}.click(), ${button('#sensitivity', '1.00 MPa')}.click()`);
        assert.deepEqual(await names('running'), ['1.00 MPa']);
        assert.equal((await names('sensitivity')).length, 2);
    });

claims['the page says in words what the study took for given'] = () =>
    withPage({}, async (page) => {
        const choices = await page.evaluate(`[...document.querySelector('#assumed .table tbody, #assumed table tbody').rows[0].cells].map((c) => c.textContent)`);
        assert.deepEqual(choices.slice(0, 3), ['solver: kinematics', 'small', 'study file']); // what moves a limit comes first
        assert.match(choices[3], /has no limit/);
        const rows = await page.evaluate(`[...document.querySelectorAll('#table-materials tbody tr')].map((r) => [...r.children].map((c) => c.textContent))`);
        const row = (name) => rows.find(([quantity]) => quantity === name).slice(1, 3);
        assert.deepEqual(row('joint: friction angle'), ['normal, mean 31.8 deg, coefficient of variation 0.20', 'drawn for each wall']);
        assert.deepEqual(row('joint: wall modulus'), ['768, 1057 MPa', 'study file']);
        assert.deepEqual(row('unit: residual cohesion'), ['0 MPa', 'default']);
        assert.match(await page.evaluate(`document.getElementById('table-wall_and_loads').textContent`), /load: vertical stress/);
    });

claims['a phone shows the page without scrolling sideways'] = () =>
    withPage({ width: 360, height: 740, mobile: true }, async (page) => {
        const [wide, screen] = await page.evaluate(`[document.documentElement.scrollWidth, innerWidth]`);
        assert.equal(screen, 360);
        assert.ok(wide <= 360, `${wide} px`);
    });

claims['paper shows curves and tables and no buttons'] = () =>
    withPage({}, async (page) => {
        await page.send('Emulation.setEmulatedMedia', { media: 'print' });
        assert.equal(await page.evaluate(`getComputedStyle(document.querySelector('.controls')).display`), 'none');
        assert.notEqual(await page.evaluate(`getComputedStyle(document.querySelector('#table-results table')).display`), 'none');
        assert.ok((await page.evaluate(`document.querySelector('.paper .u-wrap').getBoundingClientRect().height`)) > 200); // means under all stresses
        assert.ok((await page.evaluate(`document.querySelector('.paper').clientHeight`)) > 200);
        const named = await page.evaluate(`[...document.querySelectorAll('#fragility .choice button')].filter((b) => getComputedStyle(b).display !== 'none').map((b) => b.textContent)`);
        assert.deepEqual(named, ['paper ultimate', 'all']); // which limit state and stress a chart shows stays on paper
        const pdf = await page.pdf();
        assert.equal(pdf.subarray(0, 5).toString(), '%PDF-');
        const pages = pdf.toString('latin1').match(/\/Type\s*\/Page\b/g).length;
        assert.ok(pages >= 3 && pages <= 16, `${pages} pages`); // two of them with what the study assumed
    });

claims['every control and picture has a name'] = () =>
    withPage({}, async (page) => {
        const nameless = await page.evaluate(`[...document.querySelectorAll('button, select, input, [role=img], [role=group], [role=region]')]
            .filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.length)).map((e) => e.outerHTML.slice(0, 80))`);
        assert.deepEqual(nameless, []);
        const pale = await page.evaluate(`getComputedStyle(document.querySelector('.note')).color`);
        assert.equal(pale, 'rgb(89, 89, 89)'); // 7:1 on white
    });

const answers = `[...document.querySelectorAll('#whatif .answer')].map((a) => a.innerText)`;
const asked = `${folder}/asked.html`;

claims['sliders ask for walls that were not pushed, by keyboard too, and the answer has its doubt'] = () =>
    withPage({}, async (page) => {
        const before = await page.evaluate(answers);
        assert.equal(before.length, 3);
        assert.match(before[0], /^peak force\n+[0-9.]+ kN 95 % of such walls: [0-9.]+ to [0-9.]+ kN\n+Error on walls left out: [0-9.]+ kN, Q2 0\.[0-9]+\. Learned from [0-9]+ walls by a (Gaussian process|polynomial chaos)/);
        assert.match(before[1], /^ultimate drift\n+[0-9.]+ % 95 % of such walls[^]*Not to be trusted\. [0-9]+ of 40 walls outlast the push/);
        assert.match(before[2], /^failure mode\n+(rocking [0-9]+ %[^]*)?sliding [0-9]+ %[^]*mixed [0-9]+ %[^]*The likeliest mode is that of [0-9]+ % of walls left out/);
        const say = `document.querySelector('#whatif [role=status]').textContent`;
        const spoken = await page.evaluate(say);
        await page.evaluate(`document.querySelector('#whatif input').focus()`);
        for (let i = 0; i < 40; ++i) await page.press('ArrowRight');
        const after = await page.evaluate(answers);
        for (const k of [0, 1, 2]) assert.notEqual(after[k], before[k]);
        const value = await page.evaluate(`document.querySelector('#whatif input').getAttribute('aria-valuetext')`);
        assert.match(value, /^[0-9.]+ deg$/);
        assert.ok((await page.evaluate(say)).includes(`friction angle ${value}`));
        assert.notEqual(await page.evaluate(say), spoken);
        await page.evaluate(`${button('#whatif', '1.00 MPa')}.click()`);
        assert.match(await page.evaluate(say), /^1\.00 MPa, friction angle .*: peak force [0-9.]+ kN, [0-9.]+ to [0-9.]+(, not to be trusted)?; ultimate drift/);
        await page.evaluate(`${button('#whatif', '0.50 MPa')}.click(), ${button('#whatif', 'Median of each input')}.click()`);
        assert.deepEqual(await page.evaluate(answers), before);
    }, asked);

claims['beyond the walls learned from a slider says so'] = () =>
    withPage({}, async (page) => {
        const drift = `document.querySelectorAll('#whatif .answer')[1].innerText`;
        assert.doesNotMatch(await page.evaluate(drift), /Outside the walls/);
        // walls of the least and most friction outlast the push, so that their drift was not learned from
        const to = (end) => page.evaluate(`(() => { const r = document.querySelector('#whatif input'); r.value = r.${end}; r.dispatchEvent(new Event('input')); })()`);
        const said = [];
        for (const end of ['min', 'max']) said.push((await to(end), await page.evaluate(drift)));
        assert.ok(said.some((text) => /Not to be trusted\. Outside the walls learned from: friction angle \(learned between [0-9.]+ and [0-9.]+ deg\)\./.test(text)), said.join(' | '));
        assert.doesNotMatch(await page.evaluate(visibleText), kNoNumber);
    }, asked);

claims['on a phone sliders are as wide as the screen and their answers need no scrolling sideways'] = () =>
    withPage({ width: 390, height: 844, mobile: true }, async (page) => {
        const [wide, screen] = await page.evaluate(`[document.documentElement.scrollWidth, innerWidth]`);
        assert.deepEqual([wide, screen], [390, 390]);
        const boxes = await page.evaluate(`[...document.querySelectorAll('#whatif input, #whatif .answer > *')].map((e) => { const b = e.getBoundingClientRect(); return [e.tagName, b.left, b.right, b.height]; })`);
        assert.ok(boxes.length > 10);
        for (const [tag, left, right, height] of boxes) assert.ok(left >= 0 && right <= 390 && (tag !== 'INPUT' || (right - left > 330 && height >= 43.5)), `${tag} ${left} ${right} ${height}`);
    }, asked);

claims['on paper the question stands in words and the sliders are away'] = () =>
    withPage({}, async (page) => {
        await page.send('Emulation.setEmulatedMedia', { media: 'print' });
        assert.equal(await page.evaluate(`getComputedStyle(document.querySelector('#whatif .controls')).display`), 'none');
        assert.ok((await page.evaluate(`document.querySelector('#whatif .asked').getBoundingClientRect().height`)) > 10);
    }, asked);

claims['a page of few walls says so and says which'] = () =>
    withPage({}, async (page) => {
        assert.equal(await page.evaluate(`document.querySelectorAll('#wall-choice option').length`), 3);
        assert.match(await page.evaluate(`document.getElementById('curves').textContent`), /3 of 24 walls can be shown, taken in turns/);
        assert.ok(statSync(`${folder}/few.html`).size < statSync(small).size);
    }, `${folder}/few.html`);

claims['a wall that the page has no room for is named with the command that draws it'] = () =>
    withPage({}, async (page) => {
        await page.evaluate(`document.querySelector('.curves .plot').focus()`);
        for (let i = 0; i < 4; ++i) await page.press('ArrowRight'); // one of four is not among three
        let asked;
        for (let i = 0; i < 4 && !/drystone push/.test(await page.evaluate(caption)); ++i) {
            await page.press('ArrowRight');
            await page.press('Enter');
            asked = await page.evaluate(`document.querySelector('.spoken').textContent.split('\\n')[0]`);
            await page.until(`${caption}.startsWith('${asked}')`);
        }
        const [, stress, sample] = asked.match(/^([0-9.]+) MPa, sample (\d+)$/);
        const said = await page.evaluate(caption);
        assert.ok(said.startsWith(`${asked} is not among the walls`), said);
        assert.ok(said.endsWith(`/small.h5 --sample ${sample} --level ${Number(stress)}`), said); // the path that was given
        assert.equal(await page.evaluate(`document.querySelector('.play').disabled && document.getElementById('push').disabled`), true);
        await page.evaluate(`(() => { const s = document.getElementById('wall-choice'); s.selectedIndex = 0; s.dispatchEvent(new Event('change')); })()`);
        await page.until(`!document.querySelector('.play').disabled`);
        await page.until(`/: 6\\.0 mm, drift/.test(${caption})`);
    }, `${folder}/few.html`);

claims['each wall of a study of random layouts is drawn with its own stones'] = () =>
    withPage({}, async (page) => {
        const films = JSON.parse(await page.evaluate(`document.getElementById('films').textContent`));
        const walls = JSON.parse(await page.evaluate(data)).walls;
        assert.equal(films.geometries.length, 4);
        const ghosts = `[...document.querySelectorAll('.wall .ghosts > *')].map((e) => e.getAttribute('points') ?? 'beam').join(';')`;
        const seen = new Map();
        for (const { wall, geometry } of films.films) {
            const { level, sample } = walls[wall];
            await page.evaluate(`(() => { const s = document.getElementById('wall-choice'); s.value = '${wall}'; s.dispatchEvent(new Event('change')); })()`);
            await page.until(`${caption}.startsWith('${level === 0 ? '0.50' : '1.00'} MPa, sample ${sample}:')`);
            assert.equal(await page.evaluate(`document.querySelectorAll('svg.wall').length`), 1);
            assert.equal(await page.evaluate(`document.querySelectorAll('.wall .stones polygon').length`), films.geometries[geometry].blocks.length);
            const place = sample % 4;
            const stones = await page.evaluate(ghosts);
            assert.equal(seen.get(place) ?? stones, stones, 'samples of one layout show the same stones');
            seen.set(place, stones);
        }
        assert.equal(new Set(seen.values()).size, 4);
    }, `${folder}/layouts.html`);

claims['a page of many walls stays under 5 MB and takes less than two seconds of a core to open'] = () =>
    withPage({}, async (page) => {
        assert.ok(statSync(`${folder}/many.html`).size < 5e6);
        const seconds = await page.worked();
        assert.ok(seconds > 0.05 && seconds < 2, `${seconds} s`);
    }, `${folder}/many.html`);

claims['a page of many walls has walls of each stress and says what it leaves out'] = () =>
    withPage({}, async (page) => {
        assert.match(await page.evaluate(`document.getElementById('curves').textContent`), /[0-9]+ of 4400 walls can be shown, taken in turns/);
        assert.match(await page.evaluate(`document.getElementById('walls').textContent`), /4000 of 4400 walls: those with the lowest sample numbers/);
        const films = await page.evaluate(`[...document.querySelectorAll('#wall-choice optgroup')].map((g) => g.children.length)`);
        assert.equal(films.length, 2);
        assert.ok(films.every((n) => n >= 300), `${films}`);
        const curves = JSON.parse(await page.evaluate(data)).walls.filter((w) => w.level === 1);
        assert.equal(curves.length, 2000);
    }, `${folder}/many.html`);

// what their overview says, and sections where nothing can be shown
const others = {
    one_stress: { about: /6 walls under one vertical stress, 0\.50 MPa/, whatif: /No wall can be predicted\. Only [0-9] walls have the response; a surrogate needs at least 10\./ },
    nothing_random: { about: /Nothing was drawn at random/, whatif: /Nothing was random in this study, so that there is nothing to ask\./, inputs: /Nothing was random/, running: /Too few walls/, fragility: /No law is fitted to 0\.50 MPa, 1\.00 MPa: the steps are the observed shares/ },
    layouts: { about: /4 random layouts, those of wall\.seed = 1 and so on/ },
    spatial: { about: /one value per joint/, whatif: /No wall can be predicted\./ },
    shard: { about: /are not in the file: the study is not finished, or the file is a shard/, provenance: /1 of 3/ },
    some_failed: { about: /walls failed: solver\.most_steps was not enough/ },
    all_failed: { about: /no wall gave a result/, whatif: /No wall can be predicted\. Only 0 walls/, curves: /No wall under this stress gave a curve/, modes: /No wall gave a result/ },
    cyclic: { about: /in cycles of at most 3 mm/, curves: /Hysteresis: 0\.50 MPa/, cycles: /damping/ },
};

async function checkOther(page, said) {
    assert.equal(await page.evaluate(`document.querySelector('[role=alert]')`), null);
    const before = kSections.indexOf('fragility');
    const expected = said.cycles ? [...kSections.slice(0, before), 'cycles', ...kSections.slice(before)] : kSections;
    assert.deepEqual(await page.evaluate(sections), expected);
    for (const [id, text] of Object.entries(said)) assert.match(await page.evaluate(`document.getElementById('${id}').innerText`), text);
    const buttons = await page.evaluate(`document.querySelectorAll('main .choice button').length`);
    for (let b = 0; b < buttons; ++b) {
        await page.evaluate(`document.querySelectorAll('main .choice button')[${b}].click()`);
        assert.doesNotMatch(await page.evaluate(visibleText), kNoNumber);
    }
}

claims['pages of other studies open, say what they lack, and all their buttons work'] = async () => {
    for (const [name, said] of Object.entries(others)) await withPage({}, (page) => checkOther(page, said), `${folder}/${name}.html`);
};

if (!claims[claim]) throw new Error(`no claim "${claim}"`);
await claims[claim]();
