#!/usr/bin/env bash
# read_tables.sh PROGRAM STUDY.ini DOCS   runs the lines of docs/store.md for xarray and R on a study. Exit code 0: they ran and
# say what they should, 1: not, 77: none of the packages is there.
set -euo pipefail
program=$(readlink -f -- "$1") study=$(readlink -f -- "$2") docs=$(readlink -f -- "$3")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work"
awk '/^```/ { file = open ? "" : $2; open = !open; next } file != "" { print > file }' "$docs"
"$program" study "$study" --out paper.h5 --quiet --set solver.fidelity=rigid --set solver.steps_per_mm=100 \
    --set "load.max_displacement=3 mm" --set uq.samples=4 >/dev/null 2>&1
ran=0
if /usr/bin/python3 -c 'import xarray, pandas, h5netcdf' 2>/dev/null; then
    /usr/bin/python3 tables.py | tee said
    grep -qF "('wall',) N" said && grep -qE '^2 +4\.0 ' said || { echo "xarray: not the named table" >&2; exit 1; }
    if /usr/bin/python3 -c 'import netCDF4' 2>/dev/null; then
        sed -i 's/engine="h5netcdf"/engine="netcdf4", drop_variables=["reason", "input_name", "input_unit", "input_meaning"]/' tables.py
        /usr/bin/python3 tables.py | tee said
        grep -qF "('wall',) N" said || { echo "netcdf4: not the named table" >&2; exit 1; }
    fi
    ran=1
fi
if command -v Rscript >/dev/null && Rscript -e 'library(rhdf5)' >/dev/null 2>&1; then
    Rscript tables.R | tee said
    grep -qF '"N"' said || { echo "R: no unit" >&2; exit 1; }
    ran=1
fi
((ran)) || exit 77
