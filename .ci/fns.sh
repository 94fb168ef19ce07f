set -euo pipefail
cd "$(dirname "$0")/.."

case all in
  core) core=1 long="" ;;
  long) core="" long=1 ;;
  all) core=1 long=1 ;;
  workbench) core="" long="" ;;
  *) echo "usage: .ci/run [core|long|workbench]" >&2; exit 2 ;;
esac

export CARGO_TERM_COLOR=never
# property tests try the same cases on every machine
export PROPTEST_RNG_SEED=20260101
export INSTA_UPDATE=no
export CARGO_INCREMENTAL=0

step() { printf '\n== %s\n' "$*"; }

# what is missing is installed in CI alone; elsewhere the tests that need it say so and are skipped
install() { apt-get update -q && apt-get install -qy --no-install-recommends "$@"; }
has() { command -v "$@" >/dev/null; }

tools() {
  step "tools"
  python3 -c 'import venv, ensurepip' 2>/dev/null || install python3-venv
  has xmllint || install libxml2-utils
  has cppcheck || install cppcheck
  # 100 MB; what else is recommended is C++ for the Cortex-M, three times as much
  { has arm-none-eabi-gcc && echo 'int main(void) { return 0; }' | gcc -m32 -x c -o /dev/null - 2>/dev/null; } ||
    install gcc-multilib gcc-arm-none-eabi libnewlib-arm-none-eabi
  # builds core for a Cortex-M4; rustup's compiler is first in the path and stays so
  { [ -x /usr/bin/rustc ] && [ -d /usr/lib/rustlib/src/rust/library/core ]; } || install rustc-web rust-web-src
  [ -n "$long" ] || return 0
  # without a font a text has no size
  { has chromium && fc-list | grep -q . && has pdftotext; } || install chromium fontconfig fonts-dejavu-core poppler-utils
  has cmake || install cmake
  has nvim || install neovim
  { has valgrind && type -P time >/dev/null; } || install valgrind time
}

