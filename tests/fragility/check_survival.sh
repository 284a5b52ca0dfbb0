#!/bin/sh
# Fits of random data sets against R (survival, MASS, nnet). check_survival.sh PROGRAM
# Exit code 0: they agree within 1e-6, 1: not, 77: skipped, R or a package is missing.
set -e
here=$(dirname "$0")
command -v Rscript >/dev/null || { echo "skipped: no Rscript"; exit 77; }
Rscript -e 'quit(status = !all(sapply(c("survival", "MASS", "nnet"), requireNamespace, quietly = TRUE)))' \
    >/dev/null 2>&1 || { echo "skipped: R package survival, MASS or nnet is missing"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
FITS_FOLDER="$folder" "$1" "[survival_data]" >/dev/null
Rscript "$here/check_survival.R" "$folder"
