// node test_whatif.mjs DRYSTONE FOLDER: page and surrogates of test_whatif.sh. Exit 1 if a prediction of the page is not the program's.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';
import { modeProbabilities, outside, predicted } from '../../report/surrogate.js';

const [drystone, folder] = process.argv.slice(2);
const kSame = 1e-9; // relative

const kResponses = ['peak_force', 'ultimate_drift'];
const kScale = { peak_force: 1e3, ultimate_drift: 1e-2 }; // SI / shown unit

const [, base64] = readFileSync(`${folder}/asked.html`, 'utf8').match(/id="data">([^<]*)</);
const page = JSON.parse(inflateSync(Buffer.from(base64, 'base64'))).whatif;
const families = page.inputs.map((i) => i.coordinate);

/** The file's models over HTTP: evaluate(name, x) -> outputs. */
async function served(file, ask) {
    const server = spawn(drystone, ['serve', file, '--port', '0'], { stdio: ['ignore', 'pipe', 'ignore'] });
    try {
        const address = await new Promise((done, failed) => {
            let said = '';
            server.once('exit', () => failed(new Error(`the server has ended: ${said}`)));
            server.stdout.setEncoding('utf8').on('data', (text) => {
                const found = (said += text).match(/http:\/\/\S+:\d+/);
                if (found) done(found[0]);
            });
        });
        const post = async (place, request) => (await fetch(address + place, { method: 'POST', body: JSON.stringify(request) })).json();
        const { models } = await (await fetch(`${address}/Info`)).json();
        await ask(models, async (name, x) => (await post('/Evaluate', { name, input: [x], config: {} })).output[0], async (name) => (await post('/Columns', { name })).outputs.map((o) => o.name));
    } finally {
        server.kill();
    }
}

const near = (a, b, room, what) => assert.ok(Math.abs(a - b) <= room * Math.max(Math.abs(a), Math.abs(b)), `${what}: page ${a}, program ${b}`);

/** Places of the sliders that fill their box. */
const places = Array.from({ length: 40 }, (_, n) => page.inputs.map((i, k) => (n < 2 ? n * (i.values.length - 1) : (7 + n * (29 + 12 * k)) % i.values.length)));

async function check(file, levels, response) {
    let compared = 0;
    await served(file, async (models, evaluate, columns) => {
        for (const [l, level] of levels.entries()) {
            const model = models.find((m) => m.includes(['0.50', '1.00'][l]));
            assert.ok(model, `${models}`);
            const names = page.modes[l].none ? [] : page.modes[l].names;
            assert.deepEqual((await columns(model)).slice(3), names.flatMap((n) => [n, `${n}_sd`]));
            for (const place of places) {
                const values = page.inputs.map((i, k) => i.values[place[k]]);
                const c = page.inputs.map((i, k) => i.coordinates[place[k]]);
                const told = await evaluate(model, page.inputs.map((i, k) => values[k] / i.scale));
                const { mean, sd } = predicted(level, families, c);
                const what = `${response}, ${model}, ${level.better} at ${values}`;
                near(mean * kScale[response], told[0], kSame, what);
                near(sd * kScale[response], told[1], kSame, `doubt of ${what}`);
                assert.equal(outside(level, values).length, told[2], what);
                if (!names.length) continue;
                modeProbabilities(page.modes[l], c).forEach(({ value, sd: error }, k) => {
                    near(value, told[3 + 2 * k], kSame, `P(${names[k]}), ${what}`);
                    near(error, told[4 + 2 * k], kSame, `doubt of P(${names[k]}), ${what}`);
                });
                ++compared;
            }
        }
    });
    return compared;
}

for (const [r, response] of kResponses.entries()) {
    assert.ok(page.responses[r].levels.every((l) => l.better), 'each level has a surrogate');
    assert.ok((await check(`${folder}/${response}/surrogate.json`, page.responses[r].levels, response)) > 0);
    // and the worse of both kinds, as if it were the better one
    const file = JSON.parse(readFileSync(`${folder}/${response}/surrogate.json`, 'utf8'));
    for (const level of file.surrogates) level.better = level.better === 'chaos' ? 'process' : 'chaos';
    writeFileSync(`${folder}/${response}/other.json`, JSON.stringify(file));
    await check(`${folder}/${response}/other.json`, file.surrogates, response);
}
