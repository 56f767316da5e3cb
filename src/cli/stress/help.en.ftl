# The help of `crease stress`.

about = Test numerical extremes and report which error bounds hold

    Each case computes something at the ends of the number range and compares it with exact arithmetic, or with the same formula
    in 256 bits. The table shows the worst error of `faithful` and of `fast` (of f64 and f32 where there is no such choice) next
    to that of plain f32 code. A cross marks visible errors: half a step of an 8-bit picture or more. The error of plain code is
    in the column of its cause: `definition` if its formula fails in exact arithmetic too, otherwise `overflow or rounding`.
    Results whose error is undefined are counted by kind: `NaN`, `inf`, and `zero` for zero vectors. With -v it prints what is computed,
    and the source of each bound.
example-1 = crease stress --only needle,offset -v
example-2 = crease stress --list
example-3 = crease stress --json > stress.json

only = Run only these groups of cases; repeatable
list = List the cases without running them

## What `-h` shows.

only-short = Run only these groups of cases
list-short = List the cases without running them
