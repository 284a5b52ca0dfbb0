// Twenty walls that differ in all that the page offers, small enough to be pushed in a second.

/** Values of the controls of try/page/study.js that are not the usual ones. */
const kSmall = { 'wall.length': '0.80', 'wall.courses': '5', 'load.max_displacement': '8', 'solver.fidelity': 'simple' };
/** Other last digits move a peak by a part of the error that the solver is allowed. */
const kAccurate = 'solver.accuracy = 0.1 %';
const scene = (values) => ({ ...kSmall, ...values, more: [kAccurate, values.more ?? ''].join('\n') });

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
    scene({ 'wall.bond': 'flemish', 'unit.tensile_strength': '8' }),
    scene({ 'wall.base': 'joint' }),
    scene({ 'wall.base': 'joint', 'joint.friction_angle': '20', 'wall.length': '1.60' }),
    scene({ direction: 'left' }),
    scene({ 'beam.rotation': 'fixed' }),
    scene({ 'wall.unit_cracks': 'no' }),
    scene({ 'unit.tensile_strength': '6', 'unit.fracture_energy': '200', 'stone.young_modulus': '30' }),
    scene({ 'solver.kinematics': 'finite' }),
    scene({ 'solver.kinematics': 'finite', 'load.top': 'fixed_line', 'stone.density': '2700' }),
    scene({ more: 'joint.closure = exponential\njoint.initial_stiffness = 4.87 GPa/m\njoint.maximum_closure = 0.154 mm', 'joint.wall_modulus': '' }),
];

/** Walls whose stones crack before the peak: which stone cracks first may hang on last digits. */
export const kBrittle = [scene({ 'wall.bond': 'flemish' }), scene({ 'unit.tensile_strength': '1.0', 'load.vertical_stress': '1.00' })];
