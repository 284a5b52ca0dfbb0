// node test_module.mjs DRYSTONE FOLDER CLAIM: one claim about FOLDER/drystone.wasm. Exit 1 if it does not hold.
import assert from 'node:assert/strict';
import { readFileSync, rmSync } from 'node:fs';
import { kGroups, kControls, linkOf, manyText, placeOf, studyText, usualValues, valuesOfLink } from '../../try/page/study.js';
import { assertTwentyPeaks, besideProgram, openModule, runProgram, summaryOf, valuesOf } from './module.mjs';
import { kBrittle, kScenes } from './scenes.mjs';

const [drystone, folder, claim] = process.argv.slice(2);
const wasm = `${folder}/drystone.wasm`;
const claims = {};
const kBrittlePeaks = 2e-2;

const program = (study, name, ...options) => runProgram(drystone, folder, study, name, ...options);

async function beside(scenes) {
    const { engine, keys } = await openModule(wasm);
    return besideProgram(scenes, keys, (study) => engine.push(study), drystone, folder);
}

claims['twenty walls have the peaks of the program within 0.1 percent'] = async () => assertTwentyPeaks(kScenes, await beside(kScenes));

claims['walls whose stones crack before the peak have the peaks of the program within 2 percent'] = async () => {
    const { differences } = await beside(kBrittle);
    for (const [i, d] of differences.entries()) assert.ok(Math.abs(d) < kBrittlePeaks, `${JSON.stringify(kBrittle[i])}: ${100 * d} %`);
};

claims['a wrong value has the message of the program'] = async () => {
    const { engine, keys } = await openModule(wasm);
    const wrong = { 'joint.friction_angle': '95', 'wall.courses': '2.5', 'load.vertical_stress': '0.5 kg', 'wall.length': '', more: 'wall.lenght = 1 m', 'stone.density': 'heavy' };
    for (const [key, value] of Object.entries(wrong)) {
        const study = studyText(valuesOf({ [key]: value }), keys);
        const { error } = engine.look(study);
        const run = program(study, 'wrong');
        assert.equal(run.status, 2);
        assert.equal(run.stderr.split('\n')[0].replace(/^.*study\.ini/, 'study.ini'), error.split('\n')[0]);
        if (key !== 'more') assert.equal(placeOf(error).key, key);
    }
    assert.equal(engine.look(studyText(usualValues(), keys)).error, undefined);
};

claims['the study of the page is the wall of configs/wall.ini'] = async () => {
    const { engine, keys } = await openModule(wasm);
    const bare = (text) => text.split('\n').filter((line) => !line.startsWith('#')).map((line) => line.replace(/ *#.*/, '').replace(/^(height += 1\.1)0 m$/, '$1 m')).join('\n');
    const mine = engine.look(studyText(usualValues(), keys));
    const its = engine.look(readFileSync(new URL('../../configs/wall.ini', import.meta.url), 'utf8'));
    assert.equal(bare(mine.study), bare(its.study));
};

claims['every control is a key of the program and has its unit'] = async () => {
    const { keys } = await openModule(wasm);
    for (const { key, words, value } of kControls) {
        if (key === 'direction') continue;
        const known = keys.get(key);
        assert.ok(known, key);
        for (const word of words ?? []) assert.ok(known.words.includes(word) || word === value, `${key}: ${word}`);
        assert.ok(known.meaning.length > 5 && known.allowed.length > 2);
    }
    assert.ok(kGroups.length >= 4);
};

claims['a link holds the wall'] = async () => {
    const values = { ...usualValues(), 'wall.length': '1.70', direction: 'left', more: 'solver.accuracy = 0.5 %\n# é' };
    assert.equal(linkOf(usualValues()), '');
    assert.deepEqual(valuesOfLink(linkOf(values)), values);
    assert.deepEqual(valuesOfLink('#wall.length=%E0%A4%A&nonsense=1&wall.courses=7'), { ...usualValues(), 'wall.courses': '7' });
};

claims['random walls are those of the program and do not depend on how they are shared out'] = async () => {
    const found = [];
    const { engine, keys } = await openModule(wasm, { wall: (w) => found.push(w) });
    const cov = { 'joint.friction_angle': '0.2', 'unit.tensile_strength': '0.3', 'joint.stiffness_factor': '0.25' };
    const study = manyText(valuesOf(kScenes[0]), keys, cov, 5);
    assert.equal(engine.walls(study, 0, 1).walls, 5);
    const alone = found.splice(0).sort((a, b) => a.sample - b.sample);
    for (const first of [0, 1]) engine.walls(study, first, 2);
    assert.deepEqual(found.sort((a, b) => a.sample - b.sample).map((w) => w.peak_kN), alone.map((w) => w.peak_kN));
    for (const sample of [0, 3]) {
        const run = program(study, 'random', '--sample', String(sample));
        assert.equal(run.status, 0, run.stderr);
        const its = summaryOf(run);
        assert.ok(Math.abs(alone[sample].peak_kN / its.peak_force_kN - 1) < 1e-3);
    }
    const drifts = alone.map((w) => w.limits[0].drift_percent);
    assert.ok(new Set(drifts).size > 1);
};

claims['a fit of drifts has the median of its walls'] = async () => {
    const { engine } = await openModule(wasm);
    const observed = Array.from({ length: 41 }, (_, i) => 0.5 * Math.exp(0.3 * (i - 20) / 12));
    const fit = engine.fit({ observed, censored: [], capped: [] });
    assert.ok(Math.abs(fit.median_percent / 0.5 - 1) < 1e-6);
    assert.equal(fit.steps.length, 41);
    assert.match(engine.fit({ observed: [], censored: [1, 1, 1], capped: [] }).reason, /censored/);
    const capped = engine.fit({ observed: [0.4, 0.5, 0.6], censored: [], capped: [0.375, 0.375] });
    assert.ok(capped.points === undefined && capped.reason.length > 10, 'no law of drift limits of a code');
};

claims['a push tells how the wall moves'] = async () => {
    const seen = { frames: [], progress: [], scene: null };
    const { engine, keys } = await openModule(wasm, { begin: (s) => (seen.scene = s), frame: (n, mm, kN) => seen.frames.push({ n, mm, kN }), progress: (done) => seen.progress.push(done) });
    const result = engine.push(studyText(valuesOf(kScenes[0]), keys), 20);
    assert.ok(seen.frames.length >= 20);
    const size = seen.scene.blocks.reduce((sum, b) => sum + b.outline.length, 0) + 3 * seen.scene.faces.length;
    assert.ok(seen.frames.every((f) => f.n.length === size));
    const last = seen.frames.at(-1);
    const beam = seen.scene.blocks.slice(0, -1).reduce((sum, b) => sum + b.outline.length, 0);
    const at = seen.scene.blocks.at(-1).outline.reduce((best, z, i, all) => (i % 2 && z > all[best] ? i : best), 1) - 1;
    assert.ok(Math.abs(1e3 * last.n[beam + at] / last.mm - 1) < 0.01, 'the top has the displacement of the load');
    assert.ok(seen.progress.every((d) => d >= 0 && d <= 1) && seen.progress.length > 5);
    assert.ok(result['capacity.csv'].startsWith('displacement_mm,'));
    for (const name of ['capacity.svg', 'wall.svg']) assert.match(result[name], /^<\?xml|^<svg/);
};

if (!(claim in claims)) throw new Error(`no such claim: ${claim}`);
await claims[claim]();
rmSync(`${folder}/scenes/${process.pid}`, { recursive: true, force: true });
