#!/usr/bin/env bash
# renew.sh   fetches the version in report/package.json, checked against report/package-lock.json, into this folder
# To move to another version: npm install --package-lock-only --save-exact uplot@VERSION in report/, then this.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cp -- "$here/../package.json" "$here/../package-lock.json" "$work"
npm ci --prefix "$work" --ignore-scripts --no-audit --no-fund # refuses what does not match the lock
from=$work/node_modules/uplot
cp -- "$from/dist/uPlot.iife.min.js" "$from/dist/uPlot.min.css" "$here"
cp -- "$from/LICENSE" "$here/uPlot.LICENSE"
cd -- "$here"
sha256sum uPlot.LICENSE uPlot.iife.min.js uPlot.min.css >SHA256SUMS
cat SHA256SUMS
