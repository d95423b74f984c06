#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the READMEs anew; needs no screen.
# Usage: apps/studio/pictures/make.sh [STUDIO]    STUDIO: build/release/apps/dgt-studio by default
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
studio=$(realpath "${1:-$root/build/release/apps/dgt-studio}")
cd "$root/tests/corpus"
"$studio" --screenshot "$here/drawing.png" --view draw --lang en --theme dark --size 1200x680 4P.bgt
"$studio" --screenshot "$here/nc.png" --view nc --lang ru --theme light --size 1200x680 4P.bgt
