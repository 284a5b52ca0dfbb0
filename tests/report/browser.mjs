// Chromium through its DevTools protocol, over the two pipes it opens for that: nothing but node is needed.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** A page in a browser of its own; close() ends it. `requests`, `problems`: what it asked the network for and complained of. */
export async function openPage(program, { width = 1280, height = 900, mobile = false, reducedMotion = false } = {}) {
    const profile = mkdtempSync(join(tmpdir(), 'drystone-page-'));
    const flags = ['--headless=new', '--remote-debugging-pipe', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run', '--disable-background-networking', '--disable-component-update', `--user-data-dir=${profile}`];
    const browser = spawn(program, [...flags, 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    const ended = new Promise((done) => browser.once('exit', done));
    const waiting = new Map();
    const events = [];
    let number = 0;
    let rest = '';
    browser.stdio[4].setEncoding('utf8').on('data', (text) => {
        const parts = (rest + text).split('\0');
        rest = parts.pop();
        for (const part of parts) receive(JSON.parse(part));
    });
    function receive(message) {
        if (message.id === undefined) return void events.push(message);
        const { done, failed } = waiting.get(message.id);
        waiting.delete(message.id);
        message.error ? failed(new Error(message.error.message)) : done(message.result);
    }
    const raw = (method, params = {}, sessionId = undefined) =>
        new Promise((done, failed) => {
            waiting.set(++number, { done, failed });
            browser.stdio[3].write(JSON.stringify({ id: number, method, params, sessionId }) + '\0');
        });
    const { targetId } = await raw('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await raw('Target.attachToTarget', { targetId, flatten: true });
    const send = (method, params) => raw(method, params, sessionId);
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await send(`${domain}.enable`);
    await send('Performance.enable', { timeDomain: 'threadTicks' });
    await send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: mobile ? 2 : 1, mobile });
    if (mobile) await send('Emulation.setTouchEmulationEnabled', { enabled: true });
    if (reducedMotion) await send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });

    const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
    const page = {
        send,
        sleep,
        requests: () => events.filter((e) => e.method === 'Network.requestWillBeSent').map((e) => e.params.request.url),
        problems: () =>
            events.flatMap((e) => {
                if (e.method === 'Runtime.exceptionThrown') return [e.params.exceptionDetails.exception?.description ?? e.params.exceptionDetails.text];
                if (e.method === 'Log.entryAdded' && e.params.entry.level !== 'verbose') return [e.params.entry.text];
                if (e.method === 'Runtime.consoleAPICalled' && e.params.type !== 'debug') return [`console.${e.params.type}`];
                return [];
            }),
        async evaluate(expression) {
            const { result, exceptionDetails } = await send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true, userGesture: true });
            if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
            return result.value;
        },
        async until(expression, seconds = 30) {
            for (const end = Date.now() + 1e3 * seconds; Date.now() < end; await sleep(50)) if (await page.evaluate(expression)) return;
            throw new Error(`not within ${seconds} s: ${expression}`);
        },
        /** After the next picture. */
        drawn: () => page.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))'),
        async open(file) {
            const begin = Date.now();
            await send('Page.navigate', { url: `file://${file}` });
            await page.until(`document.documentElement?.dataset.ready === 'yes' || document.querySelector('[role=alert]') !== null`);
            return (Date.now() - begin) / 1e3;
        },
        /** Processor seconds that the page's own thread has worked, whatever else the machine does. */
        async worked() {
            const { metrics } = await send('Performance.getMetrics');
            return metrics.find((m) => m.name === 'TaskDuration').value;
        },
        /** Of the browser: {type, id, cpuTime} each, seconds of processor since it began. */
        processes: async () => (await raw('SystemInfo.getProcessInfo')).processInfo,
        async click(x, y) {
            for (const type of ['mouseMoved', 'mousePressed', 'mouseReleased']) await send('Input.dispatchMouseEvent', { type, x, y, button: type === 'mouseMoved' ? 'none' : 'left', clickCount: type === 'mouseMoved' ? 0 : 1 });
        },
        move: (x, y) => send('Input.dispatchMouseEvent', { type: 'mouseMoved', x, y }),
        async press(key) {
            for (const type of ['keyDown', 'keyUp']) await send('Input.dispatchKeyEvent', { type, key, code: key, windowsVirtualKeyCode: { Enter: 13, ArrowRight: 39, ArrowLeft: 37, Tab: 9 }[key] });
        },
        async screenshot(selector = null) {
            const clip = selector && (await page.evaluate(`(() => { const b = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return { x: b.x + scrollX, y: b.y + scrollY, width: b.width, height: b.height, scale: 1 }; })()`));
            const { data } = await send('Page.captureScreenshot', { format: 'png', captureBeyondViewport: true, ...(clip ? { clip } : {}) });
            return Buffer.from(data, 'base64');
        },
        async pdf() {
            const { data } = await send('Page.printToPDF', { printBackground: true, preferCSSPageSize: true });
            return Buffer.from(data, 'base64');
        },
        async close() {
            const late = setTimeout(() => browser.kill('SIGKILL'), 5000);
            raw('Browser.close').catch(() => {});
            await ended;
            clearTimeout(late);
            try {
                rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
            } catch {
                // its helpers may write for a moment after it has ended
            }
        },
    };
    return page;
}
