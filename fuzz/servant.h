/* A second process, forked while the fuzzer's is still small, that does what needs children:
 * forking is then several times faster. It leaves each work to a worker first (hasty.h), and does
 * it itself, with a child as the program has it, when the worker died of it.
 *
 * HDF5 is not ours: that a process dies inside it is no find. An error of our code, wherever, ends
 * the fuzzer with SIGABRT, and FUZZ_REPORT tells of it. */
#pragma once

#define FUZZ_REPORT "child-report"

/* `serve` finds its work in shared memory and aborts when something is wrong. */
void fuzz_servant_start(void (*serve)(void));

/* Serves once; aborts when the servant has died. */
void fuzz_servant_call(void);
