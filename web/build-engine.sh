#!/usr/bin/env bash
# Builds the engine of the workbench, crates/objdict-wasm, into web/src/wasm: with the target of rustup where it is installed, else
# with Debian's `rustc-web`, `rust-web-src` and `lld-19`. `build-engine.sh --check` only says whether one of them is there, and
# `--profile NAME` takes another profile than `wasm`: `wasm-quick` optimises nothing, for work on the page.
set -euo pipefail
cd "$(dirname "$0")/.."

target=wasm32-unknown-unknown
profile=wasm
[ "${1:-}" != --profile ] || profile=${2:?the name of a profile is missing}
arguments=(build --quiet --package objdict-wasm --profile "$profile" --locked --target "$target" --target-dir target/wasm)
if [ -d "$(rustc --print sysroot)/lib/rustlib/$target/lib" ]; then
  :
elif [ -x /usr/bin/rustc ] && [ -d /usr/lib/rustlib/src/rust/library/std ] && command -v wasm-ld-19 >/dev/null; then
  export RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld-19
  # a standard library of small parts, without the words of a panic, which a page never sees, is a fifth of the engine less
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-Zunstable-options -Cpanic=immediate-abort -Zlocation-detail=none"
  arguments+=('-Zbuild-std=std,panic_abort' -Zbuild-std-features=optimize_for_size)
else
  echo "no compiler for $target: install it with \`rustup target add $target\`, or Debian's rustc-web, rust-web-src and lld-19" >&2
  exit 3
fi
[ "${1:-}" != --check ] || exit 0

# the program that writes the JavaScript must be of the version of the crate; TLS is for its test runner
version=$(sed -n 's/^wasm-bindgen = "=\(.*\)"/\1/p' crates/objdict-wasm/Cargo.toml)
export PATH="$PWD/target/wasm-bindgen/bin:$PATH"
if [ "$(wasm-bindgen --version 2>/dev/null)" != "wasm-bindgen $version" ]; then
  env -u RUSTC -u RUSTC_BOOTSTRAP CARGO_PROFILE_DEV_DEBUG=0 cargo install wasm-bindgen-cli --version "$version" \
    --debug --quiet --no-default-features --bin wasm-bindgen --root target/wasm-bindgen
fi

CARGO_INCREMENTAL=0 cargo "${arguments[@]}"
# names of functions would double what is loaded
wasm-bindgen --target web --remove-name-section --out-dir web/src/wasm "target/wasm/$target/$profile/objdict_wasm.wasm"
