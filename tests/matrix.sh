#!/usr/bin/env bash
# Builds and tests the program as other processors would: other instructions, another optimisation,
# other BLAS kernels, one and two threads. A test that leans on the last bits of one machine fails here.
# Usage: tests/matrix.sh [ctest arguments]; builds lie in build/matrix.
set -uo pipefail
cd "$(dirname "$0")/.."

has() { grep -qwE "$1" /proc/cpuinfo; }

# name | what the processor must have | C flags | tuned for this processor | OpenBLAS kernel | threads
rows=(
  "v2       | ssse3   | -march=x86-64-v2 | OFF | Prescott | 1"
  "wide     | ssse3   | -march=x86-64-v2 -DPLUNGE_WIDE_VECTORS | OFF | Prescott | 1"
  "v3       | avx2    | -march=x86-64-v3 | OFF | Haswell  | 2"
  "O1       | sse2    | -O1              | ON  | Nehalem  | 1"
  "native   | sse2    |                  | ON  | Zen      | 2"
  "native   | avx512f |                  | ON  | SkylakeX | 1"
)

failed=()
for row in "${rows[@]}"; do
  IFS='|' read -r name needs flags native kernel threads <<<"$row"
  name=${name// /} needs=${needs// /} native=${native// /} kernel=${kernel// /} threads=${threads// /}
  label="$name, BLAS kernel $kernel, $threads thread(s)"
  if ! has "$needs" || { [[ $kernel =~ ^(Zen|Haswell)$ ]] && ! has avx2; }; then
    echo "== $label: not on this processor"
    continue
  fi
  echo "== $label"
  mkdir -p build/matrix
  folder=build/matrix/$name
  if cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE="-O3 -DNDEBUG $flags" \
    -DPLUNGE_NATIVE="$native" -DPLUNGE_TEST_THREADS="$threads" >"$folder.log" 2>&1 &&
    cmake --build "$folder" >>"$folder.log" 2>&1; then
    OPENBLAS_CORETYPE=$kernel ctest --test-dir "$folder" -j 2 --output-on-failure "$@" >"$folder-$kernel.log" 2>&1 ||
      failed+=("$label: $(grep -cE '\*\*\*(Failed|Timeout|Exception)' "$folder-$kernel.log") tests, see $folder-$kernel.log")
    grep -E 'tests passed|Total Test time|\*\*\*' "$folder-$kernel.log"
  else
    failed+=("$label: does not build, see $folder.log")
  fi
done
for line in "${failed[@]}"; do echo "FAILED $line"; done
((${#failed[@]} == 0))
