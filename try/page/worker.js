// The worker computes beside the page, which ends it to stop a push.
import { openEngine } from './engine.js';

self.onmessage = async ({ data }) => {
    const tell = (kind, value, moved = []) => self.postMessage({ kind, value }, moved);
    const engine = await openEngine(data.module, {
        progress: (done, mm, kN) => tell('progress', { done, mm, kN }),
        begin: (scene) => tell('begin', scene),
        frame: (numbers, mm, kN) => tell('frame', { numbers, mm, kN }, [numbers.buffer]),
        again: () => tell('again'),
        wall: (wall) => tell('wall', wall),
    });
    const begin = performance.now();
    const result = data.job === 'push' ? engine.push(data.study, data.frames) : engine.walls(data.study, data.first, data.step);
    tell('done', { ...result, seconds: (performance.now() - begin) / 1e3, bytes: engine.bytes() });
};
