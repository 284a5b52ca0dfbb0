// node test_page.mjs CHROMIUM DRYSTONE FOLDER CLAIM: opens FOLDER/index.html from its folder and checks one claim. Exit 1 if it does not hold.
import assert from 'node:assert/strict';
import { rmSync, statSync } from 'node:fs';
import { resolve } from 'node:path';
import { openPage } from '../report/browser.mjs';
import { studyText } from '../../try/page/study.js';
import { assertTwentyPeaks, besideProgram, openModule, valuesOf } from './module.mjs';
import { kScenes } from './scenes.mjs';

const [program, drystone, place, claim] = process.argv.slice(2);
const folder = resolve(place);
const file = `${folder}/index.html`;
const claims = {};

const at = (scene) => `${file}#${Object.entries(scene).map(([key, value]) => `${key}=${encodeURIComponent(value)}`).join('&')}`;
const data = (name) => `document.documentElement.dataset.${name}`;
const press = (id) => `document.getElementById(${JSON.stringify(id)}).click()`;
const text = (id) => `document.getElementById(${JSON.stringify(id)}).innerText`;
const hidden = (id) => `document.getElementById(${JSON.stringify(id)}).hidden`;
const set = (id, value) => `{ const box = document.getElementById(${JSON.stringify(id)}); box.value = ${JSON.stringify(value)}; box.dispatchEvent(new Event('input')); }`;

async function withPage(options, address, check) {
    const page = await openPage(program, options);
    try {
        const seconds = await page.open(address);
        await check(page, seconds);
        assert.deepEqual(page.problems(), [], 'errors and warnings of the console');
        const asked = page.requests().filter((url) => !url.startsWith('blob:') && !url.startsWith('data:'));
        assert.deepEqual(asked.map((url) => url.split('#')[0]), [`file://${file}`], 'requests');
    } finally {
        await page.close();
    }
}

async function pushed(page, seconds = 60) {
    await page.evaluate(press('push'));
    await page.until(`!${hidden('answers')} || !${hidden('trouble')}`, seconds);
    assert.equal(await page.evaluate(hidden('trouble')), true);
}

/** In the page: the worker and the module that it has, asked for one push. */
const kPushOfPage = `async (study) => {
    const text = (id) => document.getElementById(id).textContent;
    const packed = Uint8Array.from(atob(text('module').trim()), (c) => c.charCodeAt(0));
    window.compiled ??= await WebAssembly.compile(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
    const worker = new Worker(URL.createObjectURL(new Blob([text('worker')], { type: 'text/javascript' })));
    const { error, summary } = await new Promise((done) => {
        worker.onmessage = ({ data }) => data.kind === 'done' && done(data.value);
        worker.postMessage({ module: window.compiled, job: 'push', study, frames: 2 });
    });
    worker.terminate();
    return { error, summary };
}`;

claims['twenty walls in Chromium have the peaks of the program within 0.1 percent'] = () =>
    withPage({}, file, async (page) => {
        const { keys } = await openModule(`${folder}/drystone.wasm`);
        assertTwentyPeaks(kScenes, await besideProgram(kScenes, keys, (study) => page.evaluate(`(${kPushOfPage})(${JSON.stringify(study)})`), drystone, folder));
        rmSync(`${folder}/scenes/${process.pid}`, { recursive: true, force: true });
    });

claims['one click pushes the wall and gives the peak of the module in Node'] = () =>
    withPage({}, at(kScenes[0]), async (page) => {
        const { engine, keys } = await openModule(`${folder}/drystone.wasm`);
        const { summary } = engine.push(studyText(valuesOf(kScenes[0]), keys));
        await pushed(page);
        const tiles = await page.evaluate(text('tiles'));
        assert.ok(tiles.includes(summary.peak_force_kN.toFixed(2)), tiles);
        assert.ok(tiles.includes(summary.mode));
        assert.ok((await page.evaluate(`document.querySelectorAll('#limits tbody tr').length`)) >= 4);
        assert.doesNotMatch(await page.evaluate('document.body.innerText'), /\b(NaN|undefined|null|Infinity)\b/);
    });

claims['the first picture comes within a second'] = async () => {
    let best = Infinity; // the quickest counts: the machine may have other things to do
    for (let again = 0; again < 4 && best >= 1000; ++again) await withPage({}, file, async (page) => (best = Math.min(best, Number(await page.evaluate(data('first'))))));
    assert.ok(best < 1000, `${best} ms`);
    assert.ok(statSync(file).size < 1.5e6);
};

