#!/usr/bin/env bash
# Builds the site with its search index: `.ci/site.sh BIN` with mdBook and Pagefind of the Python environment whose programs are in BIN.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=$1
site=target/site
rm -rf "$site"
"$bin/mdbook" build docs
# what mdBook adds to each site, and the sources of this one
(cd "$site" && rm -rf theme fonts book.toml rules-shares.tsv ./*-highlight*.css ./*-night*.css ./highlight*.css ./clipboard*.js ./favicon*.png css/{chrome,print,variables}*.css)
"$bin/python" -m pagefind --site "$site" --root-selector main --exclude-selectors .turn --quiet
# only the scripts that the page of the site loads; its text is English
(cd "$site/pagefind" && rm -f pagefind-*ui* pagefind-highlight.js wasm.unknown.pagefind)