format() {
  step "format"
  cargo fmt --all --check
  # the modules of the rules are declared by a macro, which rustfmt does not look into
  rustfmt --edition 2024 --check crates/objdict-lint/src/rules/*/*.rs
}

features() {
  step "each feature alone"
  for feature in "" generate rust c stacks template xdd json lint toml rust,toml node patch network document lsp; do
    warnings=$(cargo check --quiet --no-default-features --features "$feature" 2>&1) || { echo "$warnings"; exit 1; }
    [ -z "$warnings" ] || { echo "$warnings"; echo "warnings with the feature \`$feature\` alone"; exit 1; }
  done
  crates=$(cargo tree --no-default-features --features rust -e normal,build --prefix none --no-dedupe | awk '{print $1, $2}' | sort -u | wc -l)
  echo "a build script that generates Rust builds $crates crates with those of objdict"
  [ "$crates" -le 30 ] || { echo "more than 30 crates"; exit 1; }
}

oldest_rust() {
  oldest=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
  step "Rust $oldest, the oldest that is promised"
  if [ "${CI:-}" = true ] && has rustup && ! cargo "+$oldest" --version >/dev/null 2>&1; then
    rustup toolchain install "$oldest" --profile minimal --no-self-update
  fi
  if cargo "+$oldest" --version >/dev/null 2>&1; then
    for features in cli rust c stacks; do
      cargo "+$oldest" check --quiet --target-dir target/oldest --no-default-features --features "$features"
    done
  else
    echo "no Rust $oldest: whether it compiles this is not known"
  fi
}

lints() {
  sleep 5 # so that the tests, which wait for others more than for the processor, are not kept waiting by this build
  cargo clippy --workspace --all-targets --all-features -- -D warnings
  RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --all-features
}

# All tests are built at once, with the features that they have together, so that nothing is built twice. What is linted and documented
# shares the dependencies, and is made while the tests run.
tests() {
  step "build"
  if [ -n "$core" ] && [ -n "$long" ]; then
    # with benches, which run once each as tests, and the package that compiles with the crates of others
    targets=(--workspace --exclude objdict-python --all-targets)
  elif [ -n "$core" ]; then
    targets=(--workspace --exclude objdict-crates --exclude objdict-python --lib --bins --test library --test command --test generate)
  else
    targets=(--package objdict --package objdict-crates --package objdict-wasm --examples --benches --test requests --test browser --test memory --test derives --test drivers --test flash --test read_back --test runtime)
  fi
  cargo test "${targets[@]}" --no-run
  if [ -n "$core" ]; then
    lints >target/lints.log 2>&1 &
    lints=$!
    trap 'kill "$lints" 2>/dev/null || true' EXIT
  fi

  step "tests"
  cargo test "${targets[@]}"
  [ -n "$core" ] || return 0

  step "clippy and documentation"
  wait "$lints" || { cat target/lints.log; exit 1; }
  tail -n 2 target/lints.log

  step "the interface of the library"
  # a change of this list is a change for users: it belongs in CHANGELOG.md
  grep -o '<a href="[^"]*\.html">[^<]*' target/doc/objdict/all.html | sed 's/.*">//' | LC_ALL=C sort | diff tests/interface.txt -

  step "examples in the documentation"
  cargo test --workspace --doc
}

corrupted_files() {
  step "corrupted fixtures"
  # each reader, writer and transformer as many as it takes in this time
  cargo run --quiet --package xtask -- fuzz fixtures 20s

  step "programs for libFuzzer"
  cp Cargo.lock fuzz/Cargo.lock
  cargo check --quiet --manifest-path fuzz/Cargo.toml --target-dir target
}

site() {
  step "the site"
  # a debug build of mdBook is made in a third of the time, and builds the site in two seconds
  export PATH="$PWD/target/mdbook/bin:$PATH"
  has mdbook || cargo install mdbook --version 0.5.4 --locked --debug --no-default-features --features search --root target/mdbook
  mdbook build docs
}

examples() {
  step "the examples of the library"
  for example in examples/*.rs; do
    example=$(basename "$example" .rs)
    echo "$ cargo run --example $example"
    cargo run --quiet --example "$example"
  done | diff examples/library.txt -

  step "the firmware in Rust"
  # the packages of the lock file are here already
  cp Cargo.lock examples/firmware-rust/Cargo.lock
  firmware() { cargo "$1" --quiet --offline --manifest-path examples/firmware-rust/Cargo.toml --target-dir target/examples; }
  firmware test
  firmware run | diff - examples/session.txt
  cargo fmt --manifest-path examples/firmware-rust/Cargo.toml --check

  step "the node in Rust"
  cp Cargo.lock examples/node-rust/Cargo.lock
  node() { cargo "$@" --manifest-path examples/node-rust/Cargo.toml; }
  node build --quiet --offline --bins --examples --target-dir target/examples
  node fmt --check
  python=target/tmp/interop-venv/bin/python
  # made by the interoperability test
  if [ -x "$python" ]; then
    cargo run --quiet -- conformance --node-id 5 --format json fixtures/eds/all-types.eds > target/tmp/conformance.json
    "$python" examples/node-rust/test.py target/examples/debug/node fixtures/eds/all-types.eds target/tmp/conformance.json
    "$python" examples/node-rust/lss.py target/examples/debug/examples/lss
    "$python" examples/node-rust/bootloader.py target/examples/debug/examples/bootloader fixtures/eds/bootloader.eds
  else
    echo "no canopen for Python: the node has no master"
  fi

  step "the node with embassy and RTIC"
  if [ -x /usr/bin/rustc ] && [ -d /usr/lib/rustlib/src/rust/library/core ]; then
    (cd examples/node-embedded && cargo fmt --check && RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 cargo build --quiet --locked \
      -Zbuild-std=core --target thumbv7em-none-eabihf --target-dir ../../target/embedded --examples)
  else
    echo "no rustc-web or rust-web-src: skipped"
  fi

  step "the firmware in C"
  has cmake || { echo "no cmake: examples/firmware-c is skipped"; return 0; }
  cargo build --quiet
  for generator in "Unix Makefiles" Ninja; do
    [ "$generator" != Ninja ] || has ninja || { echo "no ninja: its half is skipped"; continue; }
    build="target/examples/c-${generator// /-}"
    rm -rf "$build"
    cmake -S examples/firmware-c -B "$build" -G "$generator" -DOBJDICT_EXECUTABLE="$PWD/target/debug/objdict"
    cmake --build "$build" --parallel 2
    ctest --test-dir "$build" --output-on-failure
  done
}

# the tests of `core` have it too, where Neovim is installed
neovim() {
  [ -z "$core" ] || return 0
  step "the language server in Neovim"
  cargo test --test command -- neovim
}

python_module() {
  step "the Python module"
  python3 -c 'import venv, ensurepip' 2>/dev/null || { echo "no Python with venv: the module is skipped"; return 0; }
  local environment=target/tmp/python-venv
  [ -x "$environment/bin/mypy" ] || { python3 -m venv "$environment" && "$environment/bin/pip" install --quiet pytest mypy canopen pandas; } ||
    { echo "no packages from PyPI: the module is skipped"; return 0; }
  rm -f target/dist/canopen_objdict-*.whl
  cargo run --quiet --package xtask -- dist wheel --profile dev
  "$environment/bin/pip" install --quiet --force-reinstall --no-deps target/dist/canopen_objdict-*.whl
  # the command of the wheel, which starts without Python
  "$environment/bin/objdict" --version
  (
    cd crates/objdict-python
    "../../$environment/bin/mypy" --config-file pyproject.toml
    "../../$environment/bin/stubtest" --mypy-config-file pyproject.toml --ignore-missing-stub canopen_objdict._native
    "../../$environment/bin/python" -m pytest --quiet -p no:cacheprovider tests
  )
}

vscode() {
  step "the extension of VS Code"
  has npm || { echo "no npm: skipped"; return 0; }
  cargo build --quiet --bin objdict
  # the tests package it too; scripts of packages are not needed
  (cd editors/vscode && npm ci --ignore-scripts --no-audit --no-fund --silent && npm test --silent)
}

workbench() {
  step "the workbench in the browser"
  web/build-engine.sh --check || { echo "skipped"; return 0; }
  has npm || { echo "no npm: skipped"; return 0; }
  cargo build --quiet --bin objdict
  (cd web && npm ci --no-audit --no-fund --silent && npm run --silent build && npm test --silent)
}

# the packages that users install, of the wheel that `python_module` built, and the crates as a registry gets them
packages() {
  step "packages"
  for kind in tarball deb npm docker; do
    case $kind in deb) has dpkg-deb ;; npm) has npm ;; esac || { echo "no program for $kind: skipped"; continue; }
    cargo run --quiet --package xtask -- dist "$kind" --profile dev
  done
  cargo run --quiet --package xtask -- dist try
  (cd target/dist && sha256sum --check --quiet SHA256SUMS)
  # the image has these files and nothing else of a system
  local image=target/tmp/image
  rm -rf "$image" && mkdir -p "$image/work"
  cp target/dist/docker/objdict "$image"
  cp fixtures/eds/minimal.eds "$image/work"
  local root=(unshare --map-root-user)
  [ "$(id -u)" != 0 ] || root=()
  "${root[@]}" chroot "$image" /objdict check /work/minimal.eds

  step "crates as a registry gets them"
  cargo run --quiet --package xtask -- publish
}

# a target and a format more are as little work as ARCHITECTURE.md says
extending() {
  step "a target and a format more"
  local tree=target/extended
  rm -rf "$tree" && mkdir -p "$tree/target/debug"
  git archive HEAD | tar -x -C "$tree"
  # what the packages need of others is built already
  cp -al target/debug/deps "$tree/target/debug"
  cp -a target/debug/build target/debug/.fingerprint "$tree/target/debug"
  (
    cd "$tree"
    git init --quiet
    git apply tests/extending/*.patch
    [ "$(grep -c '^+++' tests/extending/target.patch)" -le 10 ]
    [ "$(grep -c '^+++' tests/extending/format.patch)" -le 8 ]
    cargo build --quiet --bin objdict
    objdict=target/debug/objdict
    "$objdict" convert fixtures/eds/minimal.eds -o target/minimal.names
    "$objdict" identify target/minimal.names | grep -F "list of names (CANopen)"
    "$objdict" generate --quiet --target names target/minimal.names -o target/names
    tail -n +2 target/minimal.names | diff - target/names/minimal.txt
  )
}

instructions() {
  step "instructions of each command"
  { has valgrind && type -P time >/dev/null; } || { echo "no valgrind or GNU time: instructions are not counted"; return 0; }
  benches/instructions --check
}

advisories() {
  step "advisories"
  # licences, versions and sources are a test of xtask
  if cargo deny --version >/dev/null 2>&1; then cargo deny check; else echo "no cargo-deny: advisories are skipped"; fi
}


core=1; long=1; "$@"
