#!/usr/bin/env bash
# bash packaging/release.sh   everything a release page shows, in build/release-VERSION: Debian packages, source tarball, the page that
# pushes a wall, the site, checksums. It takes a clean checkout.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
version=$(sed -n 's/^project(drystone VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
out=build/release-$version
git=(git -c safe.directory='*')
[[ -z $("${git[@]}" status --porcelain) ]] || { echo "commit first: the tarball is of what is committed" >&2; exit 1; }
rm -rf -- "$out"
mkdir -p -- "$out"
"${git[@]}" archive --prefix="drystone-$version/" HEAD | gzip -9n >"$out/drystone-$version.tar.gz"
cmake --workflow --preset package
cp -- build/package/*_"$version"_amd64.deb "$out"
bash site/build.sh
cp -- build/site/try/index.html "$out/drystone-try-$version.html"
tar -C build/site -czf "$out/drystone-site-$version.tar.gz" .
(cd -- "$out" && sha256sum -- * >SHA256SUMS)
ls -l -- "$out"
