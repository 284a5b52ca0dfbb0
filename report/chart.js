// Charts: uPlot with the axes, keys and tips of this page.
import { element, figures, dashes } from './format.js';

const charts = new Set();

/** Swatch of a line, a band or a point. */
function swatch(series) {
    const svg = element('svg', { width: 28, height: 12, 'aria-hidden': 'true' });
    if (series.band) svg.append(element('rect', { x: 0, y: 1, width: 28, height: 10, fill: series.colour, opacity: series.faint ? 0.12 : 0.22 }));
    const dash = (series.dash ?? []).join(' ');
    if (series.points) svg.append(element('circle', { cx: 14, cy: 6, r: 4, fill: series.colour }));
    else svg.append(element('line', { x1: 0, x2: 28, y1: 6, y2: 6, stroke: series.colour, 'stroke-width': series.width ?? 2, 'stroke-dasharray': dash }));
    return svg;
}

export function key(series) {
    return element('ul', { class: 'key' }, ...series.filter((s) => s.label).map((s) => element('li', {}, swatch(s), s.label)));
}

function axes(options) {
    const axis = (label, size) => ({
        label,
        labelSize: 22,
        size,
        font: '12px system-ui, sans-serif',
        labelFont: '13px system-ui, sans-serif',
        stroke: '#222',
        grid: { stroke: '#e6e6e6', width: 1 },
        ticks: { stroke: '#bbb', width: 1, size: 5 },
        values: (u, ticks) => ticks.map(figures),
        ...(options.wholeX && label === options.xLabel ? { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] } : {}),
    });
    return [{ ...axis(options.xLabel, 36), space: 55 }, { ...axis(options.yLabel, 52), space: 32 }];
}

/** Lines of a series, and the two invisible ones that a band lies between. */
function layers(options) {
    const series = [{}];
    const data = [options.x];
    const bands = [];
    const add = (s, values) => (series.push(s), data.push(values), series.length - 1);
    for (const s of options.series) {
        if (s.band) {
            const hidden = { stroke: 'transparent', width: 0, points: { show: false } };
            const lower = add(hidden, s.band[0]);
            const upper = add(hidden, s.band[1]);
            bands.push({ series: [upper, lower], fill: `${s.colour}${s.faint ? '1c' : '33'}` });
        }
        if (!s.data) continue;
        if (s.halo) add({ stroke: '#fff', width: s.width + 3, points: { show: false } }, s.data);
        add(
            {
                label: s.label ?? '',
                stroke: s.colour,
                width: s.points ? 0 : (s.width ?? 2),
                dash: s.dash,
                alpha: s.alpha ?? 1,
                fill: s.fill,
                paths: s.points ? () => null : undefined,
                spanGaps: s.spanGaps ?? false,
                points: s.points ? { show: true, size: 9, fill: s.colour, stroke: s.colour } : { show: false },
            },
            s.data,
        );
    }
    return { series, data, bands };
}

function widthOf(host) {
    return Math.max(240, Math.floor(host.clientWidth));
}

/**
 * options: label (for those who cannot see it), x, series [{label, data, colour, width, dash, alpha, band: [lower, upper],
 * points, fill, halo}], xLabel, yLabel, xRange, yRange, height, tip(index) -> text, draw(u)
 */
export function chart(host, options) {
    const { series, data, bands } = layers(options);
    const range = (given) => (given ? { range: () => given } : {});
    const tip = element('div', { class: 'tip', hidden: true });
    const u = new uPlot(
        {
            width: widthOf(host),
            height: options.height ?? 320,
            series,
            bands,
            scales: { x: { time: false, ...range(options.xRange) }, y: range(options.yRange) },
            axes: axes(options),
            legend: { show: false },
            pxAlign: false,
            cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
            hooks: {
                draw: options.draw ? [options.draw] : [],
                setCursor: options.tip ? [(c) => showTip(c, tip, options.tip)] : [],
            },
        },
        data,
        host,
    );
    u.over.append(tip);
    u.over.addEventListener('mouseleave', () => (tip.hidden = true));
    u.root.setAttribute('role', 'img');
    u.root.setAttribute('aria-label', options.label);
    const entry = { u, host, height: options.height ?? 320 };
    charts.add(entry);
    watcher.observe(host);
    return { u, remove: () => (charts.delete(entry), watcher.unobserve(host), u.destroy()) };
}

/** Lines over a chart: the wall under the cursor and the one chosen, with its place on the way. */
export function overlay(u) {
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('class', 'overlay');
    svg.setAttribute('aria-hidden', 'true');
    const line = (c) => svg.appendChild(element('polyline', { class: c, fill: 'none' }));
    const parts = { chosen: line('chosen'), hovered: line('hovered'), dot: svg.appendChild(element('circle', { r: 6, class: 'dot', visibility: 'hidden' })) };
    u.over.append(svg);
    return parts;
}

function showTip(u, tip, text) {
    const { left, idx } = u.cursor;
    if (left === null || left < 0 || idx === null) return void (tip.hidden = true);
    placeTip(u, tip, text(idx), left, u.cursor.top);
}

/** Text beside a point of the plot, inside it. */
export function placeTip(u, tip, text, left, top) {
    tip.hidden = text === '';
    tip.textContent = text;
    const right = left > u.over.clientWidth / 2;
    tip.style.left = right ? 'auto' : `${left + 12}px`;
    tip.style.right = right ? `${u.over.clientWidth - left + 12}px` : 'auto';
    tip.style.top = `${Math.max(0, Math.min(top, u.over.clientHeight - tip.offsetHeight))}px`;
}

function resize(width) {
    for (const c of charts) {
        const w = width ?? widthOf(c.host);
        if (w > 0 && Math.abs(w - c.u.width) > 1) c.u.setSize({ width: w, height: c.height });
    }
}

const watcher = new ResizeObserver(() => resize());
addEventListener('beforeprint', () => {
    for (const c of charts) c.u.setSize({ width: Math.min(c.u.width, c.host.closest('.small') ? 300 : 640), height: c.height });
});
addEventListener('afterprint', () => resize());

/** Vertical bars from lower to upper with ends, for points with intervals. */
export function drawIntervals(u, items, colour) {
    const { ctx } = u;
    ctx.save();
    ctx.strokeStyle = colour;
    ctx.lineWidth = 1.5 * devicePixelRatio;
    for (const { x, lower, upper } of items) {
        const at = u.valToPos(x, 'x', true);
        const [low, high] = [u.valToPos(lower, 'y', true), u.valToPos(upper, 'y', true)];
        const cap = 5 * devicePixelRatio;
        ctx.beginPath();
        ctx.moveTo(at, low);
        ctx.lineTo(at, high);
        for (const end of [low, high]) {
            ctx.moveTo(at - cap, end);
            ctx.lineTo(at + cap, end);
        }
        ctx.stroke();
    }
    ctx.restore();
}

export const dashOf = (i) => dashes[i % dashes.length];
