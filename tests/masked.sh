#!/bin/sh
# Runs a command as on an older processor: glibc's, numpy's and OpenBLAS's functions for AVX, FMA and what came after
# are hidden from it. A verdict that changes depends on the machine.
#
#     tests/masked.sh COMMAND...
if [ $# -eq 0 ]; then
    sed -n 's/^#  *tests/usage: tests/p' "$0" >&2
    exit 2
fi
GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX2_Usable,-AVX,-AVX_Usable,-FMA,-FMA_Usable,-FMA4,-FMA4_Usable
NPY_DISABLE_CPU_FEATURES="AVX F16C FMA3 AVX2 AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL"
OPENBLAS_CORETYPE=Nehalem
export GLIBC_TUNABLES NPY_DISABLE_CPU_FEATURES OPENBLAS_CORETYPE
exec "$@"
