// Twenty walls that differ in all that the page offers, small enough to be pushed in a second.

/** Values of the controls of try/page/study.js that are not the usual ones. */
const kSmall = { 'wall.length': '0.80', 'wall.courses': '5', 'load.max_displacement': '8', 'solver.fidelity': 'simple' };
const scene = (values) => ({ ...kSmall, ...values });

export const kScenes = [
    scene({}),
    scene({ 'load.vertical_stress': '0.15', 'joint.wall_modulus': '558' }),
    scene({ 'load.vertical_stress': '1.25', 'joint.wall_modulus': '1202' }),
    scene({ 'wall.length': '1.60' }),
    scene({ 'wall.length': '0.50', 'wall.unit_length': '0.25' }),
    scene({ 'wall.courses': '8' }),
    scene({ 'wall.course_height': '0.15', 'wall.unit_length': '0.40' }),
    scene({ 'wall.thickness': '0.40' }),
    scene({ 'wall.bond': 'stack' }),
    scene({ 'wall.bond': 'english' }),
    scene({ 'wall.bond': 'flemish' }),
    scene({ 'wall.base': 'joint' }),
    scene({ 'wall.base': 'joint', 'joint.friction_angle': '20', 'wall.length': '1.60' }),
    scene({ direction: 'left' }),
    scene({ 'beam.rotation': 'fixed' }),
    scene({ 'wall.unit_cracks': 'no' }),
    scene({ 'unit.tensile_strength': '1.0', 'load.vertical_stress': '1.00' }),
    scene({ 'solver.kinematics': 'finite' }),
    scene({ 'solver.kinematics': 'finite', 'load.top': 'fixed_line', 'stone.density': '2700' }),
    scene({ more: 'joint.closure = exponential\njoint.initial_stiffness = 4.87 GPa/m\njoint.maximum_closure = 0.154 mm', 'joint.wall_modulus': '' }),
];
