#!/usr/bin/env bash
# A few seconds of each fuzzing target; fuzz/run does it for longer.
exec nice "$2/fuzz/run" 4
