#!/usr/bin/env bash
# test_law_choice.sh ROOT COMPILER   a contact law that nobody chooses does not compile: a further name in dem/contact/contact_options.hpp
# is an error where laws are told apart. Exit code 0: so it is, 1: it compiled, or does not compile without it.
set -euo pipefail
root=$1 compiler=$2
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
mkdir -p -- "$work/dem/contact"
cat >"$work/law.cpp" <<'END'
#include "dem/contact/contact_law.hpp"
void choose(dem::ContactLaw law) { dem::with_contact_law(law, []<dem::ContactLaw>() {}); }
END
compiles() { "$compiler" -std=c++20 -Wall -Werror -fsyntax-only -I "$work" -I "$root" "$work/law.cpp"; }

cp -- "$root/dem/contact/contact_options.hpp" "$work/dem/contact"
compiles
sed 's/^enum class ContactLaw {/&\n    another,/' "$root/dem/contact/contact_options.hpp" >"$work/dem/contact/contact_options.hpp"
! cmp -s "$root/dem/contact/contact_options.hpp" "$work/dem/contact/contact_options.hpp"
compiles 2>"$work/said" && { echo "a law of no function compiles"; exit 1; }
[[ $(grep -c 'enumeration value.*another.* not handled' "$work/said") -ge 2 ]] || { cat "$work/said"; exit 1; }
