#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# kernel_symbols.sh NM LIBRARY: no function that the linker may take from any of several objects is in
# kernels of an instruction set and in anything else. It would take one of them for all, and a machine
# that lacks those instructions would meet them.
set -euo pipefail

"$1" -A --defined-only "$2" | awk '
    $2 == "W" {
        split($1, parts, ":")
        set = "all other code"
        if (match(parts[2], /^kernels_[a-z0-9]+/) && parts[2] !~ /^kernels_scalar/) {
            set = substr(parts[2], RSTART, RLENGTH)
            ++count
        }
        if ($3 in set_of && set_of[$3] != set) {
            print "in " set_of[$3] " and " set ": " $3
            failed = 1
        }
        set_of[$3] = set
    }
    END {
        print count + 0 " functions of kernels"
        exit failed || count == 0
    }'
