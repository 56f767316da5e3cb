#!/usr/bin/env bash
# A batch over the nodes of a Slurm cluster, in N shares as an array of jobs:
#
#     sbatch --array=0-99 examples/slurm.sh 100 list.txt out [OPTIONS OF crease normals...]
#     crease journal merge out/share-*.jsonl > batch.jsonl; crease journal summary batch.jsonl
#
# A job that ends early is queued again and continues where its journal ends. All nodes must see the files.
#SBATCH --job-name=crease
#SBATCH --cpus-per-task=2
#SBATCH --mem=8G
#SBATCH --requeue
set -euo pipefail
shares=$1 list=$2 out=$3
shift 3
mkdir -p "$out"
exec "${CREASE:-crease}" normals --manifest "$list" --out-dir "$out" \
    --shard "$SLURM_ARRAY_TASK_ID/$shares" --journal "$out/share-$SLURM_ARRAY_TASK_ID.jsonl" --retries 3 \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" --threads "${SLURM_CPUS_PER_TASK:-1}" -q "$@"
