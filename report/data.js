// From the text in the page to numbers.

export async function inflate(base64) {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Undoes differences() of app/report/report_bytes.hpp: `count` numbers from byte `from`, in steps. */
export function sums(bytes, from, count, length, order) {
    const v = new Int16Array(count);
    for (let i = 0; i < count; ++i) {
        const folded = bytes[from + i] | (bytes[from + count + i] << 8);
        v[i] = (folded >> 1) ^ -(folded & 1);
    }
    for (let pass = 0; pass < order; ++pass)
        for (let i = 0; i < count; ++i) if (i % length !== 0) v[i] += v[i - 1];
    return v;
}

/** Forces of a wall in kN, null where it is not pushed any more: force(w), a list on the displacements x [mm]. */
export async function readCurves(curves) {
    const n = curves.points;
    const steps = sums(await inflate(curves.data), 0, n * curves.counts.length, n, 1);
    const x = Array.from({ length: n }, (_, i) => i * curves.step * 1e3);
    const known = new Map();
    const read = (w) => {
        const forces = new Array(n).fill(null);
        for (let i = 0; i < curves.counts[w]; ++i) forces[i] = steps[w * n + i] * curves.force_step * 1e-3;
        known.set(w, forces);
        return forces;
    };
    return { x, counts: curves.counts, forces: (w) => known.get(w) ?? read(w) };
}

/** Paths of walls that are pushed to and fro: path(w) -> {x [mm], f [kN]}, at(w, t) -> the point at frame t of its film. */
export async function readLoops(loops) {
    const n = loops.points;
    const walls = loops.counts.length;
    const bytes = await inflate(loops.data);
    const x = sums(bytes, 0, n * walls, n, 1);
    const f = sums(bytes, 2 * n * walls, n * walls, n, 1);
    const mm = loops.step * 1e3;
    const kn = loops.force_step * 1e-3;
    const path = (w) => ({
        x: Array.from(x.subarray(w * n, w * n + loops.counts[w]), (v) => v * mm),
        f: Array.from(f.subarray(w * n, w * n + loops.counts[w]), (v) => v * kn),
    });
    const at = (w, t) => {
        if (!loops.counts[w]) return null;
        const place = Math.min(loops.counts[w] - 1, Math.round(t * loops.per_frame));
        return { place, x: x[w * n + place] * mm, f: f[w * n + place] * kn };
    };
    return { path, at };
}

/** Motion of one wall: displacement of the load [m], six numbers of each block [m], damage of each crack, crushing of both halves of each face. */
export async function readFilm(film, geometry) {
    const bytes = await inflate(film.data);
    const n = film.frames;
    const blocks = geometry.blocks.length;
    const cracks = geometry.faces.filter((f) => f[0] === 'crack').length;
    const drive = sums(bytes, 0, n, n, 2);
    const motion = sums(bytes, 2 * n, 6 * blocks * n, n, 2);
    const damage = sums(bytes, 2 * n + 12 * blocks * n, cracks * n, n, 1);
    const crushing = film.crushing ? sums(bytes, 2 * n + 12 * blocks * n + 2 * cracks * n, 2 * geometry.faces.length * n, n, 1) : null;
    const at = (series, t) => {
        const i = Math.min(n - 1, Math.floor(t));
        const j = Math.min(n - 1, i + 1);
        return series[0][series[1] + i] + (t - i) * (series[0][series[1] + j] - series[0][series[1] + i]);
    };
    return {
        frames: n,
        displacement: (t) => at([drive, 0], t) * film.step,
        motion: (block, k, t) => at([motion, (k * blocks + block) * n], t) * film.step,
        damage: (crack, t) => at([damage, crack * n], t) / 255,
        crushes: film.crushing,
        crushing: (face, half, t) => (crushing ? at([crushing, (2 * face + half) * n], t) / 255 : 0),
    };
}
