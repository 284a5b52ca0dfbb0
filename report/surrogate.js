// Walls that were never run: the formulas of docs/surrogates.md, "Predict from the file". c: coordinates of the inputs of a wall.

/** Coefficients of sqrt(next) p_k+1 = (c - middle) p_k - sqrt(last) p_k-1: laguerre a, jacobi a b. */
function recurrence(kind, a, b, k) {
    if (kind === 'laguerre') return { middle: 2 * k + 1 + a, last: k * (k + a), next: (k + 1) * (k + 1 + a) };
    const square = (n) => {
        const s = 2 * n + a + b;
        if (n === 0) return 0;
        if (n === 1) return (4 * (1 + a) * (1 + b)) / (s * s * (s + 1));
        return (4 * n * (n + a) * (n + b) * (n + a + b)) / (s * s * (s + 1) * (s - 1));
    };
    const s = 2 * k + a + b;
    return { middle: k === 0 ? (b - a) / (s + 2) : (b * b - a * a) / (s * (s + 2)), last: square(k), next: square(k + 1) };
}

/** Values at c of the polynomials of degree 0 ... most with mean square 1. family: "hermite", "jacobi 0.5 1" */
function orthonormal(family, most, c) {
    const p = [1];
    const [kind, a, b] = family.split(' ');
    if (kind === 'jacobi' || kind === 'laguerre') {
        for (let k = 0; k < most; ++k) {
            const r = recurrence(kind, Number(a), Number(b), k);
            p.push(((c - r.middle) * p[k] - (k > 0 ? Math.sqrt(r.last) * p[k - 1] : 0)) / Math.sqrt(r.next));
        }
        return p;
    }
    if (family === 'hermite') {
        for (let k = 0; k < most; ++k) p.push((c * p[k] - (k > 0 ? Math.sqrt(k) * p[k - 1] : 0)) / Math.sqrt(k + 1));
        return p;
    }
    for (let k = 0; k < most; ++k) p.push(((2 * k + 1) * c * p[k] - (k > 0 ? k * p[k - 1] : 0)) / (k + 1));
    return p.map((v, k) => v * Math.sqrt(2 * k + 1));
}

function chaosMean(chaos, families, c) {
    const p = families.map((family, k) => orthonormal(family, Math.max(...chaos.degrees.map((d) => d[k])), c[k]));
    const term = (degrees) => degrees.reduce((product, n, k) => product * p[k][n], 1);
    return chaos.coefficients.reduce((sum, a, t) => sum + a * term(chaos.degrees[t]), 0);
}

const scalar = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);

/** L of L L' = K; K is a list of rows of which the lower half is read. */
function cholesky(K) {
    const L = K.map(() => new Float64Array(K.length));
    for (let j = 0; j < K.length; ++j)
        for (let i = j; i < K.length; ++i) {
            let s = K[i][j];
            for (let k = 0; k < j; ++k) s -= L[i][k] * L[j][k];
            L[i][j] = i === j ? Math.sqrt(s) : s / L[j][j];
        }
    return L;
}

/** x of L x = b. */
function forward(L, b) {
    const x = new Float64Array(b.length);
    for (let i = 0; i < b.length; ++i) {
        let s = b[i];
        for (let k = 0; k < i; ++k) s -= L[i][k] * x[k];
        x[i] = s / L[i][i];
    }
    return x;
}

/** Variance of the noise of a wall. */
const noiseAt = (process, c) => process.noise * Math.exp(process.noise_slopes ? scalar(process.noise_slopes, c) : 0);

/** A process that is ready to predict: at(c) -> {mean, variance}, the variance without noise. */
function conditioned(process) {
    const correlation = (a, b) => {
        let r2 = 0;
        for (let k = 0; k < a.length; ++k) r2 += ((a[k] - b[k]) / process.lengths[k]) ** 2;
        if (process.kernel === 'squared exponential') return Math.exp(-0.5 * r2);
        const s = Math.sqrt(5 * r2); // Matern 5/2
        return (1 + s + (s * s) / 3) * Math.exp(-s);
    };
    const { points, variance } = process;
    const L = cholesky(points.map((p, i) => points.slice(0, i + 1).map((q, j) => variance * correlation(p, q) + (i === j ? noiseAt(process, p) : 0))));
    const one = forward(L, points.map(() => 1));
    return (c) => {
        const k = points.map((p) => variance * correlation(p, c));
        const white = forward(L, k);
        const left = 1 - scalar(one, white);
        return { mean: process.constant + scalar(process.weights, k), variance: Math.max(0, variance - scalar(white, white) + (left * left) / scalar(one, one)) };
    };
}

const ready = new WeakMap();

/** Mean and doubt (standard deviation) of one wall by the better surrogate of a level, in its shown unit. families: of the inputs. */
export function predicted(level, families, c) {
    if (level.better === 'chaos') return { mean: chaosMean(level.chaos, families, c), sd: level.chaos.error.rmse };
    if (!ready.has(level)) ready.set(level, conditioned(level.process));
    const { mean, variance } = ready.get(level)(c);
    return { mean, sd: Math.sqrt(level.process.inflation * (variance + noiseAt(level.process, c))) };
}

/** Places of the inputs that lie beyond those of the walls learned from. */
export function outside(level, values) {
    const { least, most } = level.learned_between;
    return values.map((_, k) => k).filter((k) => {
        const room = 1e-9 * (most[k] - least[k]); // values were written to twelve digits
        return values[k] < least[k] - room || values[k] > most[k] + room;
    });
}

/** Probability of each mode with its standard error: of a multinomial logit, by the delta method. */
export function modeProbabilities(modes, c) {
    const x = [1, ...c];
    const eta = [0, ...modes.coefficients.map((row) => scalar(row, x))];
    const most = Math.max(...eta);
    const e = eta.map((v) => Math.exp(v - most));
    const sum = e.reduce((a, b) => a + b, 0);
    const p = e.map((v) => v / sum);
    return p.map((value, mode) => {
        const other = p.reduce((s, v, k) => s + (k === mode ? 0 : v), 0);
        const gradient = p.slice(1).flatMap((v, k) => x.map((xi) => (k + 1 === mode ? 1 : -v / other) * xi)); // of the logit
        const error = Math.sqrt(scalar(gradient, modes.covariance.map((row) => scalar(row, gradient))));
        return { value, sd: Number.isFinite(error) ? value * other * error : 0 };
    });
}
