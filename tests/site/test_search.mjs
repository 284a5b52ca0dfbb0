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
    // Whoever types while the page still opens finds the same.
    const typed = (word) => `{ const box = document.querySelector('.md-search__input'); box.focus(); box.value = '${word}'; for (const kind of ['keyup', 'input']) box.dispatchEvent(new Event(kind)); }`;
    for (const word of ['friction', 'friction_angle']) await page.evaluate(typed(word));
    await page.until(`[...document.querySelectorAll('.md-search-result__link')].some((a) => a.href.includes('/docs/keys.html'))`);
    await page.send('Page.navigate', { url: `file://${site}/try.html` });
    await page.until(`document.querySelector('iframe.try')?.src.endsWith('/try/index.html')`);
    const outside = page.requests().filter((url) => !/^(file|blob|data):/.test(url));
    assert.deepEqual(outside, [], 'asked of the network');
    assert.deepEqual(page.problems(), [], 'errors and warnings of the console');
} finally {
    await page.close();
}
