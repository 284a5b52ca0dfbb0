// The module of the page in Node, and the program beside it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { openEngine } from '../../try/page/engine.js';
import { studyText, usualValues } from '../../try/page/study.js';

export async function openModule(file, told = {}) {
    const engine = await openEngine(await WebAssembly.compile(readFileSync(file)), told);
    return { engine, keys: new Map(engine.keys().map((key) => [key.name, key])) };
}

export const valuesOf = (scene) => ({ ...usualValues(), ...scene });

/** Pushes a study with the program, in a folder of its own below `folder`. */
export function runProgram(drystone, folder, study, name, ...options) {
    const place = `${folder}/scenes/${process.pid}/${name}`;
    mkdirSync(place, { recursive: true });
    writeFileSync(`${place}/study.ini`, study);
    return { place, ...spawnSync(drystone, ['push', `${place}/study.ini`, '--out', `${place}/out`, '--quiet', ...options], { encoding: 'utf8' }) };
}

export const summaryOf = (run) => JSON.parse(readFileSync(`${run.place}/out/summary.json`, 'utf8'));

/**
 * Peaks that `push` finds over those of the program, less 1; and how many walls have its mode.
 * @param push of a study, to what the module says of it
 */
export async function besideProgram(scenes, keys, push, drystone, folder) {
    let same = 0;
    const differences = [];
    for (const [i, scene] of scenes.entries()) {
        const study = studyText(valuesOf(scene), keys);
        const mine = await push(study);
        assert.equal(mine.error, undefined);
        const run = runProgram(drystone, folder, study, String(i));
        assert.equal(run.status, 0, run.stderr);
        const its = summaryOf(run);
        if (mine.summary.mode === its.mode) ++same;
        differences.push(mine.summary.peak_force_kN / its.peak_force_kN - 1);
    }
    console.log(differences.map((d) => (100 * d).toFixed(4)).join(' '), '%');
    return { differences, same };
}

const kPeaks = 1e-3; // largest difference [-]

/** Twenty walls have the peaks of the program within 0.1 %. */
export function assertTwentyPeaks(scenes, { differences, same }) {
    assert.equal(differences.length, 20);
    for (const [i, d] of differences.entries()) assert.ok(Math.abs(d) < kPeaks, `${JSON.stringify(scenes[i])}: ${100 * d} %`);
    assert.ok(same >= 18, `${same} walls have the mode of the program`); // a wall may stand between two
}
