#!/usr/bin/env bash
# Builds the pages and tries every story in a real browser. Needs Node.js, npm and Chromium (CHROMIUM names another than
# /usr/bin/chromium), and a target of the toolchain that rustup adds. Takes about 15 minutes the first time.
set -euo pipefail
cd "$(dirname "$0")/.."
dist=${1:-target/dist}

rustup target add wasm32-unknown-unknown
cargo test --release --manifest-path web/build/Cargo.toml
cargo run --release --manifest-path web/build/Cargo.toml -- -o "$dist"
# What pictures of browsers are compared with, and what writes the book.
cargo build --bin rayscope
npm ci --prefix web/tests --no-audit --no-fund
node web/tests/run.mjs "$dist"
