#include "app/bad_input/cases.hpp"

#include <span>
#include <string>
#include <vector>

namespace bad_input {

namespace {

// clang-format off
const std::vector<BadCommand> kCommands = {
    {"no verb", {},
        "drystone: missing verb; write \"drystone push STUDY.ini\", or \"drystone help\""},
    {"unknown verb", {"pusg", "study.ini"},
        "drystone: pusg: unknown verb; did you mean \"push\"?"},
    {"unknown verb like no other", {"simulate", "study.ini"},
        "drystone: simulate: unknown verb; use push, scene, study, sample, reliability, fragility, report, curves, serve, merge, help or version"},
    {"missing study file", {"push"},
        "drystone: push: missing STUDY.ini; write \"drystone push configs/wall.ini\""},
    {"two study files", {"push", "study.ini", "other.ini"},
        "drystone: \"other.ini\": unexpected argument; leave it out"},
    {"unreadable path", {"push", "nowhere/study.ini"},
        "nowhere/study.ini: cannot be read (No such file or directory); give a study file, such as configs/wall.ini"},
    {"a directory", {"push", "."},
        ".: is a directory; give a study file, such as configs/wall.ini"},
    {"a device without end", {"push", "/dev/zero"},
        "/dev/zero: is larger than 1 MiB; this is not a study file"},
    {"unknown option", {"push", "study.ini", "--thread", "2"},
        "drystone: --thread: unknown option; did you mean \"--threads\"?"},
    {"unknown option like no other", {"push", "study.ini", "--colour=red"},
        "drystone: --colour: unknown option; use --out, --set, --threads, --quiet, --sample, --film, --level, --help or --version"},
    {"--out without value", {"push", "study.ini", "--out"},
        "drystone: --out: missing value; write one after it"},
    {"--out before another option", {"push", "study.ini", "--out", "--quiet"},
        "drystone: --out: missing value; write one after it"},
    {"--out with an empty value", {"push", "study.ini", "--out="},
        "drystone: --out: missing value; write one after it"},
    {"--out with an empty word", {"push", "study.ini", "--out", ""},
        "drystone: --out: missing value; write one after it"},
    {"--out that is a file", {"push", "study.ini", "--out", "study.ini"},
        "drystone: --out: \"study.ini\" is a file; give a directory"},
    {"--out under a file", {"push", "study.ini", "--out", "study.ini/runs/a"},
        "drystone: --out: \"study.ini\" is a file; give a directory"},
    {"--out that is the study file", {"study", "study.ini", "--out", "./study.ini"},
        "drystone: --out: \"./study.ini\" is the file that is read; write \"./study.h5\""},
    {"--out that would be another study", {"report", "a.h5", "--out", "b.h5"},
        "drystone: --out: \"b.h5\" is the name of a study's file; write \"b.html\""},
    {"--out that the tables need", {"study", "study.ini", "--report", "--out", "a"},
        "drystone: --out: \"a\" is the name of the tables' folder or of the page; write \"a.h5\""},
    {"--out that the page needs", {"study", "study.ini", "--report", "--out", "a.html"},
        "drystone: --out: \"a.html\" is the name of the tables' folder or of the page; write \"a.h5\""},
    {"--out twice", {"push", "study.ini", "--out", "a", "--out", "b"},
        "drystone: --out: given twice; keep one of them"},
    {"--quiet with a value", {"push", "study.ini", "--quiet=yes"},
        "drystone: --quiet: takes no value; write it alone"},
    {"no thread", {"push", "study.ini", "--threads", "0"},
        "drystone: --threads: \"0\" is out of range; must be in [1, 1024]"},
    {"half a thread", {"push", "study.ini", "--threads", "1.5"},
        "drystone: --threads: \"1.5\" is not a whole number; write one, such as \"10\""},
    {"--set without =", {"push", "study.ini", "--set", "wall.courses"},
        "--set: \"wall.courses\" is not an assignment; write section.key=value, such as joint.friction_angle=\"30 deg\""},
    {"--set without section", {"push", "study.ini", "--set", "courses=12"},
        "--set: \"courses=12\" is not an assignment; write section.key=value, such as joint.friction_angle=\"30 deg\""},
    {"--set of a key of two words", {"push", "study.ini", "--set", "wall.no of courses=9"},
        "--set: \"wall.no of courses=9\" is not an assignment; write section.key=value, such as joint.friction_angle=\"30 deg\""},
    {"--set of nothing", {"push", "study.ini", "--set", "wall.courses="},
        "--set: wall.courses: empty value; write one after the ="},
    {"--set of a key twice", {"push", "study.ini", "--set", "wall.courses=9", "--set", "wall.courses=8"},
        "--set: wall.courses: given twice; keep one of them"},
    {"--set of an unknown key", {"push", "study.ini", "--set", "wall.course=9"},
        "--set: wall.course: unknown key; did you mean \"wall.courses\"?"},
    {"--set of an unknown section", {"push", "study.ini", "--set", "walls.courses=9"},
        "--set: [walls]: unknown section; did you mean \"wall\"?"},
    {"--set without unit", {"push", "study.ini", "--set", "wall.thickness=0.3"},
        "--set: wall.thickness: missing unit; write \"0.3 m\""},
    {"--set at odds with the file", {"push", "study.ini", "--set", "load.vertical_stress=1 MPa"},
        "study.ini:12: joint.wall_modulus: has 2 values, load.vertical_stress 1; write one for each stress level"},
    {"--set that spans lines", {"push", "study.ini", "--set", "wall.bond=run\nning"},
        "--set: wall.bond: \"run?ning\" has a # or a line break, which a study file cannot keep in a value; leave it out"},
    {"--set with a comment", {"push", "study.ini", "--set", "fragility.user_states=no#1: 0.7 yield"},
        "--set: fragility.user_states: \"no#1: 0.7 yield\" has a # or a line break, which a study file cannot keep in a value; leave it out"},
    {"--out that is the folder of the study", {"push", "study.ini", "--out", "."},
        "drystone: --out: \".\" is the folder of the file that is read, which could be overwritten; give another folder"},
    {"--slurm of one shard", {"study", "study.ini", "--shard", "3/4", "--slurm", "job.sh"},
        "drystone: --shard: a job array runs every shard; write \"*/4\""},
    {"--shard */N without --slurm", {"study", "study.ini", "--shard", "*/4"},
        "drystone: --shard: \"*/4\" is for --slurm; write one shard, such as \"1/4\""},
    {"--slurm that is the study", {"study", "study.ini", "--slurm", "study.ini"},
        "drystone: --slurm: \"study.ini\" is the file that is read; give the script another name"},
    {"an option of another verb", {"push", "study.ini", "--group", "bond"},
        "drystone: --group: not an option of push; leave it out"},
};
// clang-format on

} // namespace

std::span<const BadCommand> bad_commands() { return kCommands; }

} // namespace bad_input
