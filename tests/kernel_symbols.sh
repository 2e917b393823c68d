#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# kernel_symbols.sh NM LIBRARY: no function that the linker may take from any of several sources is in
# kernels of two instruction sets. It would take one of them for both, and a machine that lacks the
# other's instructions would meet them.
set -euo pipefail

"$1" -A --defined-only "$2" | awk '
    $1 ~ /kernels_[a-z0-9]+\.cpp\.o:/ && $2 == "W" {
        split($1, parts, ":")
        set = parts[2]
        ++count
        if ($3 in set_of && set_of[$3] != set) {
            print "in " set_of[$3] " and " set ": " $3
            failed = 1
        }
        set_of[$3] = set
    }
    END {
        print count + 0 " functions"
        exit failed || count == 0
    }'
