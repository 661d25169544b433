#!/usr/bin/env bash
# Everything that a change has to pass. Stops at the first thing that fails.
set -euo pipefail
cd "$(dirname "$0")"

step() { printf '\n== %s\n' "$*"; }

step format
cargo fmt --check

step lints
cargo clippy --all-targets -- -D warnings
cargo clippy --all-targets --no-default-features -- -D warnings

step documentation
RUSTDOCFLAGS='-D warnings' cargo doc --no-deps

step tests
references=$(mktemp)
trap 'rm -f "$references"' EXIT
INSTA_SNAPSHOT_REFERENCES_FILE=$references INSTA_UPDATE=no cargo test

step snapshots
unreferenced=0
while IFS= read -r snapshot; do
    if ! grep -qF -- "/${snapshot##*/}" "$references"; then
        echo "no test refers to $snapshot: delete it"
        unreferenced=1
    fi
done < <(find snapshots -type f \( -name '*.snap' -o -name '*.snap.new' \) 2>/dev/null | sort)
[ "$unreferenced" = 0 ]

printf '\nall checks passed\n'
