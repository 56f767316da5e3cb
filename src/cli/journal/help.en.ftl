# The help of `crease journal`.

about = Summarise, merge or search journals of batches

    `--journal FILE` of `normals`, `inspect` and `render` writes a journal. If several entries have the same input and output, the one that ended last counts.
example-1 = crease journal summary batch.jsonl
example-2 = crease journal failed log.jsonl | crease normals --manifest - --out-dir out
example-3 = crease journal merge shard-*.jsonl > batch.jsonl

action = Task
journals = Journals
