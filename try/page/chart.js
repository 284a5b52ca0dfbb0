// Lines over two axes on a canvas.
import { cleared, colour } from './wall_picture.js';


/** About `count` round steps from 0 to beyond `most`. */
export function ticks(most, count) {
    const rough = (most || 1) / count;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 2.5, 5, 10].map((f) => f * power).find((s) => s >= rough * 0.999);
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9) + (step / power === 2.5 ? 1 : 0));
    return Array.from({ length: Math.ceil(most / step - 1e-9) + 1 }, (_, i) => ({ at: i * step, text: (i * step).toFixed(digits) }));
}

/**
 * @param chart {x: {title, most}, y: {title, most}, lines: [{x, y, colour, width?, dash?, alpha?}], bands: [{x, low, high, colour}],
 * levels: [{y, text}], dots: [{x, y, text, colour}]}
 * @return from pixels to numbers and back
 */
export function drawChart(canvas, chart) {
    const { pen, width, height } = cleared(canvas);
    const margin = { left: 46, right: 14, top: 16, bottom: 40 };
    const across = ticks(chart.x.most, width < 420 ? 4 : 6);
    const up = ticks(chart.y.most, 5);
    const most = { x: across.at(-1).at, y: up.at(-1).at };
    const px = (x) => margin.left + ((width - margin.left - margin.right) * x) / most.x;
    const py = (y) => height - margin.bottom - ((height - margin.top - margin.bottom) * y) / most.y;

    pen.font = '12px system-ui, sans-serif';
    pen.lineWidth = 1;
    pen.strokeStyle = colour('--grid');
    pen.fillStyle = colour('--soft');
    pen.textAlign = 'center';
    for (const { at, text } of across) {
        pen.beginPath();
        pen.moveTo(px(at), py(0));
        pen.lineTo(px(at), py(most.y));
        pen.stroke();
        pen.fillText(text, px(at), py(0) + 16);
    }
    pen.textAlign = 'right';
    for (const { at, text } of up) {
        pen.beginPath();
        pen.moveTo(px(0), py(at));
        pen.lineTo(px(most.x), py(at));
        pen.stroke();
        pen.fillText(text, px(0) - 6, py(at) + 4);
    }
    pen.textAlign = 'center';
    pen.fillText(chart.x.title, (px(0) + px(most.x)) / 2, height - 6);
    pen.save();
    pen.translate(12, (py(0) + py(most.y)) / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(chart.y.title, 0, 0);
    pen.restore();

    pen.save();
    pen.beginPath();
    pen.rect(px(0), margin.top - 8, width - margin.left - margin.right + 8, py(0) - margin.top + 9);
    pen.clip();
    for (const band of chart.bands ?? []) {
        pen.fillStyle = band.colour;
        pen.globalAlpha = 0.18;
        pen.beginPath();
        band.x.forEach((x, i) => pen.lineTo(px(x), py(band.high[i])));
        for (let i = band.x.length - 1; i >= 0; --i) pen.lineTo(px(band.x[i]), py(band.low[i]));
        pen.fill();
        pen.globalAlpha = 1;
    }
    for (const level of chart.levels ?? []) {
        if (!(level.y <= most.y)) continue;
        pen.strokeStyle = pen.fillStyle = colour('--soft');
        pen.setLineDash([5, 4]);
        pen.beginPath();
        pen.moveTo(px(0), py(level.y));
        pen.lineTo(px(most.x), py(level.y));
        pen.stroke();
        pen.setLineDash([]);
        pen.textAlign = 'left';
        pen.fillText(level.text, px(0) + 6, py(level.y) - 5);
    }
    pen.lineJoin = 'round';
    for (const line of chart.lines ?? []) {
        pen.strokeStyle = line.colour;
        pen.lineWidth = line.width ?? 2;
        pen.globalAlpha = line.alpha ?? 1;
        pen.setLineDash(line.dash ?? []);
        pen.beginPath();
        for (let i = 0; i < line.x.length; ++i) pen.lineTo(px(line.x[i]), py(line.y[i]));
        pen.stroke();
    }
    pen.setLineDash([]);
    pen.globalAlpha = 1;
    pen.restore();
    for (const dot of chart.dots ?? []) {
        pen.fillStyle = dot.colour;
        pen.strokeStyle = colour('--paper');
        pen.lineWidth = 2;
        pen.beginPath();
        pen.arc(px(dot.x), py(dot.y), 5, 0, 2 * Math.PI);
        pen.fill();
        pen.stroke();
        if (!dot.text) continue;
        pen.fillStyle = colour('--ink');
        pen.font = '600 12px system-ui, sans-serif';
        pen.textAlign = px(dot.x) > width * 0.7 ? 'right' : 'left';
        pen.fillText(dot.text, px(dot.x) + (px(dot.x) > width * 0.7 ? -9 : 9), py(dot.y) - 8);
        pen.font = '12px system-ui, sans-serif';
    }
    return { toX: (pixel) => ((pixel - px(0)) / (px(most.x) - px(0))) * most.x, px, py, most };
}
