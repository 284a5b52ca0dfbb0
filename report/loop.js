// Force against displacement of one wall that is pushed to and fro.
import { element } from './format.js';
import { chart, overlay } from './chart.js';

export class Loop {
    /** loops: as readLoops gives them. */
    constructor(data, loops, host) {
        Object.assign(this, { data, loops, wall: null, at: null });
        this.title = element('h3', {}, '');
        this.plot = element('div', { class: 'plot' });
        host.append(this.title, this.plot);
    }

    /** A chart as large as the loops of this wall. */
    drawChart() {
        this.drawn?.remove();
        const { x, f } = this.loops.path(this.wall);
        const room = 1.08;
        const reach = (values) => room * values.reduce((most, v) => Math.max(most, Math.abs(v)), 1e-3);
        const [wide, high] = [reach(x), reach(f)];
        this.drawn = chart(this.plot, {
            label: 'Hysteresis of the wall shown', series: [{ data: [0, 0], colour: '#999999', width: 1 }], x: [-wide, wide], height: 320,
            xLabel: 'displacement [mm]', yLabel: 'horizontal force [kN]', xRange: [-wide, wide], yRange: [-high, high],
            draw: () => this.refresh(),
        });
        this.parts = overlay(this.drawn.u);
        this.parts.hovered.style.stroke = '#b8b8b8';
        this.parts.hovered.style.strokeWidth = 1;
        this.parts.chosen.style.strokeDasharray = 'none';
        this.parts.hovered.parentNode.prepend(this.parts.hovered); // what is to come, below what has been
    }

    /** The wall that is shown, at frame t of its film; null: the page has no film of it. */
    mark(wall, t) {
        const other = wall !== this.wall;
        Object.assign(this, { wall, at: t });
        if (other) {
            this.title.textContent = `Hysteresis: ${this.data.levels[this.data.walls[wall].level].name}, sample ${this.data.walls[wall].sample}`;
            this.drawChart();
        }
        this.refresh();
    }

    /** Line through the points from 0 to the place `to`. */
    line(u, to) {
        const points = [];
        const { x, f } = this.loops.path(this.wall);
        for (let i = 0; i < Math.min(to, f.length); ++i) points.push(`${u.valToPos(x[i], 'x').toFixed(1)},${u.valToPos(f[i], 'y').toFixed(1)}`);
        return points.join(' ');
    }

    refresh() {
        if (!this.drawn || !this.parts || this.wall === null) return;
        const { u } = this.drawn;
        if (!Number.isFinite(u.valToPos(0, 'x'))) return; // a new chart: it calls again when it is drawn
        const here = this.at === null ? null : this.loops.at(this.wall, this.at);
        this.parts.hovered.setAttribute('points', this.line(u, Infinity));
        this.parts.chosen.setAttribute('points', here ? this.line(u, here.place + 1) : '');
        this.parts.dot.setAttribute('visibility', here ? 'visible' : 'hidden');
        if (!here) return;
        this.parts.dot.setAttribute('cx', u.valToPos(here.x, 'x'));
        this.parts.dot.setAttribute('cy', u.valToPos(here.f, 'y'));
    }
}
