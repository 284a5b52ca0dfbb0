#pragma once
/// The verbs of one wall, and those that every program has. Rows of the table in app/verbs.cpp,
/// and all rows of the program that the launcher builds first (app/first_verbs.cpp).

#include "app/commands.hpp"
#include "app/input/verb.hpp"

namespace app {

/// Writes the help of the program, or of the verb, key or word that is its first word, as wide
/// as the terminal.
int help_command(const Command& command);

/// Writes name, version, commit and revision of the solver.
int version_command(const Command& command);

inline constexpr Verb kPushVerb{.name = "push",
                                .words = "STUDY.ini",
                                .meaning = "push one wall: capacity curve, summary, pictures",
                                .example = "drystone push configs/wall.ini",
                                .sections = kWallSections,
                                .run = push_command};

inline constexpr Verb kSceneVerb{
    .name = "scene",
    .words = "STUDY.ini",
    .meaning = "draw the wall before anything is computed: units, joints, supports; .svg, "
               ".dxf, .json",
    .example = "drystone scene configs/wall.ini",
    .sections = "wall lintel stone joint unit beam base load solver",
    .run = scene_command};

inline constexpr Verb kNewVerb{
    .name = "new",
    .words = "NEW.ini",
    .meaning = "write a commented study of your own wall, from options or questions",
    .example =
        "drystone new house.ini --length \"3 m\" --height \"2.7 m\" --thickness \"0.5 m\" "
        "--material roughly_squared --unit \"0.6 x 0.3 m\" --stress \"0.20 MPa\"",
    .out = OutKind::first_word,
    .run = new_command};

inline constexpr Verb kHelpVerb{.name = "help",
                                .words = "[VERB|KEY|WORD]",
                                .meaning = "this text, the options and keys of a verb, or what "
                                           "a key or a word is about",
                                .example = "drystone help push",
                                .out = OutKind::none,
                                .least = 0,
                                .run = help_command};

inline constexpr Verb kVersionVerb{
    .name = "version",
    .meaning = "version and commit of the program, revision of its solver",
    .example = "drystone version",
    .out = OutKind::none,
    .least = 0,
    .most = 0,
    .run = version_command};

} // namespace app
