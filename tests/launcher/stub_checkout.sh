#!/usr/bin/env bash
# A checkout with a blank in its path: the launcher, a "program" that is a shell script and needs no compiler, and
# a PATH where dpkg-query, apt-get, sudo and id are fakes. Sourced; $box, $checkout, $tools, $launcher, $settings
# and $before are the caller's.

fail() {
    echo "FAILED: $*" >&2
    [[ ! -s $box/err ]] || sed 's/^/    stderr: /' "$box/err" >&2
    [[ ! -s $box/out ]] || sed 's/^/    stdout: /' "$box/out" >&2
    exit 1
}
expect_equal() { # $1: what, $2: found, $3: wanted
    [[ $2 == "$3" ]] || fail "$1 is '$2', not '$3'"
}
expect_text() { # $1: file, $2: text it holds
    grep -qF -e "$2" -- "$1" || fail "no '$2' in ${1##*/}"
}
expect_no_text() {
    ! grep -qF -e "$2" -- "$1" || fail "'$2' in ${1##*/}"
}

# The launcher with a bare environment; stdout, stderr and exit code are kept. $@: its arguments
drystone() {
    code=0
    "${before[@]}" env -i PATH="$tools" BOX="$box" "${settings[@]}" \
        "${launcher:-$checkout/drystone}" "$@" >"$box/out" 2>"$box/err" </dev/null || code=$?
}

fake() { # $1: name, stdin: the script; replaces a real tool of that name
    rm -f -- "$tools/$1"
    { echo '#!/usr/bin/env bash'; cat; } >"$tools/$1"
    chmod +x "$tools/$1"
}

make_tools() { # a short PATH: what the launcher counts on, and fakes that write down their calls
    local tool
    mkdir "$tools"
    for tool in bash cat cmake cp ctest env flock grep mkdir ninja nproc readlink rm sh sleep \
        touch; do
        ln -s "$(command -v "$tool")" "$tools/$tool"
    done
    : >"$box/absent" # one package per line
    : >"$box/calls"
    fake id <<<'echo 0'
    fake dpkg-query <<'TOOL'
echo "dpkg-query" >>"$BOX/calls"
for package in "${@:4}"; do
    grep -qxF -e "$package" "$BOX/absent" || echo "$package installed"
done
TOOL
    fake apt-get <<'TOOL'
echo "apt-get ${DEBIAN_FRONTEND-} $*" >>"$BOX/calls"
echo "apt-get talks on stdout"
[[ " $* " != *" install "* ]] || : >"$BOX/absent"
TOOL
}

make_checkout() { # a program and three tests, all shell scripts
    mkdir -p "$checkout/app"
    sed "s|/proc/cpuinfo|'$box/cpu'|; s|/var/lib/dpkg/status|'$box/status'|" "$1/drystone" >"$checkout/drystone"
    : >"$box/status" # dpkg's database: newer after an install
    chmod +x "$checkout/drystone"
    echo "flags : avx2 fma bmi2" >"$box/cpu" # the same on any machine
    cat >"$checkout/app/program.sh" <<'SCRIPT'
#!/usr/bin/env bash
# version 1
case ${1-} in
show) printf '<%s>\n' "${@:2}" ;;
where) pwd ;;
pid) echo "$$" ;;
push) printf '%s\n' "${0##*/}" ;;
exit) exit "$2" ;;
read) cat ;;
esac
SCRIPT
    chmod +x "$checkout/app/program.sh"
    cat >"$checkout/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(stub NONE)
file(APPEND "$ENV{BOX}/calls" "configuring\n")
set(program ${PROJECT_BINARY_DIR}/app/drystone)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/app)
add_custom_command(OUTPUT ${program} DEPENDS ${PROJECT_SOURCE_DIR}/app/program.sh VERBATIM
    COMMAND sh -c "echo building >>\"$BOX/calls\"; sleep 0.1; test ! -e \"$BOX/broken\""
    COMMAND cp ${PROJECT_SOURCE_DIR}/app/program.sh ${program})
add_custom_target(drystone ALL DEPENDS ${program})
add_custom_command(OUTPUT ${program}-wall DEPENDS ${PROJECT_SOURCE_DIR}/app/program.sh VERBATIM
    COMMAND sh -c "echo wall >>\"$BOX/calls\"" COMMAND cp ${PROJECT_SOURCE_DIR}/app/program.sh ${program}-wall)
add_custom_target(drystone-wall DEPENDS ${program}-wall)
set(module ${PROJECT_BINARY_DIR}/python/stub.py)
add_custom_command(OUTPUT ${module} COMMAND sh -c "echo module >>\"$BOX/calls\"" VERBATIM
    COMMAND sh -c "mkdir -p python; echo 'answer = 42' >python/stub.py")
add_custom_target(drystone-python DEPENDS ${module})
set(tested ${PROJECT_BINARY_DIR}/tested)
add_custom_command(OUTPUT ${tested} COMMAND touch ${tested} VERBATIM)
add_custom_target(test_program ALL DEPENDS ${tested})
add_custom_command(OUTPUT ${tested}-pages COMMAND sh -c "echo pages >>\"$BOX/calls\"" COMMAND touch ${tested}-pages VERBATIM)
add_custom_target(drystone-pages DEPENDS ${tested}-pages)
add_custom_target(validation DEPENDS ${program})
add_custom_target(joint_laws DEPENDS ${program})
enable_testing()
add_test(NAME good COMMAND sh -c "exit 0")
add_test(NAME fine COMMAND cat ${tested})
add_test(NAME page COMMAND cat ${tested}-pages)
set_tests_properties(page PROPERTIES LABELS pages)
if(DEFINED STUB_TEST)
    add_test(NAME odd COMMAND sh -c "${STUB_TEST}")
    set_tests_properties(odd PROPERTIES SKIP_RETURN_CODE 77)
endif()
CMAKE
    write_presets
}

write_presets() { # $1: cache variables of the release preset, as JSON
    cat >"$checkout/CMakePresets.json" <<JSON
{ "version": 4, "configurePresets": [
    { "name": "release", "generator": "Ninja", "binaryDir": "\${sourceDir}/build/\${presetName}",
      "cacheVariables": { ${1-} } },
    { "name": "portable", "inherits": "release" }, { "name": "avx512", "inherits": "release" } ] }
JSON
}
