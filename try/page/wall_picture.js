// The wall, as it stands or moves, on a canvas.

export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** A canvas as sharp as the screen; its pen in pixels of the page. */
export function cleared(canvas) {
    const { width, height } = canvas.getBoundingClientRect();
    const dense = Math.min(window.devicePixelRatio || 1, 3);
    const [w, h] = [Math.round(width * dense), Math.round(height * dense)];
    if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
    const pen = canvas.getContext('2d');
    pen.setTransform(dense, 0, 0, dense, 0, 0);
    pen.clearRect(0, 0, width, height);
    return { pen, width, height };
}

/** Box of a scene [m], with room for what moves. */
function box(scene, farthest) {
    let [x0, x1, z1] = [Infinity, -Infinity, 0];
    for (const block of scene.blocks)
        for (let i = 0; i < block.outline.length; i += 2) {
            x0 = Math.min(x0, block.outline[i]);
            x1 = Math.max(x1, block.outline[i]);
            z1 = Math.max(z1, block.outline[i + 1]);
        }
    return { x0: x0 - farthest, x1: x1 + farthest, z1: z1 + 0.1 * farthest };
}

function path(pen, points) {
    pen.beginPath();
    for (let i = 0; i < points.length; i += 2) pen.lineTo(points[i], points[i + 1]);
    pen.closePath();
}

function arrow(pen, x0, y0, x1, y1) {
    const angle = Math.atan2(y1 - y0, x1 - x0);
    const head = 8;
    pen.beginPath();
    pen.moveTo(x0, y0);
    pen.lineTo(x1 - head * Math.cos(angle), y1 - head * Math.sin(angle));
    pen.stroke();
    pen.beginPath();
    pen.moveTo(x1, y1);
    for (const side of [-0.45, 0.45]) pen.lineTo(x1 - head * Math.cos(angle + side), y1 - head * Math.sin(angle + side));
    pen.closePath();
    pen.fill();
}

/** A joint is drawn as open, or as slipping, from here on [m]. */
const kSeen = 2e-4;
const kCracked = 0.999;

/**
 * @param look {blocks, faces?, cracks?}: of the page's `look` or of a push
 * @param frame {numbers, mm, kN} of a push, or null
 * @param view {scale, farthest, direction, stress}: how much displacements are enlarged; the room that they take [m]
 */
export function drawWall(canvas, look, frame, view) {
    const { pen, width, height } = cleared(canvas);
    const room = box(look, (view.farthest ?? 0) * view.scale);
    const margin = { left: 44, right: 44, top: 46, bottom: 26 };
    const pixels = Math.min((width - margin.left - margin.right) / (room.x1 - room.x0), (height - margin.top - margin.bottom) / room.z1);
    const left = margin.left + (width - margin.left - margin.right - pixels * (room.x1 - room.x0)) / 2;
    const ground = height - margin.bottom;
    const px = (x) => left + pixels * (x - room.x0);
    const py = (z) => ground - pixels * z;

    pen.strokeStyle = colour('--ghost');
    pen.lineWidth = 1;
    if (frame)
        for (const block of look.blocks) {
            path(pen, block.outline.map((v, i) => (i % 2 ? py(v) : px(v))));
            pen.stroke();
        }

    const tints = [colour('--stone-a'), colour('--stone-b'), colour('--stone-c')];
    const placed = [];
    let at = 0;
    for (const block of look.blocks) {
        const points = new Array(block.outline.length);
        for (let i = 0; i < points.length; ++i) {
            const moved = block.outline[i] + (frame ? view.scale * frame.numbers[at + i] : 0);
            points[i] = i % 2 ? py(moved) : px(moved);
        }
        at += block.outline.length;
        placed.push(points);
        path(pen, points);
        pen.fillStyle = block.unit === 0 ? colour('--beam') : tints[(block.unit * 7 + block.course * 3) % 3];
        pen.fill();
        pen.strokeStyle = colour('--joint');
        pen.lineWidth = 0.8;
        pen.stroke();
    }
    pen.lineCap = 'round';
    if (frame) {
        const line = (face, name, wide) => {
            const points = placed[face.block];
            pen.strokeStyle = colour(name);
            pen.lineWidth = wide;
            pen.beginPath();
            for (const i of face.at) pen.lineTo(points[2 * i], points[2 * i + 1]);
            pen.stroke();
        };
        look.faces.forEach((face, i) => {
            const [damage, opening, slip] = frame.numbers.subarray(at + 3 * i, at + 3 * i + 3);
            if (face.crack) damage >= kCracked ? line(face, '--crack', 3) : damage > 0.02 && line(face, '--crack', 1);
            else if (opening > kSeen) line(face, '--open', 2.4);
            else if (slip > kSeen) line(face, '--slip', 2.4);
        });
    } else {
        pen.strokeStyle = colour('--ghost');
        pen.setLineDash([3, 3]);
        for (const [x0, z0, x1, z1] of look.cracks) {
            pen.beginPath();
            pen.moveTo(px(x0), py(z0));
            pen.lineTo(px(x1), py(z1));
            pen.stroke();
        }
        pen.setLineDash([]);
    }

    pen.strokeStyle = pen.fillStyle = colour('--soft');
    pen.lineWidth = 2;
    pen.beginPath();
    pen.moveTo(px(room.x0) - 20, ground + 1);
    pen.lineTo(px(room.x1) + 20, ground + 1);
    pen.stroke();

    const top = placed.at(-1);
    const xs = top.filter((_, i) => i % 2 === 0);
    const ys = top.filter((_, i) => i % 2 === 1);
    const [x0, x1, y0] = [Math.min(...xs), Math.max(...xs), Math.min(...ys)];
    pen.strokeStyle = pen.fillStyle = colour('--soft');
    pen.lineWidth = 1.4;
    for (let i = 0; i < 5; ++i) {
        const x = x0 + ((i + 0.5) / 5) * (x1 - x0);
        arrow(pen, x, y0 - 24, x, y0 - 3);
    }
    pen.font = '12px system-ui, sans-serif';
    pen.textAlign = 'center';
    pen.fillText(view.load ?? '', (x0 + x1) / 2, y0 - 30);
    pen.strokeStyle = pen.fillStyle = colour('--accent');
    pen.lineWidth = 3;
    const y = (y0 + Math.max(...ys)) / 2;
    view.direction < 0 ? arrow(pen, x1 + 38, y, x1 + 4, y) : arrow(pen, x0 - 38, y, x0 - 4, y);
}
