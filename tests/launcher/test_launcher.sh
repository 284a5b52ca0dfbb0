#!/usr/bin/env bash
# test_launcher.sh ROOT CLAIM   checks one claim about the launcher ROOT/drystone
# Each function claim_* is one test (CMakeLists.txt lists them), in a stub checkout.
set -euo pipefail

# shellcheck source=tests/launcher/stub_checkout.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/stub_checkout.sh"

claim_arguments_arrive_exactly_as_given() {
    cd -- "$checkout" # where * would match
    drystone show "two words" '*' '' '$HOME' "it's" 'a"b' -- --flag $'line\nbreak'
    expect_equal "the argument list" "$(cat "$box/out")" \
        "$(printf '<%s>\n' "two words" '*' '' '$HOME' "it's" 'a"b' -- --flag $'line\nbreak')"
}

claim_the_exit_code_is_the_programs() {
    local wanted
    for wanted in 0 1 2 42; do
        drystone exit "$wanted"
        expect_equal "the exit code" "$code" "$wanted"
    done
}

claim_the_working_directory_stays() {
    mkdir "$box/else where"
    cd -- "$box/else where"
    drystone where
    expect_equal "the working directory" "$(cat "$box/out")" "$box/else where"
}

claim_stdout_and_stdin_belong_to_the_program() {
    echo catch2 >"$box/absent"
    drystone show first
    expect_equal "stdout of the run that installs and builds" "$(cat "$box/out")" "<first>"
    expect_text "$box/err" "building Drystone (first time, about "
    drystone show second
    expect_equal "stdout of the next run" "$(cat "$box/out")" "<second>"
    expect_equal "stderr of the next run" "$(cat "$box/err")" ""
    rm -r -- "$checkout/build"
    expect_equal "stdin through the first build" \
        "$(echo data | env -i PATH="$tools" BOX="$box" "$checkout/drystone" read)" data
}

claim_the_program_takes_the_launchers_place() {
    drystone exit 0
    env -i PATH="$tools" BOX="$box" "$checkout/drystone" pid >"$box/out" &
    wait $!
    expect_equal "the process" "$(cat "$box/out")" "$!"
}

claim_it_works_through_a_symlink() {
    ln -s "$checkout/drystone" "$box/link to drystone"
    ln -s "link to drystone" "$box/link"
    launcher="$box/link"
    drystone show yes
    expect_equal "stdout" "$(cat "$box/out")" "<yes>"
}

claim_a_changed_source_is_built_before_the_run() {
    drystone exit 0
    echo 'echo "version 2"' >>"$checkout/app/program.sh"
    drystone
    expect_equal "stdout" "$(cat "$box/out")" "version 2"
    expect_text "$box/err" "building what changed"
    drystone
    expect_equal "the number of builds" "$(grep -c building "$box/calls")" 2
}

claim_a_first_push_builds_what_pushes_one_wall() {
    drystone push wall.ini
    expect_equal "the first program" "$(cat "$box/out")" drystone-wall
    expect_text "$box/err" "building the part of Drystone that pushes a wall"
    expect_no_text "$box/calls" building
    drystone show all
    expect_equal "stdout of another verb" "$(cat "$box/out")" "<all>"
    expect_text "$box/err" "building Drystone (first time, about "
    drystone push wall.ini
    expect_equal "the program from there on" "$(cat "$box/out")" drystone
    expect_equal "stderr then" "$(cat "$box/err")" ""
}

claim_a_first_push_of_a_wall_of_a_study_builds_the_whole_program() {
    drystone push study.ini --sample 3
    expect_equal "of a sample" "$(cat "$box/out")" drystone
    rm -rf "$checkout/build"
    drystone push runs/study.h5
    expect_equal "of a file of results" "$(cat "$box/out")" drystone
    rm -rf "$checkout/build"
    drystone push study.ini --sample mean
    expect_equal "of the means" "$(cat "$box/out")" drystone-wall
}

