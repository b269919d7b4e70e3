#!/usr/bin/env bash
# The library for other programs as its users have it: installed, found by pkg-config, called from C and Fortran;
# what the examples write is what the one in Python writes.
source "$2/tests/cli/begin"
command -v cmake >/dev/null && command -v pkg-config >/dev/null || exit 77
build=$(dirname "$program")
nm -D "$build/libplunge-result.so" | grep -q __asan && exit 77 # its users would have to be built alike

cmake --install "$build" --prefix "$folder/stage" >log 2>&1 || fail "no installation: $(cat log)"
export PKG_CONFIG_PATH=$(dirname "$(find "$folder/stage" -name plunge-result.pc)")
export LD_LIBRARY_PATH=$(dirname "$(find "$folder/stage" -name libplunge-result.so)")
flags=$(pkg-config --define-variable=prefix="$folder/stage" --cflags --libs plunge-result) || fail "pkg-config"
fortran=$(pkg-config --define-variable=prefix="$folder/stage" --variable=fortran plunge-result)

same_as_python() { # what may differ: names, dates and the last bits of libm
  "$program" diff airy.h5 "$1" --rtol 1e-13 --atol 1e-12 >log 2>&1
  grep -vE '^@(solver|run|title|complete|version|revision|created|floats):|: only in airy-[cf].h5$|quantities differ' log &&
    fail "$1 is not what Python writes"
  "$program" compare airy.h5 "$1" -o report >log 2>&1 || fail "$1 cannot be compared: $(cat log)"
}

pretend_gnuplot
/usr/bin/python3 "$2/docs/examples/write_result.py" 2>/dev/null || exit 77
cc -Wall -Werror -o c "$2/docs/examples/write_result.c" $flags -lm >log 2>&1 || fail "the example in C: $(cat log)"
./c && same_as_python airy-c.h5
command -v c++ >/dev/null && ! c++ -x c++ -fsyntax-only $flags "$2/library/plunge_result.h" >log 2>&1 && fail "the header in C++: $(cat log)"
if command -v gfortran >/dev/null; then
  gfortran -Wall -Werror=conversion -o f "$fortran" "$2/docs/examples/write_result.f90" $flags >log 2>&1 ||
    fail "the example in Fortran: $(cat log)"
  ./f && same_as_python airy-f.h5
fi

exit $failed
