#!/usr/bin/env bash
# man_page.sh PROGRAM FILE.gz   the manual page, from what the program says of itself
set -euo pipefail
program=$1
version=$("$program" version | sed -n 1p)

verbatim() { # text as it is: backslashes, hyphens and dots at the start of a line are roff's own
    sed -E -e 's/default: [0-9]+, all of/default: all of/' \
        -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^[.']/\\\\\&&/"
}

page() {
    echo ".TH DRYSTONE 1 \"\" \"$version\" \"User Commands\""
    echo .SH NAME
    echo 'drystone \- in-plane push of dry-joint stone masonry walls by the discrete element method'
    echo .SH SYNOPSIS
    echo '.B drystone'
    echo 'VERB [FILE] [options]'
    echo .SH DESCRIPTION
    echo .nf
    "$program" help | tail -n +2 | verbatim
    echo .fi
    for verb in $("$program" help | awk '/^  drystone / {print $2}'); do
        [[ $verb != help && $verb != version ]] || continue
        echo ".SH ${verb^^}"
        echo .nf
        "$program" help "$verb" | verbatim
        echo .fi
    done
    echo .SH FILES
    echo '.I /usr/share/doc/drystone/examples'
    echo 'holds example studies.'
}

page | gzip -9n >"$2"