claim_a_failed_build_shows_its_output_and_runs_nothing() {
    drystone show old
    touch "$checkout/app/program.sh" "$box/broken"
    drystone show old
    expect_equal "the exit code" "$code" 1
    expect_equal "stdout" "$(cat "$box/out")" ""
    expect_text "$box/err" "FAILED: app/drystone"
    expect_text "$box/err" "drystone: the build failed"
    rm "$box/broken"
    drystone show new
    expect_equal "stdout once repaired" "$(cat "$box/out")" "<new>"
}

claim_changed_presets_are_configured_again() {
    drystone exit 0
    write_presets '"STUB_TEST": "exit 77"'
    drystone test
    expect_equal "the last line" "$(tail -n 1 "$box/out")" "2 passed, 0 failed, 1 skipped"
}

claim_packages_that_come_later_are_configured_once_and_compile_nothing_again() {
    printf '%s\n' pybind11-dev python3-dev >"$box/absent"
    drystone exit 0
    : >"$box/absent"
    touch "$box/status" # as apt-get does
    drystone exit 0
    expect_equal "the number of configurations" "$(grep -c configuring "$box/calls")" 2
    touch "$box/status" # some other package
    drystone exit 0
    drystone exit 0
    expect_equal "the number then" "$(grep -c configuring "$box/calls")" 2
    expect_equal "the number of builds" "$(grep -c building "$box/calls")" 1
}

claim_python_builds_the_module_alone_and_runs_python_with_it() {
    printf '%s\n' pybind11-dev python3-dev >"$box/absent"
    drystone python -c 'import stub, sys; print(stub.answer, sys.argv[1:])' "two words"
    expect_equal "stdout" "$(cat "$box/out")" "42 ['two words']"
    expect_text "$box/err" "building the Python module"
    expect_text "$box/calls" "install -y --no-install-recommends pybind11-dev python3-dev"
    expect_no_text "$box/calls" building
    drystone python -c 'raise SystemExit(3)'
    expect_equal "the exit code" "$code" 3
    expect_equal "stderr then" "$(cat "$box/err")" ""
    expect_equal "the number of builds" "$(grep -c module "$box/calls")" 1
}

claim_a_test_of_a_module_that_is_not_built_says_so() {
    drystone test -R python:
    expect_text "$box/err" "no test ran"
    expect_text "$box/err" "./drystone python installs what it needs"
}

claim_a_moved_checkout_builds_again() {
    drystone exit 0
    mv -- "$checkout" "$box/moved here"
    checkout="$box/moved here"
    echo 'echo moved' >>"$checkout/app/program.sh"
    drystone
    expect_equal "stdout" "$(cat "$box/out")" moved
}

claim_runs_at_the_same_time_build_once() {
    local run
    for run in 1 2 3 4; do
        env -i PATH="$tools" BOX="$box" "$checkout/drystone" show "$run" &
    done >>"$box/out" 2>>"$box/err"
    wait
    expect_equal "the answers" "$(sort "$box/out" | paste -sd' ')" "<1> <2> <3> <4>"
    expect_equal "the number of builds" "$(grep -c building "$box/calls")" 1
}

claim_a_ready_program_can_be_named() {
    settings=(DRYSTONE_PROGRAM="$checkout/app/program.sh")
    drystone show ready
    expect_equal "stdout" "$(cat "$box/out")" "<ready>"
    expect_equal "the calls" "$(cat "$box/calls")" ""
    [[ ! -e $checkout/build ]] || fail "it made a build directory"
}

claim_without_the_means_to_install_the_missing_packages_are_listed() {
    printf '%s\n' libeigen3-dev g++ >"$box/absent"
    fake id <<<'echo 1000'
    drystone show no
    expect_equal "the exit code" "$code" 1
    expect_equal "stdout" "$(cat "$box/out")" ""
    expect_text "$box/err" "this is neither root nor a user of sudo"
    expect_no_text "$box/err" "running:"
    expect_equal "the list" "$(sed -n 's/^    //p' "$box/err")" $'g++\nlibeigen3-dev'
    expect_no_text "$box/calls" apt-get
    expect_no_text "$box/calls" building
}

