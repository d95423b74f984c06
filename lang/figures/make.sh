#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the figures of lang/README.md from the programs of tests/corpus/rows.
# Usage: lang/figures/make.sh [DGT]    DGT: the command, build/release/apps/dgt by default
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
dgt=$(realpath "${1:-$root/build/release/apps/dgt}")
cd "$root/tests/corpus/rows"
rm -f "$here"/*.svg
for program in *.bgt; do
  "$dgt" plot --names --size 480 "$program" -o "$here/${program%.bgt}.svg" 2>/dev/null || {
    echo "$program: not drawn" >&2
    exit 1
  }
done
