#!/usr/bin/env bash
# A batch over the nodes of a Slurm cluster, as an array of jobs:
#
#     sbatch --array=0-99 examples/slurm.sh list.txt out [OPTIONS OF crease normals...]
#     crease journal merge out/share-*.jsonl > batch.jsonl; crease journal summary batch.jsonl
#
# A job that ends early is queued again and goes on where its journal ends. All nodes must see the files.
#SBATCH --job-name=crease
#SBATCH --cpus-per-task=2
#SBATCH --mem=8G
#SBATCH --requeue
set -euo pipefail
list=$1 out=$2
shift 2
share=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN))
mkdir -p "$out"
exec "${CREASE:-crease}" normals --manifest "$list" --out-dir "$out" \
    --shard "$share/$SLURM_ARRAY_TASK_COUNT" --journal "$out/share-$share.jsonl" --retries 3 \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" --threads "${SLURM_CPUS_PER_TASK:-1}" -q "$@"