claim_a_system_without_dpkg_gets_the_full_list() {
    rm "$tools/dpkg-query"
    drystone show no
    expect_equal "the exit code" "$code" 1
    expect_text "$box/err" "not a Debian-like system"
    expect_equal "the length of the list" "$(grep -c '^    ' "$box/err")" \
        "$(sed -n '/^packages=(/,/)/{s/packages=//;p}' "$checkout/drystone" | wc -w)"
    expect_no_text "$box/calls" apt-get
}

claim_a_directory_configured_by_hand_needs_no_packages() {
    rm "$tools/dpkg-query"
    (cd -- "$checkout" && env -i PATH="$tools" BOX="$box" cmake --preset release >/dev/null)
    drystone show yes
    expect_equal "stdout" "$(cat "$box/out")" "<yes>"
}

claim_root_installs_what_is_missing_and_nothing_else() {
    printf '%s\n' catch2 cmake >"$box/absent"
    drystone exit 0
    expect_equal "the exit code" "$code" 0
    expect_equal "the apt-get calls" "$(grep apt-get "$box/calls" | sed 's/-o [^ ]* //')" \
        "apt-get noninteractive -qq update
apt-get noninteractive -qq install -y --no-install-recommends cmake catch2"
}

claim_a_user_installs_through_sudo_after_being_told() {
    echo catch2 >"$box/absent"
    fake id <<<'echo 1000'
    fake sudo <<'TOOL'
[[ $1 != -n ]] || exit 0
echo "sudo" >>"$BOX/calls"
exec "$@"
TOOL
    drystone show yes
    expect_equal "stdout" "$(cat "$box/out")" "<yes>"
    expect_equal "the number of commands told" "$(grep -c "running: sudo env" "$box/err")" 2
    expect_text "$box/err" "install -y --no-install-recommends catch2"
    expect_equal "the calls of sudo" "$(grep -cx sudo "$box/calls")" 2
    expect_text "$box/calls" "install -y --no-install-recommends catch2"
}

claim_a_sudo_that_asks_is_not_run_without_a_terminal() {
    echo catch2 >"$box/absent"
    fake id <<<'echo 1000'
    fake sudo <<<'[[ $1 != -n ]] && echo "sudo" >>"$BOX/calls"; exit 1'
    before=(setsid --wait)
    drystone show no
    expect_equal "the exit code" "$code" 1
    expect_text "$box/err" "sudo wants a password and there is no terminal"
    expect_no_text "$box/calls" sudo
}

claim_dpkg_is_asked_once_and_apt_never_when_all_is_there() {
    drystone exit 0
    drystone exit 0
    expect_equal "the calls" "$(grep -v -e building -e configuring "$box/calls")" "dpkg-query"
}

claim_an_install_that_leaves_packages_out_stops() {
    echo catch2 >"$box/absent"
    fake apt-get <<<'exit 0'
    drystone show no
    expect_equal "the exit code" "$code" 1
    expect_equal "the list" "$(sed -n 's/^    //p' "$box/err")" catch2
}

claim_each_processor_gets_the_fastest_preset_it_can_run() {
    local flags wanted
    while IFS=: read -r wanted flags; do
        rm -rf -- "$checkout/build"
        printf 'processor\t: 0\nflags\t\t: %s\nbugs\t\t:\n' "$flags" >"$box/cpu"
        drystone exit 0
        expect_equal "the build for '$flags'" "$(cd -- "$checkout/build" && echo *)" "$wanted"
    done <<'CPUS'
avx512:fpu fma bmi1 avx2 bmi2 avx512f avx512dq avx512cd avx512bw avx512vl
release:fpu fma bmi1 avx2 bmi2 avx512f avx512dq avx512cd avx512bw
release:fpu fma bmi1 avx2 bmi2
portable:fpu fma bmi1 avx bmi2
portable:fpu bmi1 avx2 bmi2
portable:fpu fma bmi1 avx2
CPUS
    printf 'CPU architecture: 8\nFeatures\t: fp asimd\n' >"$box/cpu"
    rm -rf -- "$checkout/build"
    drystone exit 0
    [[ -d $checkout/build/portable ]] || fail "no portable build for another architecture"
}

