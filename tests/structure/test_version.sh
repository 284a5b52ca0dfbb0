#!/usr/bin/env bash
# test_version.sh ROOT PROGRAM   the program and every page name the version of CMakeLists.txt, and the changelog the revision of the solver.
# Exit code 0: so it is, 1: what says otherwise.
set -euo pipefail
cd -- "$1"
program=$2

broken=0
expect() { # $1: where; $2: what it says; $3: what it must say
    [[ $2 == "$3" ]] || { echo "$1 says '$2' instead of '$3'" && broken=1; }
}
first() { # $1: extended pattern with one group, $2: file; the group of the first line that has it
    sed -nE "s/.*$1.*/\1/p" "$2" | sed -n 1p
}

version=$(first 'project\(drystone VERSION ([0-9.]+)' CMakeLists.txt)
expect "CITATION.cff: version" "$(first '^version: (.*)' CITATION.cff)" "$version"
expect "packaging/conda/meta.yaml: version" "$(first '^\{% set version = "([0-9.]+)" %\}' packaging/conda/meta.yaml)" "$version"
expect "packaging/homebrew/drystone.rb: url" "$(first 'url "@URL@.drystone-([0-9.]+)\.tar\.gz"' packaging/homebrew/drystone.rb)" "$version"
expect "CHANGELOG.md: first release" "$(first '^## ([0-9.]+) \(.*\)' CHANGELOG.md)" "$version"
expect "CHANGELOG.md: date" "$(first '^## [0-9.]+ \(([0-9-]+)\)' CHANGELOG.md)" "$(first '^date-released: (.*)' CITATION.cff)"
while IFS=: read -r file line name; do
    expect "$file:$line" "$name" "drystone_${version}_amd64.deb"
done < <(grep -noE 'drystone_[0-9][0-9.]*_amd64\.deb' README.md packaging/drystone.def docs/*.md)

while IFS=: read -r file line name; do
    expect "$file:$line" "$name" "find_package(drystone ${version%.*} "
done < <(grep -noE 'find_package\(drystone [0-9.]+ ' examples/cpp/CMakeLists.txt docs/*.md)

revision=$(first 'kSolverRevision = ([0-9]+);' dem/solver/solver_revision.hpp)
expect "CHANGELOG.md: last revision of its table" "$(grep -oE '^\| [0-9]+ \|' CHANGELOG.md | tr -dc '0-9\n' | sort -n | tail -n 1)" "$revision"
said=$("$program" version)
expect "drystone version, first line" "$(sed -n 1p <<<"$said")" "drystone $version"
expect "drystone version, last line" "$(sed -n '$p' <<<"$said")" "solver revision $revision"
if [[ -e .git ]] && command -v git >/dev/null; then
    commit=$(sed -nE '2s/^commit (.*)/\1/p' <<<"$said")
    git -c safe.directory='*' cat-file -e "${commit%-dirty}^{commit}" || { echo "drystone version names no commit: $said" && broken=1; }
fi
# Sources in a folder of another checkout have no commit of their own.
work=$(mktemp -d)
cmake -D SOURCE_DIR="$PWD/app" -D OUTPUT="$work/commit.cpp" -P cmake/write_commit.cmake
grep -q 'return "";' "$work/commit.cpp" || { echo "a folder of a checkout has a commit" && broken=1; }
rm -r -- "$work"
[[ -n $version && -n $revision ]] || { echo "no version or no revision was found" && broken=1; }
exit "$broken"
