// The WebAssembly module as functions: in the page, in its workers and in Node.

/** What libc++ asks of a system: a clock, and a place for last words. */
function systemCalls(memory, says) {
    const view = () => new DataView(memory().buffer);
    const kNotThere = 52;
    const calls = {
        clock_time_get(id, precision, at) {
            view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
            return 0;
        },
        fd_write(file, pieces, count, written) {
            let bytes = 0;
            for (let i = 0; i < count; ++i) {
                const at = view().getUint32(pieces + 8 * i, true);
                const size = view().getUint32(pieces + 8 * i + 4, true);
                says(new TextDecoder().decode(new Uint8Array(memory().buffer, at, size)));
                bytes += size;
            }
            view().setUint32(written, bytes, true);
            return 0;
        },
        proc_exit(code) {
            throw new Error(`the program ended with code ${code}`);
        },
    };
    return new Proxy(calls, { get: (own, name) => own[name] ?? (() => kNotThere) });
}

/**
 * @param module a compiled WebAssembly.Module
 * @param told progress(done, mm, kN), begin(scene), frame(numbers, mm, kN), again(), wall(result): while walls are pushed
 */
export async function openEngine(module, told = {}) {
    let memory;
    let last = '';
    const text = (at, size) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, size));
    const page = {
        progress: (done, displacement, force) => told.progress?.(done, 1e3 * displacement, 1e-3 * force),
        frame: (at, size, displacement, force) => told.frame?.(new Float32Array(memory.buffer, at, size).slice(), 1e3 * displacement, 1e-3 * force),
        again: () => told.again?.(),
        begin: (at, size) => told.begin?.(JSON.parse(text(at, size))),
        wall: (at, size) => told.wall?.(JSON.parse(text(at, size))),
    };
    const system = systemCalls(() => memory, (words) => (last += words));
    const imports = { page, wasi_snapshot_preview1: system };
    const { exports } = await WebAssembly.instantiate(module, imports);
    memory = exports.memory;
    exports._initialize();

    function answer(call, words, ...rest) {
        last = '';
        const bytes = new TextEncoder().encode(words);
        try {
            const at = exports.take(bytes.length + 1);
            new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
            const from = call(at, bytes.length, ...rest);
            exports.give_back(at);
            const all = new Uint8Array(memory.buffer);
            return JSON.parse(text(from, all.indexOf(0, from) - from));
        } catch (trouble) {
            return { error: `this wall is beyond the page (${last.trim() || trouble.message}); take the program`, ended: true };
        }
    }
    return {
        keys: () => answer(exports.keys, ''),
        look: (study) => answer(exports.look, study),
        push: (study, frames = 60) => answer(exports.push, study, frames),
        walls: (study, first, step) => answer(exports.walls, study, first, step),
        fit: (drifts) => answer(exports.fit, JSON.stringify(drifts)),
        bytes: () => memory.buffer.byteLength,
    };
}