claim_an_unknown_preset_is_refused() {
    settings=(DRYSTONE_PRESET=none)
    drystone exit 0
    expect_equal "the exit code" "$code" 1
    expect_text "$box/err" "drystone: configuring failed"
}

claim_a_page_builds_first_and_hands_its_arguments_on() {
    local verb
    mkdir "$checkout/bench"
    for verb in validate joint_laws; do
        rm -rf -- "$checkout/build"
        cat >"$checkout/bench/${verb/validate/validation}.sh" <<'SCRIPT'
printf '<%s>\n' "$DRYSTONE_BENCH" "$@"
"$DRYSTONE_PROGRAM" show built
exit 3
SCRIPT
        drystone "$verb" "my runs"
        expect_equal "the exit code of $verb" "$code" 3
        expect_equal "what the script saw" "$(cat "$box/out")" \
            "$(printf '<%s>\n' "$checkout/build/release/bench" "my runs" built)"
    done
}

claim_test_ends_with_the_count() {
    drystone test
    expect_equal "the last line" "$(tail -n 1 "$box/out")" "2 passed, 0 failed"
    expect_equal "the exit code" "$code" 0
    drystone test -R good
    expect_equal "the last line with -R good" "$(tail -n 1 "$box/out")" "1 passed, 0 failed"
    touch "$checkout/app/program.sh"
    drystone exit 0
    expect_equal "stderr of a run after the tests" "$(cat "$box/err")" \
        "drystone: building what changed"
}

claim_the_quick_tests_do_not_build_what_writes_pages() {
    drystone test
    expect_equal "the last line" "$(tail -n 1 "$box/out")" "2 passed, 0 failed"
    expect_text "$box/err" "neither slow tests nor those of what writes docs/ did run"
    expect_no_text "$box/calls" pages
    drystone test all
    expect_equal "the last line of all" "$(tail -n 1 "$box/out")" "3 passed, 0 failed"
    expect_text "$box/err" "building what writes the pages of docs/"
    expect_equal "the number of builds of pages" "$(grep -c pages "$box/calls")" 1
}

claim_the_tests_want_python_and_the_program_does_not() {
    echo python3 >"$box/absent"
    fake id <<<'echo 1000'
    drystone test
    expect_equal "the list for the tests" "$(sed -n 's/^    //p' "$box/err")" python3
    drystone show yes
    expect_equal "stdout of the program" "$(cat "$box/out")" "<yes>"
}

claim_test_fails_with_a_test() {
    write_presets '"STUB_TEST": "echo cause; exit 3"'
    drystone test
    expect_equal "the last line" "$(tail -n 1 "$box/out")" "2 passed, 1 failed"
    expect_equal "the exit code" "$code" 1
    expect_text "$box/out" cause
}

claim_test_counts_what_cannot_be_started_as_failed() {
    echo 'add_test(NAME lost COMMAND /nonexistent)' >>"$checkout/CMakeLists.txt"
    drystone test
    expect_equal "the last line" "$(tail -n 1 "$box/out")" "2 passed, 1 failed"
    expect_equal "the exit code" "$code" 1
}

claim_test_without_a_test_fails() {
    drystone test -R nothing
    expect_equal "the last line" "$(tail -n 1 "$box/out")" "0 passed, 0 failed"
    expect_equal "the exit code" "$code" 1
    fake ctest <<<'exit 5' # before any report
    drystone test
    expect_equal "the last line of a broken ctest" "$(tail -n 1 "$box/out")" "0 passed, 0 failed"
    expect_equal "the exit code of a broken ctest" "$code" 1
    expect_equal "stderr of a broken ctest" "$(cat "$box/err")" \
        $'drystone: ctest failed with exit code 5\ndrystone: no test ran'
}

box=$(readlink -f -- "$(mktemp -d)")
trap 'rm -rf -- "$box"' EXIT
checkout="$box/check out"
tools=$box/tools
launcher=
settings=() # of the environment
before=()   # words before the command
make_tools
make_checkout "$1"
"claim_$2"
