// node bench/page.mjs CHROMIUM PAGE.html FOLDER RUNS   measures the page of a study; bench/page.sh calls it.
import { execFileSync } from 'node:child_process';
import { statSync, writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { openPage } from '../tests/report/browser.mjs';

const [program, file, folder, runs] = process.argv.slice(2);
const load = loadavg()[0].toFixed(2);
const idle = loadavg()[0] < 1; // else times are those of others, and only seconds of processor are held to an aim
const kScreens = { desk: { width: 1440, height: 900 }, phone: { width: 390, height: 844, mobile: true } };

// What the first screen shows: the curves, a wall, the table of limits.
const kParts = { curves: '.curves .u-over', wall: 'svg.wall', limits: '#overview table' };

// Runs in the page before anything of it: notes when a frame has first shown each part.
const kWatch = `(() => {
    const seen = (window.firstSeen = {});
    const parts = ${JSON.stringify(kParts)};
    const look = (now) => {
        for (const [name, selector] of Object.entries(parts))
            if (seen[name] === undefined && document.querySelector(selector)?.getBoundingClientRect().height > 0) {
                seen[name] = now;
                requestAnimationFrame(() => (seen[name] = performance.now()));
            }
        if (Object.keys(seen).length < Object.keys(parts).length) requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
})()`;

async function withPage(options, use) {
    const page = await openPage(program, options);
    try {
        await page.send('Page.addScriptToEvaluateOnNewDocument', { source: kWatch });
        const drawn = await page.open(file);
        await page.drawn();
        const problems = page.problems();
        if (problems.length > 0) throw new Error(problems.join('; '));
        return await use(page, drawn);
    } finally {
        await page.close();
    }
}

/** Seconds from the request of the page to the frame that shows a part, and of its processor until all is drawn. */
const opening = (options) =>
    withPage(options, async (page, drawn) => ({ seen: await page.evaluate('firstSeen'), drawn, core: await page.worked() }));

/** A table, all of it and the curves: how far they reach below the first screen, and the page to its side [px]. */
const first_screen = (name) =>
    withPage(kScreens[name], async (page) => {
        const { data } = await page.send('Page.captureScreenshot', { format: 'png' });
        writeFileSync(`${folder}/${name}.png`, Buffer.from(data, 'base64'));
        const box = (selector) => page.evaluate(`(() => { const b = document.querySelector('${selector}').getBoundingClientRect(); return { top: b.top, bottom: b.bottom }; })()`);
        const screen = kScreens[name];
        const shown = {};
        for (const [part, selector] of Object.entries(kParts)) {
            const b = await box(selector);
            shown[part] = (Math.min(b.bottom, screen.height) - Math.max(b.top, 0)) / (b.bottom - b.top);
        }
        return { shown, beside: await page.evaluate('document.documentElement.scrollWidth - innerWidth') };
    });

/** Steps of the tabulator key to the curves, and whether a wall can be chosen there without a mouse. */
const keyboard = () =>
    withPage(kScreens.desk, async (page) => {
        const caption = `document.querySelector('.view figcaption').textContent`;
        let steps = 0;
        while (!(await page.evaluate(`document.activeElement?.matches('.curves .plot') ?? false`)) && steps < 60) {
            await page.press('Tab');
            ++steps;
        }
        const before = await page.evaluate(caption);
        for (let i = 0; i < 3; ++i) await page.press('ArrowRight');
        await page.press('Enter');
        await page.until(`${caption} !== ${JSON.stringify(before)}`, 5);
        return steps;
    });

const pages = () =>
    withPage(kScreens.desk, async (page) => {
        const pdf = await page.pdf();
        writeFileSync(`${folder}/page.pdf`, pdf);
        return pdf.toString('latin1').match(/\/Type\s*\/Page\b/g).length;
    });

const openings = { desk: [], phone: [] };
for (let i = 0; i < Number(runs); ++i)
    for (const name of Object.keys(openings)) openings[name].push(await opening(kScreens[name]));
const screens = { desk: await first_screen('desk'), phone: await first_screen('phone') };
const least = (name, of) => Math.min(...openings[name].map(of));
const walls = await withPage({}, (page) => page.evaluate(`document.querySelector('#walls summary')?.textContent.match(/\\d+/)?.[0] ?? document.querySelectorAll('#walls tbody tr').length`));

const rows = [['size', statSync(file).size / 1e6, 'MB', 5]];
for (const name of ['desk', 'phone']) {
    const { width, height } = kScreens[name];
    const on = `${width} x ${height}`;
    rows.push([`${on}: first picture of the curves`, least(name, (o) => o.seen.curves / 1e3), 's', idle ? 1 : null]);
    rows.push([`${on}: first picture of the wall`, least(name, (o) => o.seen.wall / 1e3), 's', idle ? 1 : null]);
    rows.push([`${on}: table of limits`, least(name, (o) => o.seen.limits / 1e3), 's', idle ? 1 : null]);
    rows.push([`${on}: all sections`, least(name, (o) => o.drawn), 's', idle ? 2 : null]);
    rows.push([`${on}: seconds of processor of the page until then`, least(name, (o) => o.core), 's', 1]);
    rows.push([`${on}: page wider than the screen`, screens[name].beside, 'px', 0]);
    for (const part of Object.keys(kParts))
        rows.push([`${on}: ${part} not on the first screen`, 100 * (1 - Math.max(screens[name].shown[part], 0)), '%', part === 'limits' ? 0 : 50]);
}
rows.push(['tabulator steps to the curves, where arrows and Enter choose a wall', await keyboard(), '', 40]);
rows.push(['printed pages', await pages(), '', 16]);

const version = execFileSync(program, ['--version'], { encoding: 'utf8' }).match(/[\d.]+/)[0];
const table = rows.map(([what, value, unit, aim]) => `| ${what} | ${Number(value.toPrecision(3))} ${unit} | ${aim === null ? '' : `${aim} ${unit}`} |`);
const text = `# The page of a study

Written by \`bash bench/page.sh\`: ${walls} walls in its table, Chromium ${version} without a screen, ${cpus().length} cores of ${cpus()[0].model.trim()}, load before: ${load}. Shortest of ${runs}
openings, from the request of the page to the frame that shows a part.

| what | measured | at most |
|---|---:|---:|
${table.join('\n')}
`;
writeFileSync(`${folder}/page.md`, text);
console.log(text);
const missed = rows.filter(([, value, , aim]) => aim !== null && !(value <= aim));
for (const [what, value, unit, aim] of missed) console.error(`${what}: ${Number(value.toPrecision(3))} ${unit}, aim ${aim} ${unit}`);
process.exit(missed.length > 0 ? 1 : 0);
