#!/usr/bin/env bash
# Takes a film with several processes on this machine, with GNU parallel. The same line again takes what is missing.
#
#     parallel.sh FILM SCENE OPTION ...
#     JOBS=4 parallel.sh film.mp4 scene.json --from 0 --to 0.99
#
# Each part is tried three times. More machines that share a folder: PARALLEL='-S host1,host2 --workdir .' parallel.sh ...
set -euo pipefail
film=$1
shift
frames=${film%.*}-frames
jobs=${JOBS:-$(nproc)}
parts=$((4 * jobs))

# a mistake in the scene or in the options ends here, and is not tried again
tompkins animate "$@" --list > /dev/null

seq 0 $((parts - 1)) | parallel --will-cite --jobs "$jobs" --retries 3 --halt soon,fail=1 -q -I @part@ \
    tompkins animate "$@" --part "@part@/$parts" --threads 1 --skip-existing -o "$frames"
tompkins animate --assemble "$frames" -o "$film"
