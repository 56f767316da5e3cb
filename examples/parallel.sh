#!/usr/bin/env bash
# A batch over the processors of one machine, in N shares with GNU parallel:
#
#     bash examples/parallel.sh N list.txt out [OPTIONS OF crease normals...]
#
# Each share writes a journal of its own. A second call skips what is done; a share that was killed is repeated. The exit code is 5 if a
# share had failures, as that of a batch.
set -euo pipefail
shares=$1 list=$2 out=$3
shift 3
crease=${CREASE:-crease}
mkdir -p "$out"

status=0
seq 0 $((shares - 1)) | parallel --quote --halt never --retries 3 --line-buffer \
    "$crease" normals --manifest "$list" --out-dir "$out" --shard "{}/$shares" --journal "$out/share-{}.jsonl" --threads 1 -q "$@" || status=$?

"$crease" journal merge "$out"/share-*.jsonl >"$out/batch.jsonl"
"$crease" journal summary "$out/batch.jsonl"
exit $((status > 0 ? 5 : 0))
