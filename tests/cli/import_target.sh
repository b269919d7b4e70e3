#!/usr/bin/env bash
# An import writes over an older result and over nothing else: neither what it reads, nor files of others, nor
# devices; and what it could not finish is gone.
source "$2/tests/cli/begin"

cat >flat.yaml <<'E2'
run: flat
solver: another
source: made up
case: case.yaml
spacing: 0.1
units: {length: m}
profiles: {format: csv, files: [{file: flat.csv, time: 0}], columns: {x: x, y: y}}
E2
cat >case.yaml <<'E2'
scales: {H: 2}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
water: {regions: [[[0, 0], [4, 0], [4, 2], [0, 2]]]}
time: {end: 1, every: 0.5}
runs: [{name: rest, solver: sph, resolution: 10}]
E2
printf 'x,y\n0,2\n4,2\n' >flat.csv
"$program" import flat.yaml >log 2>&1 || fail "no result: $(cat log)"
"$program" import flat.yaml >log 2>&1 || fail "an older result is not replaced: $(cat log)"

refused() { # sidecar, target, message: which file it is that stays as it was
  [ -f "$2" ] && cp "$2" before
  timeout 60 "$program" import "$1" --out "$2" >log 2>&1
  code=$?
  [ $code = 2 ] || fail "--out $2: exit code $code: $(cat log)"
  grep -qF "$3" log || fail "--out $2: $(cat log)"
  [ ! -f "$2" ] || cmp -s before "$2" || fail "--out $2: it was changed"
}
ending="allowed: a file whose name ends in .h5; correct --out"
refused flat.yaml flat.yaml "$ending"
refused flat.yaml flat.csv "$ending"
refused flat.yaml result "$ending"
for target in .h5 . "" folder/; do refused flat.yaml "$target" "$ending"; done
[ ! -e result ] || fail "a file without the ending"
for input in flat.yaml case.yaml flat.csv; do # under another name they are still what is read
  ln $input "hard-$input.h5"
  ln -s $input "soft-$input.h5"
  for kind in hard soft; do
    refused flat.yaml $kind-$input.h5 "cannot write $kind-$input.h5: it is $input, which this import reads; name another file with --out"
  done
done
ln flat.csv beside.xdmf
refused flat.yaml beside.h5 "cannot write beside.xdmf: it is flat.csv, which this import reads"
[ -e beside.xdmf ] && [ ! -e beside.h5 ] || fail "the .xdmf beside the target is an input"
other="it is there and is no result that plunge wrote; name another file with --out, or remove it"
mkfifo pipe.h5
mkdir folder.h5
echo words >text.h5
: >empty.h5
for target in pipe folder text empty; do refused flat.yaml $target.h5 "cannot write $target.h5: $other"; done
[ -p pipe.h5 ] && [ -d folder.h5 ] || fail "a pipe or a folder is gone"

# what is read is itself a result: particles of a cloud in VTKHDF's layout
cat >cloud.yaml <<'E2'
run: cloud
solver: another
source: made up
case: case.yaml
spacing: 0.1
units: {length: m, time: s}
particles: {format: csv, file: cloud.csv, columns: {time: t, x: x, y: y}}
E2
awk 'BEGIN { OFS = ","; print "t,x,y"; for (t = 0; t < 30; t++) for (i = 0; i < 40; i++) for (j = 0; j < 20; j++) print t, 0.05 + 0.1 * i + 1e-4 * (i * t % 7), 0.05 + 0.1 * j + 1e-4 * (j * t % 11) }' >cloud.csv
"$program" import cloud.yaml >log 2>&1 || fail "particles: $(cat log)"
[ -s cloud.xdmf ] || fail "no .xdmf"
sed 's/^run: .*/run: again/; s/^particles.*/particles: {format: vtkhdf, file: cloud.h5, columns: {x: "Points:0", y: "Points:1"}}/' cloud.yaml >again.yaml
refused again.yaml cloud.h5 "cannot write cloud.h5: it is cloud.h5, which this import reads"
sed 's/^run: .*/run: cloud/' again.yaml >same.yaml # the name of the run is that of the input
cp cloud.h5 before
"$program" import same.yaml >log 2>&1
[ $? = 2 ] && cmp -s before cloud.h5 || fail "run: cloud beside cloud.h5: $(cat log)"
if /usr/bin/python3 -c 'import h5py' 2>/dev/null; then # HDF5 of another program, though it has the scales
  /usr/bin/python3 -c 'import h5py; f = h5py.File("theirs.h5", "w"); f.attrs["H"] = 2.0; f["x"] = [0.0, 4.0]; f["y"] = [2.0, 2.0]'
  refused flat.yaml theirs.h5 "cannot write theirs.h5: $other"
  sed 's/^run: .*/run: theirs/; s/^profiles.*/profiles: {format: hdf5, files: [{file: theirs.h5, time: 0}], columns: {x: x, y: y}}/' flat.yaml >theirs.yaml
  refused theirs.yaml theirs.h5 "cannot write theirs.h5: it is theirs.h5, which this import reads"
fi

# no room: what was begun goes, the .xdmf of its first outputs too
sed 's/^run: .*/run: limited/' cloud.yaml >limited.yaml
size=$(stat -c %s cloud.h5)
for percent in 5 40 60 80 90; do # of what it takes: from less than the header to nearly all of it
  blocks=$((size * percent / 100 / 1024))
  (ulimit -f $blocks && "$program" import limited.yaml >log 2>&1)
  code=$?
  [ $code = 3 ] || fail "$blocks blocks: exit code $code: $(cat log)"
  [ -z "$(find . -name '*limited*' ! -name limited.yaml)" ] || fail "$blocks blocks leave $(find . -name '*limited*' ! -name limited.yaml)"
done

exit $failed
