// The module of the page in Node.
import { readFileSync } from 'node:fs';
import { openEngine } from '../../try/page/engine.js';
import { usualValues } from '../../try/page/study.js';

export async function openModule(file, told = {}) {
    const engine = await openEngine(await WebAssembly.compile(readFileSync(file)), told);
    return { engine, keys: new Map(engine.keys().map((key) => [key.name, key])) };
}

export const valuesOf = (scene) => ({ ...usualValues(), ...scene });
