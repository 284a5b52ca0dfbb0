#!/usr/bin/env bash
# bash packaging/release.sh   everything a release page shows, in build/release-VERSION: Debian packages, source tarball, the page that
# pushes a wall, the site, recipes of conda-forge and Homebrew with the tarball's checksum, checksums of all. It takes a clean checkout.
# DRYSTONE_RELEASE_URL: where the files will be found, for the recipes (default: that folder).
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
version=$(sed -n 's/^project(drystone VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
out=build/release-$version
git=(git -c safe.directory='*')
[[ -z $("${git[@]}" status --porcelain) ]] || { echo "commit first: the tarball is of what is committed" >&2; exit 1; }
rm -rf -- "$out"
mkdir -p -- "$out"
tarball=drystone-$version.tar.gz
"${git[@]}" archive --prefix="drystone-$version/" HEAD | gzip -9n >"$out/$tarball"
cmake --workflow --preset package
cp -- build/package/*_"$version"_amd64.deb "$out"
bash site/build.sh
[[ -s build/site/try/index.html ]] || { echo "no release without the page that pushes a wall" >&2; exit 1; }
cp -- build/site/try/index.html "$out/drystone-try-$version.html"
tar -C build/site -czf "$out/drystone-site-$version.tar.gz" .
url=${DRYSTONE_RELEASE_URL:-file://$PWD/$out} sum=$(sha256sum -- "$out/$tarball" | cut -d' ' -f1)
sed "s|@URL@|$url|; s|@SHA256@|$sum|" packaging/homebrew/drystone.rb >"$out/drystone.rb"
sed "s|^  path: .*|  url: $url/$tarball\n  sha256: $sum|" packaging/conda/meta.yaml >"$out/meta.yaml"
(cd -- "$out" && sha256sum -- * >SHA256SUMS)
ls -l -- "$out"
