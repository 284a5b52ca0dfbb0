// node test_search.mjs CHROMIUM SITE   opens a site from its folder: the search finds a key, the page that pushes a wall stands in its frame.
import assert from 'node:assert/strict';
import { resolve } from 'node:path';
import { openPage } from '../report/browser.mjs';

const [program, place] = process.argv.slice(2);
const site = resolve(place);
const page = await openPage(program, { width: 1440 });
try {
    await page.send('Page.navigate', { url: `file://${site}/docs/theory.html` });
    await page.until(`document.readyState === 'complete' && document.querySelector('.md-search__input') !== null`);
    // The script of the theme may not listen yet: the box is left and the word is typed again until something is found.
    const typed = (word) => `{ const box = document.querySelector('.md-search__input'); box.blur(); box.focus(); box.value = '${word}'; for (const kind of ['keyup', 'input']) box.dispatchEvent(new Event(kind)); }`;
    const some = `document.querySelectorAll('.md-search-result__item').length > 0`;
    for (let again = 0; again < 20 && !(await page.evaluate(some)); ++again) {
        await page.evaluate(typed('friction'));
        await page.evaluate(typed('friction_angle'));
        await page.until(some, 5).catch(() => {});
    }
    await page.until(some, 5);
    const found = await page.evaluate(`[...document.querySelectorAll('.md-search-result__link')].map((a) => a.href)`);
    assert.ok(found.some((url) => url.includes('/docs/keys.html')), found.join('\n'));
    await page.send('Page.navigate', { url: `file://${site}/try.html` });
    await page.until(`document.querySelector('iframe.try')?.src.endsWith('/try/index.html')`);
    const outside = page.requests().filter((url) => !/^(file|blob|data):/.test(url));
    assert.deepEqual(outside, [], 'asked of the network');
    assert.deepEqual(page.problems(), [], 'errors and warnings of the console');
} finally {
    await page.close();
}