claims['a wrong value shows the message of the program at its control and mends'] = () =>
    withPage({}, file, async (page) => {
        await page.evaluate(set('k-joint-friction_angle', '95'));
        await page.until(`!${hidden('trouble')}`);
        assert.match(await page.evaluate(text('trouble')), /study\.ini:\d+: joint\.friction_angle: "95 deg" is out of range; must be in \[0, 90\) deg/);
        assert.match(await page.evaluate(`document.querySelector('[data-key="joint.friction_angle"] .said').innerText`), /out of range/);
        assert.equal(await page.evaluate(`document.getElementById('push').disabled`), true);
        await page.evaluate(set('k-joint-friction_angle', '30'));
        await page.until(hidden('trouble'));
        assert.equal(await page.evaluate(`document.getElementById('push').disabled`), false);
        assert.match(await page.evaluate('location.hash'), /joint\.friction_angle=30/);
    });

claims['Stop ends a push and another one can begin'] = () =>
    withPage({}, file, async (page) => {
        await page.evaluate(press('push'));
        await page.until(`!${hidden('stop')} && document.getElementById('progress').value > 0`);
        await page.evaluate(press('stop'));
        assert.match(await page.evaluate(text('status')), /stopped at/);
        assert.equal(await page.evaluate(hidden('answers')), true);
        await page.evaluate(`{ location.hash = ${JSON.stringify(at(kScenes[0]).split('#')[1])}; }`);
        await page.until(`document.getElementById('k-wall-courses').value === '5'`);
        await pushed(page);
    });

claims['what is copied and downloaded is the wall of the page'] = () =>
    withPage({}, at(kScenes[13]), async (page) => {
        await page.send('Page.setDownloadBehavior', { behavior: 'deny' });
        const { keys } = await openModule(`${folder}/drystone.wasm`);
        await page.evaluate(press('copy'));
        await page.until(`${data('copied')} !== undefined`);
        assert.equal(await page.evaluate(data('copied')), studyText(valuesOf(kScenes[13]), keys));
        await pushed(page);
        for (const [id, name] of [['csv', 'capacity.csv'], ['svg-curve', 'capacity.svg'], ['svg-wall', 'wall.svg']]) {
            await page.evaluate(press(id));
            assert.equal(await page.evaluate(data('downloaded')), name);
        }
    });

claims['fifty random walls give a fragility curve'] = () =>
    withPage({}, at({ ...kScenes[0], 'wall.courses': '3', 'load.max_displacement': '5' }), async (page) => {
        await page.send('Page.setDownloadBehavior', { behavior: 'deny' });
        await page.evaluate(press('push-many'));
        await page.until(`${data('manySeconds')} !== undefined`, 150);
        assert.match(await page.evaluate(text('status-many')), /^50 walls in/);
        assert.ok((await page.evaluate(`document.getElementById('limit').options.length`)) >= 4);
        assert.match(await page.evaluate(text('fragility-text')), /reached it/);
        await page.evaluate(press('csv-many'));
        assert.equal(await page.evaluate(`document.getElementById('csv-many').hidden + ' ' + ${data('downloaded')}`), 'false walls.csv');
    });

claims['a phone has no sideways scroll and the button in reach, keys push and stop'] = () =>
    withPage({ width: 390, height: 844, mobile: true }, at(kScenes[0]), async (page) => {
        assert.equal(await page.evaluate('document.documentElement.scrollWidth'), 390);
        const box = await page.evaluate(`(({ top, bottom, height }) => ({ top, bottom, height }))(document.getElementById('push').getBoundingClientRect())`);
        assert.ok(box.top > 0 && box.bottom <= 844 && box.height >= 40);
        await page.evaluate(`document.getElementById('push').focus()`);
        await page.evaluate(`document.getElementById('k-load-vertical_stress').focus()`);
        await page.evaluate(`document.getElementById('controls').requestSubmit()`);
        await page.until(`!${hidden('answers')}`, 60);
        assert.equal(await page.evaluate('document.activeElement.id'), 'push');
        assert.equal(await page.evaluate('document.documentElement.scrollWidth'), 390);
    });

if (!(claim in claims)) throw new Error(`no such claim: ${claim}`);
await claims[claim]();
