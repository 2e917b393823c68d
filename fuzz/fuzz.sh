# SPDX-License-Identifier: Apache-2.0
# What ./dev fuzz does. Each fuzzer starts from fuzz/corpus/NAME and, where they are, from the files of
# its format in data/; what it adds goes to build/fuzz/NAME, what fails to build/fuzz/NAME-*.

fuzz_targets() {
    local source
    for source in fuzz/fuzz_*.cpp; do
        source=${source##*/fuzz_}
        printf '%s\n' "${source%.cpp}"
    done
}

# fuzz_one TARGET SECONDS: its last line tells how many inputs it has tried.
fuzz_one() {
    local target=$1 seconds=$2 extra=() log=build/fuzz/$1.log
    mkdir -p "build/fuzz/$target" "fuzz/corpus/$target"
    if [[ -d data/$target ]]; then extra+=("data/$target"); fi
    if [[ -f fuzz/$target.dict ]]; then extra+=("-dict=fuzz/$target.dict"); fi
    if build/asan/fuzz/fuzz_"$target" "build/fuzz/$target" "fuzz/corpus/$target" "${extra[@]}" \
        -max_total_time="$seconds" -max_len=8192 -timeout=20 -rss_limit_mb=2048 \
        -artifact_prefix="build/fuzz/$target-" -print_final_stats=1 >"$log" 2>&1; then
        say "fuzz: $target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs, no finding"
    else
        tail -n 40 "$log" >&2
        die "fuzz: $target: a finding, see $log"
    fi
}

# fuzz_merge TARGET: makes fuzz/corpus/TARGET the seeds, which have names, and the fewest inputs besides
# them that reach every branch that was reached. How often each was taken isn't told apart: that keeps
# the corpora small.
fuzz_merge() {
    local target=$1 corpus=fuzz/corpus/$1 merged
    merged=$(mktemp -d)
    mkdir -p "build/fuzz/$target"
    find "$corpus" -type f -name '*.*' -exec cp -t "$merged" {} +
    build/asan/fuzz/fuzz_"$target" -merge=1 -use_counters=0 -max_len=8192 "$merged" "$corpus" \
        "build/fuzz/$target" >"build/fuzz/$target-merge.log" 2>&1
    find "$corpus" -type f ! -name '*.*' -delete
    find "$merged" -type f ! -name '*.*' -exec mv -t "$corpus" {} +
    rm -rf "$merged"
    say "fuzz: $target: $(find "$corpus" -type f | wc -l) inputs in the corpus"
}
