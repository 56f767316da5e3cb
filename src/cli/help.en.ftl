# The help of the program, and of options that several verbs have.

about = Compute, check and draw mesh normals; change nothing else in a file
threads = Threads to use; the output is the same for any number [default: one per processor]
json = Report as JSON
quiet = Report errors only
verbose = Report details
color = Colour on the terminal
completions-about = Print a completion script for a shell
completions-shell = The shell
help-about = Print the help of the program, or of one verb
help-verb = The verb; without it, the program
man-about = Print the manual page of the program, or of one verb
man-verb = The verb; without it, the program
completions-example-1 = crease completions bash > ~/.local/share/bash-completion/completions/crease
completions-example-2 = crease completions zsh > ~/.zfunc/_crease
completions-example-3 = crease completions fish > ~/.config/fish/completions/crease.fish
man-example-1 = crease man > crease.1
man-example-2 = crease man normals > crease-normals.1
man-example-3 = crease man inspect | man -l -
inputs = Files, folders (with --recursive), or `-` for standard input
format = Format of the input [default: by content, else by name]
recursive = Include all mesh files in folders and below, except hidden ones
manifest = File that lists the inputs, or `-`: a path on each line, or an object with `input`, `output` and `options`
shard = Share of the inputs, chosen by a hash of their names: 0/4 to 3/4 together contain all inputs
journal = Journal of the batch, a line of JSON for each file. A run with the same journal skips the files that are done, if their
    inputs, outputs and the options are unchanged
retries = Further tries for files that cannot be read or written
keep-going = Continue after a file that failed; `--keep-going=false` stops at the first
jobs = Inputs that are processed at the same time. Outputs and reports are the same for any number
memory = Memory that concurrent inputs may need together, such as 8G, estimated from their sizes and formats; a larger input is
    processed alone [default: three quarters of the available memory]
root = Further folder from which companion files (MTL, glTF buffers) may be read; the only one for standard input [default:
    the input's folder]
allow-extension = glTF extension that a file may require although crease does not know it; use it for extensions without vertices,
    indices or their order

## What `-h` shows of every verb.

json-short = Report as JSON
quiet-short = Report errors only
verbose-short = Report details
