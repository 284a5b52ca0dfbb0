#pragma once
/// The verbs that need nothing but their command. Each returns the exit code, 0 where nothing
/// else is said, and throws ConfigError for bad input, before anything is written, StoreError
/// for a file of a study that cannot be used, and std::runtime_error for what the machine
/// refuses.

#include "app/input/command.hpp"

namespace app {

/// `drystone scene`: the wall that a study describes, before anything is computed. Writes
/// scene.svg, laws.svg (law_picture.hpp), scene.json, scene.dxf and joints.csv, which says
/// where each joint and crack is, and says what the wall is. scene.json and scene.dxf hold
/// whole units in the unit of wall.length_unit, and are read again with wall.geometry.
[[nodiscard]] int scene_command(const Command& command);

/// `drystone new`: a commented study of one's own wall, from options or, on a terminal,
/// questions; and its scene. Replaces no file.
[[nodiscard]] int new_command(const Command& command);

/// `drystone stones`: the stones of a photograph. Writes stones.png, which wall.geometry reads,
/// and found.png, the photograph with what was found.
[[nodiscard]] int stones_command(const Command& command);

/// `drystone status`: what a file of results holds, how far it is, and when it was added to.
/// Takes no lock.
[[nodiscard]] int status_command(const Command& command);

/// `drystone push`: every stress level of a study file, one wall each. Writes, into command.out
/// or a folder per stress level below it: capacity.csv, capacity.svg, summary.json, wall.svg,
/// study.ini (the effective configuration) and series/*.pvd for ParaView, which are written
/// while the wall is pushed. Several levels also give levels.csv, .md, .tex, .svg. Files of an
/// earlier push are removed. Told to end, it writes the curves so far as
/// capacity_interrupted.csv and leaves all other files as they were; where only the push the
/// other way was left, it writes everything.
/// @return 1 if a wall's numbers broke
/// @throws Interrupted (app/study/pushed/interrupt.hpp)
[[nodiscard]] int push_command(const Command& command);

/// `drystone calibrate`: the error of the model from a table of tests, over the medians of the
/// study's walls under the same stresses. Walls of a study file are pushed into walls.h5 of the
/// folder, or resumed there; a file of results is read. Writes model_factor.ini, the lines to
/// put into the study, and calibration.csv, .md and .tex.
/// @return 1 where there are too few tests for a factor of either kind
/// @throws Interrupted (app/study/pushed/interrupt.hpp)
[[nodiscard]] int calibrate_command(const Command& command);

/// `drystone sample`: the samples of a study as a table, without running a wall.
[[nodiscard]] int sample_command(const Command& command);

/// `drystone curves`: all capacity curves of a study as one CSV. Columns level,
/// vertical_stress_MPa, sample, displacement_mm, force_kN; one line per point, wall by wall.
[[nodiscard]] int curves_command(const Command& command);

/// `drystone merge`: shards of one study into one file.
/// @return 0: no wall failed, and all are there or --partial was asked for; 1: some failed
[[nodiscard]] int merge_command(const Command& command);

/// `drystone reliability`: the probability of an event, with its doubt and what it depends on.
/// @return 0: an answer; 1: none
[[nodiscard]] int reliability_command(const Command& command);

/// `drystone record`: what records of strong motion and pulses say, and their measures of
/// intensity. Writes records.csv, .md and .tex, spectra.csv and .svg, and for each motion its
/// history as .csv and .svg in motions/.
[[nodiscard]] int record_command(const Command& command);

/// `drystone shake`: one wall on ground that moves, under each record and intensity of
/// [shaking]. Writes history.csv, history.svg, summary.json, wall.svg and study.ini, in a
/// folder for each history where there are several.
/// @return 1 if the numbers of a wall broke
[[nodiscard]] int shake_command(const Command& command);

/// `drystone surrogate`: a Gaussian process and a polynomial chaos of one response of a stored
/// study, with their errors and what the response depends on. Writes, into command.out,
/// surrogate.json, tables and a picture of each stress.
[[nodiscard]] int surrogate_command(const Command& command);

/// `drystone serve`: the walls of a study over HTTP, for any program that speaks UM-Bridge,
/// until it is told to end (Ctrl-C, SIGTERM).
[[nodiscard]] int serve_command(const Command& command);

} // namespace app
